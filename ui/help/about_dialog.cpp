#include "ui/help/about_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QFile>
#include <QFontDatabase>
#include <QHeaderView>
#include <QSysInfo>
#include <QVBoxLayout>

#include "ui/base/icon.h"
#include "ui/help/third_parties.h"

namespace tessera::ui {

AboutDialog::AboutDialog(QWidget* parent, const QString& sqliteVersion)
    : QDialog{parent}, sqliteVersion_{sqliteVersion} {
  setObjectName(QStringLiteral("aboutDialog"));
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.8);
  large.setBold(true);
  name_.setFont(large);
  version_.setTextInteractionFlags(Qt::TextSelectableByMouse);
  sentence_.setWordWrap(true);
  parts_.setObjectName(QStringLiteral("aboutParts"));
  parts_.setColumnCount(4);
  parts_.verticalHeader()->hide();
  parts_.setEditTriggers(QAbstractItemView::NoEditTriggers);
  parts_.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  parts_.horizontalHeader()->setStretchLastSection(true);
  licence_.setObjectName(QStringLiteral("licenceText"));
  licence_.setReadOnly(true);
  licence_.setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  if (QFile file{QStringLiteral(":/licence/LICENSE")}; file.open(QIODevice::ReadOnly))
    licence_.setPlainText(QString::fromUtf8(file.readAll()));
  tabs_.addTab(&parts_, QString{});
  tabs_.addTab(&licence_, QString{});
  copy_.setObjectName(QStringLiteral("copyAbout"));
  copy_.setIcon(icon(QStringLiteral("copy")));
  copy_.setAutoDefault(false);
  buttons_.setStandardButtons(QDialogButtonBox::Close);
  buttons_.addButton(&copy_, QDialogButtonBox::ActionRole);

  auto* column = new QVBoxLayout{this};
  column->addWidget(&name_);
  column->addWidget(&version_);
  column->addWidget(&sentence_);
  column->addSpacing(fontMetrics().height() / 2);
  column->addWidget(&tabs_, 1);
  column->addWidget(&buttons_);
  connect(&copy_, &QPushButton::clicked, this, [this] { QApplication::clipboard()->setText(report()); });
  connect(&buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  retranslate();
  const int line = fontMetrics().height();
  resize(line * 46, line * 30);
}

QString AboutDialog::report() const {
  QString text = QStringLiteral("Tessera %1\n%2, %3, %4\n")
                     .arg(ThirdParties::programVersion(), QSysInfo::prettyProductName(),
                          QSysInfo::currentCpuArchitecture(), QApplication::platformName());
  for (const ThirdParty& part : ThirdParties::all(sqliteVersion_))
    if (!part.version.isEmpty()) text += QStringLiteral("%1 %2\n").arg(part.name, part.version);
  return text;
}

void AboutDialog::fill() {
  const auto all = ThirdParties::all(sqliteVersion_);
  parts_.setRowCount(static_cast<int>(all.size()));
  for (int row = 0; row < parts_.rowCount(); ++row) {
    const ThirdParty& part = all[static_cast<std::size_t>(row)];
    int column = 0;
    for (const QString& value : {part.name, part.version, part.licence, part.use})
      parts_.setItem(row, column++, new QTableWidgetItem{value});
  }
}

void AboutDialog::retranslate() {
  setWindowTitle(tr("About Tessera"));
  name_.setText(tr("Tessera"));
  version_.setText(tr("Version %1").arg(ThirdParties::programVersion()));
  sentence_.setText(
      tr("Watches and guides automated vehicles that find their way by RFID tags in a tile floor. Free software under "
         "the GNU General Public License, version 3 or later; it comes without any warranty."));
  tabs_.setTabText(0, tr("&Made of"));
  tabs_.setTabText(1, tr("&Licence"));
  parts_.setAccessibleName(tr("Software that Tessera is made of"));
  licence_.setAccessibleName(tr("Text of the licence"));
  parts_.setHorizontalHeaderLabels({tr("Part"), tr("Version"), tr("Licence"), tr("Serves for")});
  copy_.setText(tr("&Copy versions"));
  copy_.setToolTip(tr("Copy the versions for a report"));
  buttons_.button(QDialogButtonBox::Close)->setText(tr("Close"));
  fill();
}

void AboutDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace tessera::ui
