#include "ui/register/setup_page.h"

#include <QCompleter>
#include <QEvent>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLocale>
#include <QStringListModel>
#include <QVBoxLayout>

#include "ui/base/icon.h"
#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

constexpr int kKeyboard = 0;
constexpr int kReaderBauds[] = {9600, 19200, 38400, 57600, 115200};
constexpr std::size_t kMostOffered = 5000;  // tiles that the field completes

void shrinkable(QComboBox& box) {
  box.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  box.setMinimumWidth(box.fontMetrics().height() * 5);
}

// The words of a list in another language; what is chosen stays.
void setItems(QComboBox& box, const QStringList& items) {
  const int chosen = std::max(0, box.currentIndex());
  const QSignalBlocker quiet{&box};
  box.clear();
  box.addItems(items);
  box.setCurrentIndex(chosen);
}

}  // namespace

SetupPage::SetupPage(Registrar& registrar, QWidget* parent) : QWidget{parent}, registrar_{registrar} {
  setObjectName(QStringLiteral("registerSetup"));
  build();
  retranslate();
  const ReaderChoice reader = registrar_.memory().reader();
  reader_.setCurrentIndex(reader.keyboard ? kKeyboard : kKeyboard + 1);
  port_.setEditText(reader.port);
  baud_.setCurrentIndex(std::max(0, baud_.findData(reader.baud)));
  form_.setCurrentIndex(static_cast<int>(reader.form));
  sounds_.setChecked(reader.sounds);
  connect(&reader_, &QComboBox::currentIndexChanged, this, &SetupPage::showWays);
  connect(&port_, &QComboBox::editTextChanged, this, &SetupPage::showWays);
  connect(&one_, &QCheckBox::toggled, this, [this](bool on) {
    showWays();
    if (on) tile_.setFocus();
  });
  connect(&tile_, &QLineEdit::textChanged, this, &SetupPage::showWays);
  connect(&refreshPorts_, &QToolButton::clicked, this, &SetupPage::fillPorts);
  connect(&clearTile_, &QPushButton::clicked, this, &SetupPage::clearTile);
  connect(&start_, &QPushButton::clicked, this, [this] { start(false); });
  connect(&goOn_, &QPushButton::clicked, this, [this] { start(true); });
  connect(&registrar_.document(), &SiteDocument::changed, this, &SetupPage::showWays);
  refresh();
}

void SetupPage::build() {
  intro_.setWordWrap(true);
  goOnText_.setWordWrap(true);
  const std::pair<QObject*, const char*> names[] = {{&reader_, "scanReader"},      {&port_, "scanPort"},
                                                    {&baud_, "scanBaud"},          {&form_, "scanForm"},
                                                    {&order_, "scanOrder"},        {&one_, "scanOneTile"},
                                                    {&tile_, "scanTile"},          {&again_, "scanAgain"},
                                                    {&sounds_, "scanSounds"},      {&start_, "startScan"},
                                                    {&goOn_, "goOnScanning"},      {&clearTile_, "clearTileTags"},
                                                    {&notice_, "scanSetupNotice"}, {&refreshPorts_, "scanRefreshPorts"},
                                                    {&goOnText_, "goOnText"}};
  for (const auto& [object, name] : names) object->setObjectName(QString::fromLatin1(name));
  for (QComboBox* box : {&reader_, &port_, &baud_, &form_, &order_}) shrinkable(*box);
  port_.setEditable(true);
  port_.setInsertPolicy(QComboBox::NoInsert);
  for (const int baud : kReaderBauds) baud_.addItem(QString{}, baud);
  refreshPorts_.setIcon(icon(QStringLiteral("refresh")));
  clearTile_.setIcon(icon(QStringLiteral("clear")));
  start_.setIcon(icon(QStringLiteral("run")));
  goOn_.setIcon(icon(QStringLiteral("resume")));
  auto* completer = new QCompleter{new QStringListModel{this}, this};
  completer->setCaseSensitivity(Qt::CaseInsensitive);
  tile_.setCompleter(completer);
  tile_.setMinimumWidth(tile_.fontMetrics().height() * 4);

  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  auto* portRow = new QHBoxLayout;
  portRow->addWidget(&port_, 1);
  portRow->addWidget(&refreshPorts_);
  form->addRow(&readerLabel_, &reader_);
  form->addRow(&portLabel_, portRow);
  form->addRow(&baudLabel_, &baud_);
  form->addRow(&formLabel_, &form_);
  form->addRow(&orderLabel_, &order_);
  auto* tileRow = new QHBoxLayout;
  tileRow->addWidget(&tile_, 1);
  tileRow->addWidget(&clearTile_);
  auto* column = new QVBoxLayout{this};
  column->addWidget(&intro_);
  column->addWidget(&goOnText_);
  column->addWidget(&goOn_);
  column->addLayout(form);
  column->addWidget(&one_);
  column->addLayout(tileRow);
  column->addWidget(&again_);
  column->addWidget(&sounds_);
  column->addWidget(&notice_);
  column->addWidget(&start_);
  column->addStretch();
}

void SetupPage::refresh() {
  fillPorts();
  QStringList serials;
  for (const floor::Tile& tile : registrar_.document().site().tiles) {
    if (static_cast<std::size_t>(serials.size()) == kMostOffered) break;
    serials << QString::fromStdString(tile.serial);
  }
  qobject_cast<QStringListModel*>(tile_.completer()->model())->setStringList(serials);
  showWays();
}

void SetupPage::setTile(const QString& serial) {
  one_.setChecked(true);
  tile_.setText(serial);
}

