#include "ui/site/site_dialog.h"

#include <QEvent>
#include <QFormLayout>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "floor/site_names.h"
#include "ui/base/wording.h"

namespace tessera::ui {

SiteDialog::SiteDialog(SiteDocument& document, QWidget* parent)
    : QDialog{parent},
      document_{document},
      loose_{document.site().looseTags},
      buttons_{QDialogButtonBox::Ok | QDialogButtonBox::Cancel} {
  setObjectName(QStringLiteral("siteDialog"));
  setProperty("helpTopic", QStringLiteral("floor"));
  name_.setObjectName(QStringLiteral("siteName"));
  north_.setObjectName(QStringLiteral("northToY"));
  channel_.setObjectName(QStringLiteral("radioChannel"));
  air_.setObjectName(QStringLiteral("airRate"));
  baud_.setObjectName(QStringLiteral("moduleBaud"));
  refusal_.setObjectName(QStringLiteral("siteRefusal"));
  tabs_.setObjectName(QStringLiteral("siteTabs"));
  layOut();
  fill();
  connect(&buttons_, &QDialogButtonBox::accepted, this, &SiteDialog::accept);
  connect(&buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(&channel_, &QSpinBox::valueChanged, this, &SiteDialog::showFrequency);
  connect(&loose_, &LooseTagPage::edited, &refusal_, &Notice::clear);
  connect(&name_, &QLineEdit::textChanged, &refusal_, &Notice::clear);
  retranslate();
  name_.setFocus();
}

void SiteDialog::layOut() {
  for (QLabel* hint : {&northHint_, &radioHint_}) {
    hint->setWordWrap(true);
    hint->setForegroundRole(QPalette::PlaceholderText);
    hint->setMinimumWidth(fontMetrics().height() * 22);
  }
  north_.setRange(-360.0, 360.0);
  north_.setDecimals(1);
  channel_.setRange(0, 31);
  for (const int rate : floor::kAirRates) air_.addItem({}, rate);
  for (const int baud : floor::kBauds) baud_.addItem({}, baud);
  for (QComboBox* box : {&air_, &baud_}) box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  auto* general = new QWidget;
  auto* form = new QFormLayout{general};
  const std::pair<QLabel*, QWidget*> rows[]{
      {&nameLabel_, &name_}, {&northLabel_, &north_}, {nullptr, &northHint_}, {&channelLabel_, &channel_},
      {&airLabel_, &air_},   {&baudLabel_, &baud_},   {nullptr, &radioHint_}};
  for (const auto& [label, field] : rows) {
    if (label == nullptr) {
      form->addRow(QString{}, field);
      continue;
    }
    label->setBuddy(field);
    form->addRow(label, field);
  }
  tabs_.addTab(general, QString{});
  tabs_.addTab(&loose_, QString{});
  auto* layout = new QVBoxLayout{this};
  layout->addWidget(&tabs_);
  layout->addWidget(&refusal_);
  layout->addWidget(&buttons_);
}

void SiteDialog::fill() {
  const floor::Site& site = document_.site();
  name_.setText(QString::fromStdString(site.name));
  name_.selectAll();
  north_.setValue(degrees(site.northToY));
  channel_.setValue(site.radio.channel);
  air_.setCurrentIndex(air_.findData(static_cast<int>(std::lround(site.radio.airRate))));
  baud_.setCurrentIndex(baud_.findData(site.radio.baud));
}

floor::Site SiteDialog::wanted() const {
  floor::Site site = document_.site();
  if (const QString name = name_.text().trimmed(); !name.isEmpty()) site.name = name.toStdString();
  // What nobody turned keeps all its digits.
  if (std::abs(degrees(site.northToY) - north_.value()) > 0.05) site.northToY = fromDegrees(north_.value());
  site.radio.channel = channel_.value();
  if (air_.currentIndex() >= 0) site.radio.airRate = air_.currentData().toInt();
  if (baud_.currentIndex() >= 0) site.radio.baud = baud_.currentData().toInt();
  site.looseTags = loose_.tags();
  return site;
}

void SiteDialog::accept() {
  const floor::Site site = wanted();
  if (site == document_.site()) return QDialog::accept();
  const auto done = document_.edit(tr("Change the site's properties"), [&site](floor::Site& edited) { edited = site; });
  if (done) return QDialog::accept();
  refusal_.show(Notice::Tone::Error, text(done.error().sentence));
}

void SiteDialog::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QDialog::changeEvent(event);
}

void SiteDialog::retranslate() {
  const QLocale locale;
  setWindowTitle(tr("Properties of the site"));
  tabs_.setTabText(0, tr("&General"));
  tabs_.setTabText(1, tr("&Tags without a tile"));
  nameLabel_.setText(tr("&Name:"));
  northLabel_.setText(tr("&Bearing of the y axis:"));
  north_.setSuffix(tr("°"));
  northHint_.setText(tr("Clockwise from north, as a compass shows it when held along the y axis. 0°: y points north."));
  channelLabel_.setText(tr("Radio &channel:"));
  airLabel_.setText(tr("&Air rate:"));
  baudLabel_.setText(tr("Baud rate of the &module:"));
  radioHint_.setText(
      tr("The vehicles and the radio module of this computer must be set to the same. Who is connected takes it over "
         "with the next connection."));
  for (QComboBox* box : {&air_, &baud_}) {
    for (int n = 0; n < box->count(); ++n)
      box->setItemText(n, tr("%1 bit/s").arg(locale.toString(box->itemData(n).toInt())));
  }
  buttons_.button(QDialogButtonBox::Ok)->setText(tr("OK"));
  buttons_.button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
  // A form gives a wrapped text too little height where the screen is small.
  for (QLabel* hint : {&northHint_, &radioHint_}) hint->setMinimumHeight(hint->heightForWidth(hint->minimumWidth()));
  loose_.retranslate();
  showFrequency();
}

void SiteDialog::showFrequency() { channel_.setSuffix(tr(" (%1 MHz)").arg(410 + channel_.value())); }

}  // namespace tessera::ui
