#include "app/desktop/clipped_texts.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QFontMetrics>
#include <QHeaderView>
#include <QLabel>
#include <QStyle>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QToolButton>

namespace tessera::desktop {
namespace {

// Each gives the text that does not fit, or an empty one.
QString clippedIn(const QLabel& label) {
  if (label.text().isEmpty()) return {};
  const bool whole = label.wordWrap()
                         ? label.heightForWidth(label.width()) <= label.height() + 1
                         : label.contentsRect().width() + 1 >= label.minimumSizeHint().width() - 2 * label.margin();
  return whole ? QString{} : label.text();
}

QString clippedIn(const QAbstractButton& button) {
  if (button.text().isEmpty()) return {};
  const auto* tool = qobject_cast<const QToolButton*>(&button);
  if (tool != nullptr && tool->toolButtonStyle() == Qt::ToolButtonIconOnly && !tool->icon().isNull()) return {};
  const QString text = QString{button.text()}.remove('&');
  const QFontMetrics metrics = button.fontMetrics();
  // A push button may be narrower than it likes to be; the others have their mark or arrow beside the text.
  const int needed = button.inherits("QPushButton") ? metrics.horizontalAdvance(text) : button.sizeHint().width();
  return needed <= button.width() && button.height() + 1 >= metrics.height() ? QString{} : text;
}

QString clippedIn(const QComboBox& combo) {
  if (combo.isEditable()) return {};
  QStyleOptionComboBox option;
  option.initFrom(&combo);
  const QFontMetrics metrics = combo.fontMetrics();
  const QSize bare{metrics.boundingRect(combo.currentText()).width(), metrics.height()};
  const QSize needed = combo.style()->sizeFromContents(QStyle::CT_ComboBox, &option, bare, &combo);
  return needed.width() <= combo.width() ? QString{} : combo.currentText();
}

QString clippedIn(const QHeaderView& header) {
  for (int n = 0; n < header.count(); ++n) {
    const QString title = header.model()->headerData(n, header.orientation()).toString();
    if (!header.isSectionHidden(n) && header.fontMetrics().horizontalAdvance(title) > header.sectionSize(n))
      return title;
  }
  return {};
}

// Tabs that have no room left may wait behind the bar's arrows, each of them whole; the one in front is seen whole.
QString clippedIn(const QTabBar& bar) {
  for (int n = 0; n < bar.count(); ++n) {
    const QRect tab = bar.tabRect(n);
    const QString text = QString{bar.tabText(n)}.remove('&');
    const int sign = bar.tabIcon(n).isNull() ? 0 : bar.iconSize().width();
    if (!bar.isTabVisible(n)) continue;
    if (bar.fontMetrics().horizontalAdvance(text) + sign > tab.width()) return text;
    if (n == bar.currentIndex() && !bar.rect().contains(tab)) return text;
  }
  return {};
}

QString clippedIn(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return clippedIn(*label);
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return clippedIn(*button);
  if (const auto* combo = qobject_cast<const QComboBox*>(&widget)) return clippedIn(*combo);
  if (const auto* header = qobject_cast<const QHeaderView*>(&widget)) return clippedIn(*header);
  if (const auto* tabs = qobject_cast<const QTabBar*>(&widget)) return clippedIn(*tabs);
  return {};
}

}  // namespace

QStringList clippedTexts(const QWidget& root) {
  QStringList clipped;
  for (const QWidget* widget : root.findChildren<QWidget*>()) {
    if (!widget->isVisibleTo(&root) || widget->visibleRegion().isEmpty()) continue;
    if (const QString text = clippedIn(*widget); !text.isEmpty())
      clipped << QStringLiteral("%1 “%2”").arg(widget->objectName(), text);
  }
  return clipped;
}

}  // namespace tessera::desktop
