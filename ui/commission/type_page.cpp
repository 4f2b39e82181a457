#include "ui/commission/type_page.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <algorithm>
#include <utility>

#include "ui/commission/vehicle_draft.h"

namespace tessera::ui {

TypePage::TypePage(Commissioning& work, QWidget* parent) : QWizardPage{parent}, work_{work} {
  setProperty("helpTopic", QStringLiteral("commissioning"));
  preset_.setObjectName(QStringLiteral("presetField"));
  preset_.setSizeAdjustPolicy(QComboBox::AdjustToContents);
  presetLabel_.setBuddy(&preset_);
  readersLabel_.setBuddy(&readers_);
  prepare(front_, "frontField", 0.01, 10, 0.01, 3);
  prepare(rear_, "rearField", 0.01, 10, 0.01, 3);
  prepare(width_, "widthField", 0.02, 10, 0.01, 3);
  prepare(track_, "trackField", 0.05, 3, 0.01, 3);
  prepare(wheel_, "wheelField", 0.02, 1, 0.005, 4);
  prepare(speed_, "maxSpeedField", 0.01, 3, 0.05, 2);
  prepare(turn_, "maxTurnField", 0.05, 6, 0.1, 2);
  prepare(corner_, "cornerCutField", 0.0, floor::kMostCornerCut.value(), 0.01, 3);
  prepare(radius_, "readerRadiusField", 0.01, 1, 0.005, 3);
  layOut();
  connect(&preset_, &QComboBox::activated, this, &TypePage::choosePreset);
  connect(&readers_, &ReaderTable::edited, this, &TypePage::takeFields);
  retranslate();
}

void TypePage::prepare(Field& field, const char* name, double low, double high, double step, int decimals) {
  field.box.setObjectName(QLatin1String{name});
  field.box.setRange(low, high);
  field.box.setSingleStep(step);
  field.box.setDecimals(decimals);
  field.label.setBuddy(&field.box);
  connect(&field.box, &QDoubleSpinBox::valueChanged, this, &TypePage::takeFields);
}

void TypePage::layOut() {
  auto* grid = new QGridLayout;
  grid->addWidget(&presetLabel_, 0, 0);
  grid->addWidget(&preset_, 0, 1);
  int row = 1;
  for (Field* field : {&front_, &rear_, &width_, &track_, &wheel_, &speed_, &turn_, &corner_, &radius_}) {
    grid->addWidget(&field->label, row, 0);
    grid->addWidget(&field->box, row++, 1);
  }
  grid->setRowStretch(row, 1);
  auto* right = new QVBoxLayout;
  right->addWidget(&preview_, 1);
  right->addWidget(&readersLabel_);
  right->addWidget(&readers_);
  auto* row2 = new QHBoxLayout;
  row2->addLayout(grid);
  row2->addSpacing(fontMetrics().height());
  row2->addLayout(right, 1);
  auto* column = new QVBoxLayout{this};
  column->addLayout(row2, 1);
  column->addWidget(&notice_);
}

void TypePage::initializePage() {
  if (preset_.count() == 0)
    for (const VehiclePreset& preset : VehicleDraft::presets(work_.document().site())) preset_.addItem(preset.name);
  preset_.setCurrentIndex(work_.isNew() && preset_.currentIndex() < 0 ? 0 : preset_.currentIndex());
  if (!work_.isNew()) preset_.setCurrentIndex(-1);
  showDraft();
}

// Name, address, key and place stay: they are the vehicle's, not the type's.
void TypePage::choosePreset(int index) {
  const auto presets = VehicleDraft::presets(work_.document().site());
  if (index < 0 || index >= static_cast<int>(presets.size())) return;
  floor::VehicleSetup v = presets[static_cast<std::size_t>(index)].setup;
  v.id = work_.draft().id;
  v.name = work_.draft().name;
  v.key = work_.draft().key;
  v.start = work_.draft().start;
  work_.setDraft(v);
  showDraft();
}

void TypePage::showDraft() {
  const floor::VehicleSetup& v = work_.draft();
  const VehicleExtent e = VehicleDraft::extentOf(v.footprint);
  showing_ = true;
  front_.box.setValue(e.front.value());
  rear_.box.setValue(e.rear.value());
  width_.box.setValue(2 * e.side.value());
  track_.box.setValue(v.track.value());
  wheel_.box.setValue(v.wheelDiameter.value());
  speed_.box.setValue(v.maxSpeed.value());
  turn_.box.setValue(v.maxTurnRate.value());
  corner_.box.setValue(v.cornerCut.value());
  radius_.box.setValue(v.readerRadius.value());
  readers_.setReaders(v.readers);
  showing_ = false;
  preview_.setVehicle(v);
  judge(true);
}

// An outline of more than four corners, drawn elsewhere, is kept until its size is changed here.
void TypePage::takeFields() {
  if (showing_) return;
  floor::VehicleSetup v = work_.draft();
  const VehicleExtent old = VehicleDraft::extentOf(v.footprint);
  const VehicleExtent e{Metres{front_.box.value()}, Metres{rear_.box.value()}, Metres{width_.box.value() / 2}};
  const bool same =
      distance({old.front, old.rear}, {e.front, e.rear}).value() < 1e-3 && abs(old.side - e.side).value() < 1e-3;
  if (!same) v.footprint = VehicleDraft::outlineOf(e);
  v.track = Metres{track_.box.value()};
  v.wheelDiameter = Metres{wheel_.box.value()};
  v.maxSpeed = MetresPerSecond{speed_.box.value()};
  v.maxTurnRate = RadiansPerSecond{turn_.box.value()};
  v.cornerCut = Metres{corner_.box.value()};
  v.readerRadius = Metres{radius_.box.value()};
  v.readers = readers_.readers();
  work_.setDraft(v);
  preview_.setVehicle(v);
  judge(false);
}

// The wizard shows the page anew when it is told, and its fields then end what is just being typed into them.
void TypePage::judge(bool tell) {
  notice_.show(Notice::Tone::Warning, complaint());
  const bool was = std::exchange(complete_, isComplete());
  if (was != complete_ || tell) Q_EMIT completeChanged();
}

QString TypePage::complaint() const {
  const floor::VehicleSetup& v = work_.draft();
  if (v.readers.empty()) return tr("A vehicle needs at least one reader.");
  const VehicleExtent e = VehicleDraft::extentOf(v.footprint);
  if (v.track > 2.0 * e.side) return tr("The wheels stand wider than the vehicle. Check track and width.");
  const bool ordered =
      std::is_sorted(v.readers.begin(), v.readers.end(), [](const Offset& a, const Offset& b) { return a.y > b.y; });
  if (!ordered) return tr("The readers must be listed from the vehicle's left to its right.");
  return {};
}

bool TypePage::isComplete() const { return complaint().isEmpty(); }

void TypePage::retranslate() {
  setTitle(tr("What kind of vehicle is it?"));
  setSubTitle(
      tr("Choose the type that comes closest and correct its measures. Lengths count from the middle between "
         "the driven wheels."));
  presetLabel_.setText(tr("&Type:"));
  preset_.setPlaceholderText(tr("as it is"));
  front_.label.setText(tr("To the &front:"));
  rear_.label.setText(tr("To the &rear:"));
  width_.label.setText(tr("&Width:"));
  track_.label.setText(tr("Tr&ack (wheel to wheel):"));
  wheel_.label.setText(tr("Wheel &diameter:"));
  speed_.label.setText(tr("&Highest speed:"));
  turn_.label.setText(tr("Highest t&urn rate:"));
  corner_.label.setText(tr("Cut c&orners by:"));
  corner_.box.setSpecialValueText(tr("0 m: turns on the spot"));
  const QString corner =
      tr("How far it may leave a route's vertex to round the corner without stopping. 0: it drives to the vertex and "
         "turns on the spot, as it does all the same where the way turns nearly back or there is no room for an arc.");
  corner_.label.setToolTip(corner);
  corner_.box.setToolTip(corner);
  radius_.label.setText(tr("Readers see &tags within:"));
  for (Field* field : {&front_, &rear_, &width_, &track_, &wheel_, &corner_, &radius_}) field->box.setSuffix(tr(" m"));
  speed_.box.setSuffix(tr(" m/s"));
  turn_.box.setSuffix(tr(" rad/s"));
  readersLabel_.setText(tr("Readers, from &left to right:"));
  preview_.setAccessibleName(tr("Drawing of the vehicle"));
  preview_.setToolTip(tr("The vehicle from above, nose up: outline, wheels, and the discs in which readers see tags"));
  notice_.show(Notice::Tone::Warning, complaint());
}

void TypePage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWizardPage::changeEvent(event);
}

}  // namespace tessera::ui