void SetupPage::fillPorts() {
  const QString text = port_.currentText();
  const QSignalBlocker quiet{&port_};
  port_.clear();
  for (const PortFound& p : registrar_.bench().ports()) port_.addItem(p.name);
  port_.setEditText(text.isEmpty() && port_.count() > 0 ? port_.itemText(0) : text);
}

void SetupPage::showWays() {
  if (registrar_.state() != Registrar::State::Idle) return;  // nobody sees it
  const bool keyboard = reader_.currentIndex() == kKeyboard;
  for (QWidget* w : std::initializer_list<QWidget*>{&portLabel_, &port_, &refreshPorts_, &baudLabel_, &baud_})
    w->setEnabled(!keyboard);
  const floor::Site& site = registrar_.document().site();
  const floor::Tile* tile = one_.isChecked() ? tileOf(site, serial().toStdString()) : nullptr;
  tile_.setEnabled(one_.isChecked());
  again_.setEnabled(one_.isChecked() ? tile != nullptr : !site.tiles.empty());
  clearTile_.setEnabled(tile != nullptr && !tile->uids.empty());

  QString trouble;
  if (site.tiles.empty())
    trouble = tr("The site has no tiles yet. Lay them first.");
  else if (!keyboard && port_.currentText().trimmed().isEmpty())
    trouble = tr("Choose the reader's port, or type its path.");
  else if (one_.isChecked() && serial().isEmpty())
    trouble = tr("Type the serial number of the tile.");
  else if (one_.isChecked() && tile == nullptr)
    trouble = tr("The site has no tile %1.").arg(serial());
  notice_.show(Notice::Tone::Warning, trouble);
  start_.setEnabled(trouble.isEmpty());

  const auto stop = whereToGoOn();
  const bool left = stop.has_value();
  goOn_.setVisible(left);
  goOnText_.setVisible(left);
  goOn_.setEnabled(!site.tiles.empty() && (keyboard || !port_.currentText().trimmed().isEmpty()));
  if (left)
    goOnText_.setText(tr("Registering stopped at tag %1 of tile %2.")
                          .arg(QString::number(stop->tag + 1), QString::fromStdString(stop->serial)));
}

// Where registering stopped, or where that place was filled meanwhile, by an import say, the next one that is open.
std::optional<scan::PlaceName> SetupPage::whereToGoOn() const {
  const floor::Site& site = registrar_.document().site();
  const auto course = registrar_.memory().course();
  const floor::Tile* tile = course && course->at ? tileOf(site, course->at->serial) : nullptr;
  if (tile == nullptr) return std::nullopt;
  const bool filled = course->at->tag < tile->uids.size() && !tile->uids[course->at->tag].empty();
  if (!filled || course->again) return course->at;
  return scan::Registration{registrar_.document().map(), *course}.course().at;
}

ReaderChoice SetupPage::chosen() const {
  ReaderChoice reader;
  reader.keyboard = reader_.currentIndex() == kKeyboard;
  reader.port = port_.currentText().trimmed();
  reader.baud = baud_.currentData().toInt();
  reader.form = static_cast<scan::ReaderForm>(std::max(0, form_.currentIndex()));
  reader.sounds = sounds_.isChecked();
  return reader;
}

void SetupPage::start(bool goOn) {
  if (const auto course = registrar_.memory().course(); goOn && course) {
    Q_EMIT startRequested(*course, chosen());
    return;
  }
  scan::Course course;
  course.order = static_cast<scan::WalkOrder>(std::max(0, order_.currentIndex()));
  if (one_.isChecked()) course.tile = serial().toStdString();
  course.again = again_.isEnabled() && again_.isChecked();
  Q_EMIT startRequested(course, chosen());
}

void SetupPage::clearTile() {
  const auto done = registrar_.edits().clear(serial());
  if (!done) return notice_.show(Notice::Tone::Error, text(done.error().sentence));
  notice_.show(Notice::Tone::Info,
               tr("No tag of tile %1 is registered any more. Undo brings them back.").arg(serial()));
}

void SetupPage::retranslate() {
  intro_.setText(tr("Hold the tags of the floor to a reader, one after the other, as the map lights them."));
  readerLabel_.setText(tr("Reader:"));
  setItems(reader_, {tr("Types like a keyboard"), tr("At a serial port")});
  portLabel_.setText(tr("Port:"));
  port_.setAccessibleName(tr("The reader's port"));
  refreshPorts_.setAccessibleName(tr("Look for ports again"));
  refreshPorts_.setToolTip(tr("Look for ports again"));
  baudLabel_.setText(tr("Baud rate:"));
  for (int i = 0; i < baud_.count(); ++i)
    baud_.setItemText(i, tr("%1 bit/s").arg(QLocale{}.toString(baud_.itemData(i).toInt())));
  formLabel_.setText(tr("It sends:"));
  setItems(form_, {tr("Hexadecimal lines"), tr("Decimal lines"), tr("Decimal lines, bytes reversed"),
                   tr("Frames of an MFRC522 module")});
  orderLabel_.setText(tr("Order:"));
  setItems(order_, {tr("Tile by tile along the floor"), tr("Tile by tile as listed, also not laid ones"),
                    tr("Row by row of tags")});
  one_.setText(tr("One tile alone"));
  tile_.setPlaceholderText(tr("serial number"));
  tile_.setAccessibleName(tr("Serial number of the tile"));
  clearTile_.setText(tr("Clear"));
  clearTile_.setToolTip(tr("Forget which tags this tile has"));
  again_.setText(tr("Also tags that are registered already"));
  sounds_.setText(tr("Sounds"));
  start_.setText(tr("Start"));
  goOn_.setText(tr("Go on from there"));
  showWays();
}

void SetupPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
