#include "ui/check/fault_panel.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QItemSelectionModel>
#include <QLabel>
#include <QListView>
#include <QMenu>
#include <QStackedWidget>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/icon.h"
#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

using sitecheck::Fault;
using sitecheck::Severity;

SiteBox boxOf(const Box& place) { return {place.low, place.high}; }

bool isOf(const Fault& fault, const QString& route) {
  return !fault.objects.empty() && fault.objects.front().kind == sitecheck::ObjectKind::Route &&
         QString::fromStdString(fault.objects.front().name) == route;
}

}  // namespace

FaultPanel::FaultPanel(SiteDocument& document, FaultWatch& watch, QWidget* parent)
    : QWidget{parent}, document_{document}, watch_{watch}, model_{new FaultModel{this}} {
  setObjectName("faultPanel");
  pages_ = new QStackedWidget;
  list_ = new QListView;
  list_->setObjectName("faultList");
  list_->setModel(model_);
  list_->setWordWrap(true);
  list_->setResizeMode(QListView::Adjust);
  list_->setUniformItemSizes(false);
  list_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(list_, &QListView::customContextMenuRequested, this, [this](QPoint at) {
    // The menu key asks for it in the middle of the chosen row, or somewhere beside it.
    const QModelIndex under = list_->indexAt(at);
    if (QMenu* menu = menuOf(under.isValid() ? under.row() : currentRow(), true))
      menu->popup(list_->viewport()->mapToGlobal(at));
  });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, [this] {
    refreshActions();
    if (!filling_) Q_EMIT changed();
  });
  connect(list_, &QListView::clicked, this, [this](const QModelIndex& index) { goTo(index.row()); });
  connect(list_, &QListView::activated, this, [this](const QModelIndex& index) { goTo(index.row()); });
  empty_ = new QLabel;
  empty_->setObjectName("noFaults");
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  pages_->addWidget(empty_);
  pages_->addWidget(list_);
  auto* layout = new QVBoxLayout{this};
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(makeBar());
  layout->addWidget(pages_, 1);
  layout->addWidget(makeClearance());
  connect(&watch_, &FaultWatch::changed, this, &FaultPanel::refresh);
  retranslate();
  refresh();
}

QWidget* FaultPanel::makeBar() {
  const auto make = [this](const char* name, const char* picture, bool checkable) {
    auto* action = new QAction{icon(picture), {}, this};
    action->setObjectName(name);
    action->setCheckable(checkable);
    action->setChecked(checkable);
    return action;
  };
  errors_ = make("showErrors", "error", true);
  warnings_ = make("showWarnings", "warning", true);
  show_ = make("showFault", "place", false);
  mend_ = make("mendFault", "wizard", false);
  mend_->setShortcut(Qt::CTRL | Qt::Key_Return);
  mend_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  connect(errors_, &QAction::toggled, this, &FaultPanel::filter);
  connect(warnings_, &QAction::toggled, this, &FaultPanel::filter);
  connect(show_, &QAction::triggered, this, [this] { goTo(currentRow()); });
  connect(mend_, &QAction::triggered, this, [this] {
    if (const int row = currentRow(); row >= 0) mend(model_->fault(row));
  });
  addAction(mend_);
  auto* bar = new QToolBar;
  const int side = fontMetrics().height() + 2;
  bar->setIconSize({side, side});
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  bar->addActions({errors_, warnings_});
  bar->addSeparator();
  bar->addActions({show_, mend_});
  state_ = new QLabel;
  state_->setObjectName("checkState");
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout{row};
  layout->setContentsMargins(0, 0, fontMetrics().height() / 2, 0);
  layout->addWidget(bar, 1);
  layout->addWidget(state_);
  return row;
}

QWidget* FaultPanel::makeClearance() {
  clearance_ = new QDoubleSpinBox;
  clearance_->setObjectName("clearance");
  clearance_->setDecimals(2);
  clearance_->setRange(0.0, 2.0);
  clearance_->setSingleStep(0.05);
  clearance_->setKeyboardTracking(false);  // while somebody types, the site is not checked for each digit
  connect(clearance_, &QDoubleSpinBox::valueChanged, this, [this](double metres) {
    watch_.setClearance(Metres{metres});
    Q_EMIT clearanceChosen(Metres{metres});
  });
  clearanceLabel_ = new QLabel;
  clearanceLabel_->setBuddy(clearance_);
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout{row};
  const int side = fontMetrics().height() / 3;
  layout->setContentsMargins(2 * side, side, 2 * side, side);
  layout->addWidget(clearanceLabel_);
  layout->addWidget(clearance_);
  layout->addStretch(1);
  return row;
}

void FaultPanel::setClearance(Metres clearance) { clearance_->setValue(clearance.value()); }

int FaultPanel::currentRow() const { return list_->currentIndex().isValid() ? list_->currentIndex().row() : -1; }

void FaultPanel::choose(int row) {
  list_->setCurrentIndex(row >= 0 && row < model_->rowCount() ? model_->index(row) : QModelIndex{});
}

void FaultPanel::filter() {
  filling_ = true;
  const auto chosen = currentRow() >= 0 ? std::optional<Fault>{model_->fault(currentRow())} : std::nullopt;
  model_->setShown(errors_->isChecked(), warnings_->isChecked());
  if (chosen) choose(model_->rowOf(*chosen));
  filling_ = false;
  refresh();
}

