#include "ui/connect/radio_dialog.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "ui/connect/fit_height.h"
#include "ui/connect/radio_rows.h"

namespace tessera::ui {

RadioDialog::RadioDialog(RadioBench& bench, const floor::RadioSetup& site, QWidget* parent)
    : QDialog{parent}, bench_{bench}, site_{site} {
  setObjectName(QStringLiteral("radioDialog"));
  setProperty("helpTopic", QStringLiteral("radio"));
  table_.setObjectName(QStringLiteral("radioTable"));
  power_.setObjectName(QStringLiteral("powerField"));
  read_.setObjectName(QStringLiteral("readModule"));
  write_.setObjectName(QStringLiteral("writeModule"));
  cancel_.setObjectName(QStringLiteral("cancelModule"));
  result_.setObjectName(QStringLiteral("radioResult"));
  advice_.setObjectName(QStringLiteral("radioAdvice"));
  for (int i = 0; i < 4; ++i) power_.addItem(QString{}, i);
  buttons_.setStandardButtons(QDialogButtonBox::Close);
  progress_.setRange(0, 0);
  progress_.setTextVisible(false);
  layOut();

  connect(&read_, &QPushButton::clicked, this, [this] {
    begin(Work::Reading);
    bench_.read();
  });
  connect(&write_, &QPushButton::clicked, this, [this] {
    begin(Work::Writing);
    bench_.write(wanted());
  });
  connect(&cancel_, &QPushButton::clicked, this, [this] {
    bench_.cancel();
    end();
    result_.show(Notice::Tone::Info, tr("Cancelled. What the module now holds is told by Read."));
  });
  connect(&power_, &QComboBox::currentIndexChanged, this, &RadioDialog::fill);
  connect(&bench_, &RadioBench::found, this, &RadioDialog::showFound);
  connect(&bench_, &RadioBench::failed, this, &RadioDialog::showFailed);
  connect(&buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  end();
  retranslate();
  new FitHeight{*this, fontMetrics().height() * 40};
}

void RadioDialog::layOut() {
  const int line = fontMetrics().height();
  steps_.setWordWrap(true);
  steps_.setTextFormat(Qt::RichText);
  steps_.setMinimumWidth(line * 24);
  powerHint_.setWordWrap(true);
  powerHint_.setForegroundRole(QPalette::PlaceholderText);
  powerLabel_.setBuddy(&power_);
  power_.setSizeAdjustPolicy(QComboBox::AdjustToContents);  // its texts change with the language
  table_.setColumnCount(3);
  table_.verticalHeader()->hide();
  table_.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_.setSelectionMode(QAbstractItemView::NoSelection);
  table_.setFocusPolicy(Qt::NoFocus);
  table_.horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_.setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  table_.verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  for (QPushButton* button : {&read_, &write_, &cancel_}) button->setAutoDefault(false);

  auto* top = new QHBoxLayout;
  top->addWidget(&steps_, 1);
  top->addWidget(&off_);
  top->addWidget(&on_);
  auto* power = new QHBoxLayout;
  power->addWidget(&powerLabel_);
  power->addWidget(&power_);
  power->addWidget(&powerHint_, 1);
  auto* work = new QHBoxLayout;
  work->addWidget(&read_);
  work->addWidget(&write_);
  work->addWidget(&progress_, 1);
  work->addWidget(&cancel_);
  work->addStretch();
  auto* column = new QVBoxLayout{this};
  column->addWidget(&advice_);
  column->addLayout(top);
  column->addLayout(power);
  column->addLayout(work);
  column->addWidget(&table_);
  column->addWidget(&result_);
  column->addStretch();
  column->addWidget(&buttons_);
}

link::E32Parameters RadioDialog::wanted() const { return RadioRows::wanted(site_, power_.currentData().toInt()); }

void RadioDialog::setAdvice(const QStringList& sentences) {
  advice_.show(Notice::Tone::Warning, sentences.join(QLatin1Char('\n')));
}

void RadioDialog::begin(Work work) {
  work_ = work;
  result_.show(Notice::Tone::Info, work == Work::Reading ? tr("Reading the module's parameters…")
                                                         : tr("Writing the site's parameters and reading them back…"));
  read_.setEnabled(false);
  write_.setEnabled(false);
  power_.setEnabled(false);
  progress_.show();
  cancel_.show();
}

void RadioDialog::end() {
  work_ = Work::None;
  read_.setEnabled(true);
  write_.setEnabled(true);
  power_.setEnabled(true);
  progress_.hide();
  cancel_.hide();
}

void RadioDialog::showFound(const link::E32Parameters& parameters) {
  if (work_ == Work::None) return;  // the answer to something that was cancelled
  const bool wrote = work_ == Work::Writing;
  const bool first = !module_ && !wrote;
  module_ = parameters;
  end();
  if (first) power_.setCurrentIndex(power_.findData(parameters.power));
  fill();
  int different = 0;
  for (const RadioRow& row : RadioRows::compare(module_, wanted())) different += row.differs ? 1 : 0;
  if (wrote && different == 0)
    result_.show(Notice::Tone::Good, tr("Written and read back. Put both jumpers on again, then connect."));
  else if (wrote)
    result_.show(Notice::Tone::Error, tr("The module did not keep %n parameter(s). Write once more; if that does not "
                                         "help, the module may be of another kind or broken.",
                                         nullptr, different));
  else if (different == 0)
    result_.show(Notice::Tone::Good,
                 tr("The module is set as the site asks. Put both jumpers on again, then connect."));
  else
    result_.show(Notice::Tone::Warning, tr("%n parameter(s) differ from the site's; vehicles will not be heard like "
                                           "this. Press “Write the site's parameters”.",
                                           nullptr, different));
}

void RadioDialog::showFailed(const QString& sentence) {
  if (work_ == Work::None) return;
  end();
  result_.show(Notice::Tone::Error, sentence);
}

void RadioDialog::fill() {
  const auto rows = RadioRows::compare(module_, wanted());
  table_.setRowCount(static_cast<int>(rows.size()));
  QColor mark{0xdc, 0x35, 0x45};
  mark.setAlphaF(0.25F);
  for (int i = 0; i < table_.rowCount(); ++i) {
    const RadioRow& row = rows[static_cast<std::size_t>(i)];
    const QString module = row.module.isEmpty() ? tr("not read yet")
                           : row.differs        ? tr("%1 – differs").arg(row.module)
                                                : row.module;
    int column = 0;
    for (const QString& text : {row.name, module, row.site}) {
      auto* item = new QTableWidgetItem{text};
      if (column == 1 && row.module.isEmpty()) item->setForeground(palette().brush(QPalette::PlaceholderText));
      if (row.differs) item->setBackground(mark);
      table_.setItem(i, column++, item);
    }
  }
  table_.resizeRowsToContents();
  table_.setFixedHeight(table_.verticalHeader()->length() + table_.horizontalHeader()->sizeHint().height() +
                        2 * table_.frameWidth());
}

void RadioDialog::done(int result) {
  if (work_ != Work::None) {
    bench_.cancel();
    end();
    result_.clear();
  }
  QDialog::done(result);
}

void RadioDialog::retranslate() {
  setWindowTitle(tr("Radio module of this computer"));
  steps_.setText(
      tr("<p>This computer's radio module (E32-TTL-100) must be set like those of the vehicles. To read or write its "
         "settings:</p><ol><li>Take both jumpers, M0 and M1, off the module's adapter.</li><li>Press “Read the "
         "module”. Driving vehicles are stopped first.</li><li>Where something differs, press “Write the site's "
         "parameters”.</li><li>Put both jumpers back on.</li></ol>"));
  table_.setAccessibleName(tr("Parameters of the module and of the site"));
  table_.setHorizontalHeaderLabels({tr("Parameter"), tr("Module"), tr("Site")});
  powerLabel_.setText(tr("&Transmit power:"));
  for (int i = 0; i < power_.count(); ++i) power_.setItemText(i, RadioRows::powerText(i));
  powerHint_.setText(tr("Choose what the rules of your country allow; the vehicles do not mind."));
  read_.setText(tr("&Read the module"));
  write_.setText(tr("&Write the site's parameters"));
  cancel_.setText(tr("Cancel"));
  progress_.setAccessibleName(tr("Work on the radio module"));
  buttons_.button(QDialogButtonBox::Close)->setText(tr("Close"));
  fill();
}

void RadioDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

}  // namespace tessera::ui
