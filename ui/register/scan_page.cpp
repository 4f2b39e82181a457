#include "ui/register/scan_page.h"

#include <QApplication>
#include <QEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QWindow>
#include <algorithm>
#include <cmath>

#include "ui/base/icon.h"

namespace tessera::ui {

QString ScanPage::timeText(Seconds time) {
  const QLocale locale;
  const auto minutes = static_cast<long long>(std::ceil(time.value() / 60.0));
  if (minutes < 60) return tr("%1 min").arg(locale.toString(minutes));
  return tr("%1 h %2 min").arg(locale.toString(minutes / 60), locale.toString(minutes % 60));
}

ScanPage::ScanPage(Registrar& registrar, QWidget* parent) : QWidget{parent}, registrar_{registrar} {
  setObjectName(QStringLiteral("scanPage"));
  setFocusPolicy(Qt::StrongFocus);
  build();
  connect(&registrar_, &Registrar::changed, this, &ScanPage::refresh);
  connect(&registrar_, &Registrar::accepted, this, &ScanPage::showAccepted);
  connect(&registrar_, &Registrar::refused, this, &ScanPage::showRefused);
  connect(&registrar_, &Registrar::told, this, &ScanPage::showTold);
  connect(&registrar_, &Registrar::lost, this, [this](const QString& sentence) {
    forgetRefusal();
    notice_.show(Notice::Tone::Error, sentence);
  });
  connect(&registrar_, &Registrar::found, this, [this] {
    forgetRefusal();
    notice_.clear();
  });
  connect(&where_, &QPushButton::clicked, this, [this] {
    if (!refusal_ || !refusal_->where) return;
    const Registrar::Refusal refusal = *refusal_;
    if (!refusal.belongsThere) return Q_EMIT showRequested(*refusal.where);
    forgetRefusal();
    notice_.clear();
    registrar_.goTo(*refusal.where);
  });
  connect(&exchange_, &QPushButton::clicked, &registrar_, &Registrar::exchange);
  connect(&anew_, &QPushButton::clicked, this, &ScanPage::readAnew);
  connect(&sounds_, &QCheckBox::toggled, &registrar_, &Registrar::setSounds);
  connect(&back_, &QPushButton::clicked, &registrar_, &Registrar::back);
  connect(&skip_, &QPushButton::clicked, &registrar_, &Registrar::skip);
  connect(&pause_, &QPushButton::clicked, this,
          [this] { registrar_.setPaused(registrar_.state() == Registrar::State::Scanning); });
  connect(&end_, &QPushButton::clicked, &registrar_, &Registrar::end);
  connect(&skipped_, &QPushButton::clicked, &registrar_, &Registrar::takeUpSkipped);
  connect(&previous_, &QToolButton::clicked, &registrar_, &Registrar::previous);
  connect(&next_, &QToolButton::clicked, &registrar_, &Registrar::next);
  connect(qApp, &QGuiApplication::focusWindowChanged, this, &ScanPage::showWhetherHeard);
  retranslate();
}

void ScanPage::refresh() {
  const auto& registration = registrar_.registration();
  if (!registration) return;
  const auto place = registrar_.place();
  const bool paused = registrar_.state() == Registrar::State::Paused;
  pause_.setText(paused ? tr("Go on") : tr("Pause"));
  pause_.setIcon(icon(paused ? QStringLiteral("resume") : QStringLiteral("pause")));
  skip_.setEnabled(place.has_value());
  next_.setEnabled(place.has_value());
  skipped_.setVisible(!place && registration->progress().skipped > 0);
  picture_.setVisible(place.has_value());
  sounds_.setChecked(registrar_.reader().sounds);
  if (asked_ && !registrar_.question()) {
    forgetRefusal();
    notice_.clear();
  }
  showContact();
  showWhetherHeard();
  showProgress();
  if (!place) {
    title_.setText(tr("All done"));
    detail_.setText(registration->walk().empty() ? tr("There is no place for a tag here.")
                                                 : tr("Every place is registered or skipped."));
    picture_.clear();
    return;
  }
  const floor::Site& site = registration->site();
  const floor::Tile& tile = *tileOf(site, place->serial);
  const auto type = std::find_if(site.tileTypes.begin(), site.tileTypes.end(),
                                 [&](const floor::TileType& t) { return t.name == tile.type; });
  const auto laid = std::find_if(site.placements.begin(), site.placements.end(),
                                 [&](const floor::Placement& p) { return p.serial == place->serial; });
  title_.setText(tr("Tile %1").arg(QString::fromStdString(place->serial)));
  QString detail = tr("Tag %1 of %2").arg(place->tag + 1).arg(tagOffsets(*type).size());
  const floor::TagUid there = scan::uidAt(site, *registration->stop());
  if (!there.empty()) detail = tr("%1: %2 until another is read").arg(detail, QString::fromStdString(there.text()));
  if (paused) detail = tr("%1 – paused, reads do not count").arg(detail);
  detail_.setText(detail);
  picture_.setTile(*type, tile, laid == site.placements.end() ? 0 : laid->quarterTurns, place->tag);
}

void ScanPage::showProgress() {
  const auto p = registrar_.registration()->progress();
  const QLocale locale;
  // Read once more, all of them may be registered from the beginning on.
  const bool again = registrar_.registration()->visitsAgain();
  const std::size_t done = again ? p.places - p.left : p.registered;
  bar_.setMaximum(static_cast<int>(std::max<std::size_t>(1, p.places)));
  bar_.setValue(static_cast<int>(done));
  QString text =
      (again ? tr("%1 of %2 read anew") : tr("%1 of %2 registered"))
          .arg(locale.toString(static_cast<qulonglong>(done)), locale.toString(static_cast<qulonglong>(p.places)));
  if (p.skipped > 0) text = tr("%1, %2 skipped").arg(text, locale.toString(static_cast<qulonglong>(p.skipped)));
  if (p.perTag && p.timeLeft && *p.perTag > Seconds{}) {
    const double perMinute = std::round(60.0 / p.perTag->value());
    text = tr("%1. %2 a minute, about %3 left").arg(text, locale.toString(perMinute, 'f', 0), timeText(*p.timeLeft));
  }
  count_.setText(text);
}

// Keys go to the window that is in front, whose ever it is.
void ScanPage::showWhetherHeard() {
  const bool deaf = registrar_.state() == Registrar::State::Scanning &&
                    registrar_.contact() == Registrar::Contact::Keyboard && QApplication::activeWindow() == nullptr;
  deaf_.show(
      Notice::Tone::Warning,
      deaf ? tr("Another program is in front: what the reader types goes there. Click into this window.") : QString{});
}

void ScanPage::showContact() {
  switch (registrar_.contact()) {
    case Registrar::Contact::Keyboard:
      contact_.setText(tr("Reader: types like a keyboard"));
      break;
    case Registrar::Contact::Opening:
      contact_.setText(tr("Reader: %1 is being opened…").arg(registrar_.reader().port));
      break;
    case Registrar::Contact::Open:
      contact_.setText(tr("Reader: at %1").arg(registrar_.reader().port));
      break;
    case Registrar::Contact::Lost:
      contact_.setText(tr("Reader: waiting for %1").arg(registrar_.reader().port));
      break;
  }
}

void ScanPage::forgetRefusal() {
  told_ = false;
  refusal_.reset();
  asked_ = false;
  for (QWidget* button : {&where_, &exchange_, &anew_}) button->hide();
}

void ScanPage::showAccepted(const floor::TagUid& uid) {
  forgetRefusal();
  notice_.show(Notice::Tone::Good, tr("Registered: %1").arg(QString::fromStdString(uid.text())));
  picture_.flash(TilePicture::Flash::Good);
}

void ScanPage::showTold(const QString& sentence) {
  if (sentence.isEmpty() && !told_) return;
  forgetRefusal();
  notice_.show(Notice::Tone::Info, sentence);
  told_ = !sentence.isEmpty();
}

void ScanPage::showRefused(const Registrar::Refusal& refusal) {
  told_ = false;
  refusal_ = refusal;
  where_.setText(refusal.belongsThere ? tr("Go on there") : tr("Show it"));
  where_.setVisible(refusal.where.has_value());
  const auto& question = registrar_.question();
  asked_ = question.has_value();
  exchange_.setVisible(asked_);
  anew_.setVisible(asked_);
  if (!question) {
    notice_.show(Notice::Tone::Error, refusal.sentence);
  } else if (question->isHereOne) {
    exchange_.setText(tr("Exchange the two"));
    notice_.show(
        Notice::Tone::Warning,
        tr("%1 Exchange it with the one that is registered here, or read the whole tile anew?").arg(refusal.sentence));
  } else {
    exchange_.setText(tr("Move it here"));
    notice_.show(Notice::Tone::Warning, tr("%1 Move it here, or read the whole tile anew?").arg(refusal.sentence));
  }
  picture_.flash(TilePicture::Flash::Bad);
}

void ScanPage::readAnew() {
  registrar_.readAnew();
  // Where the tag in the hand was the first one of the tile, that has been said.
  if (notice_.text().isEmpty())
    notice_.show(Notice::Tone::Info,
                 tr("The tile's tags are read anew, from the lit one on. One step back brings the old ones back."));
}

bool ScanPage::wantsKey(const QKeyEvent& key) {
  if ((key.modifiers() & ~Qt::KeypadModifier) != Qt::NoModifier) return false;
  return key.key() == Qt::Key_Backspace || key.key() == Qt::Key_Delete || key.key() == Qt::Key_PageUp ||
         key.key() == Qt::Key_PageDown || key.key() == Qt::Key_Pause;
}

bool ScanPage::takeKey(const QKeyEvent& key) {
  if (!wantsKey(key) || registrar_.state() == Registrar::State::Idle) return false;
  switch (key.key()) {
    case Qt::Key_Backspace:
      registrar_.back();
      break;
    case Qt::Key_Delete:
      registrar_.skip();
      break;
    case Qt::Key_PageUp:
      registrar_.previous();
      break;
    case Qt::Key_PageDown:
      registrar_.next();
      break;
    default:
      pause_.click();
  }
  return true;
}

void ScanPage::keyPressEvent(QKeyEvent* event) {
  if (!takeKey(*event)) QWidget::keyPressEvent(event);
}

bool ScanPage::event(QEvent* event) {
  const bool done = QWidget::event(event);
  if (event->type() == QEvent::WindowActivate || event->type() == QEvent::WindowDeactivate) showWhetherHeard();
  return done;
}

void ScanPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace tessera::ui