void FaultPanel::refresh() {
  filling_ = true;
  const int row = currentRow();
  const auto chosen = row >= 0 ? std::optional<Fault>{model_->fault(row)} : std::nullopt;
  model_->setVerdict(watch_.verdict());
  if (chosen) choose(model_->rowOf(*chosen));
  filling_ = false;
  const bool first = watch_.isChecking() && watch_.verdict().size() == 0;
  state_->setText(watch_.isChecking() ? tr("Checking…") : QString{});
  empty_->setText(first                          ? tr("The site is being checked…")
                  : watch_.verdict().size() == 0 ? tr("No faults found.")
                                                 : tr("Faults of the other kind are hidden."));
  pages_->setCurrentWidget(model_->rowCount() == 0 ? static_cast<QWidget*>(empty_) : list_);
  retranslate();
  refreshActions();
  Q_EMIT changed();
}

void FaultPanel::refreshActions() {
  const int row = currentRow();
  const Fault* fault = row >= 0 ? &model_->fault(row) : nullptr;
  show_->setEnabled(fault != nullptr && fault->place);
  mend_->setEnabled(fault != nullptr && fault->fix);
  mend_->setToolTip(fault == nullptr ? tr("For some faults there is an edit that mends them.")
                    : fault->fix     ? text(fault->fix->sentence)
                                     : tr("No single edit mends this fault."));
}

void FaultPanel::goTo(int row) {
  if (row < 0 || row >= model_->rowCount()) return;
  choose(row);
  if (const auto& place = model_->fault(row).place) Q_EMIT placeWanted(boxOf(*place));
}

QMenu* FaultPanel::menuOf(int row, bool inList) {
  if (row < 0 || row >= model_->rowCount()) return nullptr;
  // By value: the verdict may be another before somebody has chosen.
  const Fault fault = model_->fault(row);
  const auto stillHere = [this, fault](const auto& act) { return [this, fault, act] { act(model_->rowOf(fault)); }; };
  auto* menu = new QMenu{this};
  menu->setObjectName("faultMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QString order = fault.fix ? text(fault.fix->sentence) : tr("No single edit mends this fault");
  order.replace(QLatin1Char{'&'}, QLatin1String{"&&"});
  menu->addAction(mend_->icon(), order, this, [this, fault] { mend(fault); })->setEnabled(fault.fix.has_value());
  menu->addAction(show_->icon(), tr("&Go there"), this, stillHere([this](int now) { goTo(now); }))
      ->setEnabled(fault.place.has_value());
  if (inList) return menu;
  menu->addAction(icon(QStringLiteral("error")), tr("Show in &list"), this, stillHere([this](int now) {
                    choose(now);
                    Q_EMIT listWanted();
                    list_->setFocus();
                  }));
  return menu;
}

void FaultPanel::mend(const Fault& fault) {
  if (!fault.fix) return;
  const sitecheck::Fix fix = *fault.fix;
  bool fits = false;
  const auto done =
      document_.edit(text(fix.sentence), [&](floor::Site& site) { fits = sitecheck::mend(fix.edit, site); });
  if (!done) {
    Q_EMIT refused(text(done.error().sentence));
  } else if (!fits) {
    Q_EMIT refused(tr("The site has changed meanwhile: nothing was mended."));
  }
}

QString FaultPanel::title() const {
  const auto count = watch_.verdict().size();
  return count == 0 ? tr("Faults") : tr("Faults (%1)").arg(count);
}

QString FaultPanel::summary() const {
  const auto errors = static_cast<int>(watch_.verdict().count(Severity::Error));
  const auto warnings = static_cast<int>(watch_.verdict().count(Severity::Warning));
  if (watch_.isChecking() && errors + warnings == 0) return tr("Checking…");
  if (errors + warnings == 0) return tr("No faults");
  if (warnings == 0) return tr("%n error(s)", nullptr, errors);
  if (errors == 0) return tr("%n warning(s)", nullptr, warnings);
  return tr("%1, %2", "errors, warnings")
      .arg(tr("%n error(s)", nullptr, errors), tr("%n warning(s)", nullptr, warnings));
}

QString FaultPanel::summaryIcon() const {
  if (watch_.verdict().count(Severity::Error) > 0) return QStringLiteral("error");
  return watch_.verdict().size() > 0 ? QStringLiteral("warning") : QStringLiteral("check");
}

std::vector<FloorMark> FaultPanel::marks(std::optional<std::size_t>& chosen, const QString& route) const {
  std::vector<FloorMark> all;
  chosen.reset();
  for (int row = 0; row < model_->rowCount(); ++row) {
    const Fault& fault = model_->fault(row);
    if (!fault.place || (!route.isEmpty() && !isOf(fault, route))) continue;
    if (row == currentRow()) chosen = all.size();
    all.push_back({boxOf(*fault.place), fault.severity == Severity::Error, text(fault.sentence), row});
  }
  return all;
}

void FaultPanel::retranslate() {
  errors_->setText(tr("Errors (%1)").arg(watch_.verdict().count(Severity::Error)));
  warnings_->setText(tr("Warnings (%1)").arg(watch_.verdict().count(Severity::Warning)));
  errors_->setToolTip(tr("List what keeps the site from being used, or leads vehicles wrongly"));
  warnings_->setToolTip(tr("List what somebody should look at"));
  show_->setText(tr("&Show"));
  show_->setToolTip(tr("Show the place on the floor (Enter)"));
  mend_->setText(tr("&Mend"));
  clearanceLabel_->setText(tr("Room aro&und vehicles:"));
  clearance_->setSuffix(tr(" m"));
  clearance_->setToolTip(
      tr("On a route a vehicle’s outline, with that much room all around, must not stick out of the zones in which it "
         "may be."));
  list_->setAccessibleName(tr("Faults of the site"));
}

void FaultPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange) {
    model_->retranslate();
    refresh();
  }
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
