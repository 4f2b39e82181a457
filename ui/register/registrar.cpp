#include "ui/register/registrar.h"

#include <QApplication>
#include <utility>

#include "ui/base/wording.h"

namespace tessera::ui {
namespace {

constexpr int kAskMs = 100;
constexpr int kBetweenBeepsMs = 180;

}  // namespace

Registrar::Registrar(SiteDocument& document, ScanBench& bench, RegisterMemory& memory, QObject* parent)
    : QObject{parent}, document_{document}, bench_{bench}, memory_{memory}, edits_{document} {
  clock_.start();
  asking_.setInterval(kAskMs);
  secondBeep_.setInterval(kBetweenBeepsMs);
  secondBeep_.setSingleShot(true);
  connect(&secondBeep_, &QTimer::timeout, this, [] { QApplication::beep(); });
  connectReader();
  connect(&document_, &SiteDocument::changed, this, &Registrar::documentChanged);
  // Another site's places are none of this one's; how far this one came was kept at each step.
  connect(&document_, &SiteDocument::replaced, this, &Registrar::end);
}

void Registrar::connectReader() {
  connect(&bench_, &ScanBench::opened, this, [this] {
    if (state_ == State::Idle) return;
    ears_.reset();
    contact_ = Contact::Open;
    Q_EMIT found();
    Q_EMIT changed();
  });
  connect(&bench_, &ScanBench::lost, this, [this](const QString& sentence) {
    if (state_ == State::Idle) return;
    contact_ = Contact::Lost;
    Q_EMIT lost(sentence);
    Q_EMIT changed();
  });
  connect(&bench_, &ScanBench::received, this, [this](const QByteArray& bytes) {
    const auto* data = reinterpret_cast<const std::uint8_t*>(bytes.constData());
    for (const scan::Heard& heard : ears_.hear({data, static_cast<std::size_t>(bytes.size())})) take(heard);
  });
  connect(&asking_, &QTimer::timeout, this, [this] {
    const auto question = ears_.question();
    if (contact_ == Contact::Open && state_ == State::Scanning && !question.empty())
      bench_.send({reinterpret_cast<const char*>(question.data()), static_cast<qsizetype>(question.size())});
  });
  // A read into a dialogue is held back from its fields and means nothing.
  connect(&keys_, &KeyboardReader::typed, this, [this](const QString& line) {
    if (QApplication::activeModalWidget() == nullptr) take(ears_.line(line.toStdString()));
  });
  connect(&keys_, &KeyboardReader::torn, this, [this](const QString& piece, bool wasTyped) {
    if (QApplication::activeModalWidget() == nullptr) refusePiece(piece, wasTyped);
  });
}

void Registrar::start(const scan::Course& course, const ReaderChoice& reader) {
  choice_ = reader;
  memory_.setReader(reader);
  ears_ = scan::Reader{reader.keyboard && reader.form == scan::ReaderForm::Module ? scan::ReaderForm::HexLines
                                                                                  : reader.form};
  kept_.reset();
  registration_.emplace(document_.map(), course);
  state_ = State::Scanning;
  contact_ = reader.keyboard ? Contact::Keyboard : Contact::Opening;
  keys_.setListening(reader.keyboard);
  keep();
  Q_EMIT changed();
  if (reader.keyboard) return;
  asking_.start();
  bench_.open(reader.port, reader.baud);
}

void Registrar::end() {
  if (state_ == State::Idle) return;
  state_ = State::Idle;
  keys_.setListening(false);
  asking_.stop();
  bench_.close();
  registration_.reset();
  question_.reset();
  Q_EMIT changed();
}

std::optional<scan::PlaceName> Registrar::place() const {
  if (!registration_ || registration_->stop() == nullptr) return std::nullopt;
  return scan::nameOf(registration_->site(), *registration_->stop());
}

std::optional<Point> Registrar::point() const {
  if (!registration_ || registration_->stop() == nullptr) return std::nullopt;
  return registration_->stop()->place;
}

void Registrar::take(const scan::Heard& heard) {
  if (state_ != State::Scanning || !registration_) return;
  if (const auto* sentence = std::get_if<Sentence>(&heard)) {
    question_.reset();
    return refuse({text(*sentence), {}, false});
  }
  using Verdict = scan::Answer::Verdict;
  const auto& read = std::get<scan::TagRead>(heard);
  const scan::Answer answer = registration_->offer(read, now());
  if (answer.verdict != Verdict::Repeated) question_.reset();
  switch (answer.verdict) {
    case Verdict::Repeated:
      return;
    case Verdict::Accepted:
    case Verdict::Confirmed:
      return accept(read.uid);
    case Verdict::OnThisTile:
      question_ = Question{read.uid, !scan::uidAt(registration_->site(), *registration_->stop()).empty()};
      return refuse({text(answer.sentence), answer.where, false});
    case Verdict::InUse:
    case Verdict::Elsewhere:
    case Verdict::Finished:
      return refuse({text(answer.sentence), answer.where, answer.verdict == Verdict::Elsewhere});
  }
}

void Registrar::refusePiece(const QString& piece, bool wasTyped) {
  if (state_ != State::Scanning || !registration_) return;
  question_.reset();
  const scan::Heard heard = ears_.line(piece.toStdString());
  const auto* read = std::get_if<scan::TagRead>(&heard);
  const bool registered = wasTyped && read != nullptr && read->uid == registration_->justRegistered();
  if (registered) back();
  refuse({registered ? tr("Only a part of a UID came: %1 was taken back. Hold the card again.").arg(piece)
                     : tr("Only a part of a UID came: %1. Hold the card again.").arg(piece),
          {},
          false});
}

void Registrar::accept(const floor::TagUid& uid) {
  if (edit([&] { return edits_.put(*place(), uid); })) onwards(uid);
}

bool Registrar::edit(const std::function<Result<void>()>& what) {
  editing_ = true;
  const auto done = what();
  editing_ = false;
  if (!done) refuse({text(done.error().sentence), {}, false});
  return done.has_value();
}

void Registrar::onwards(const floor::TagUid& uid) {
  registration_->registered(document_.map(), uid, now());
  keep();
  sound(Sound::Registered);
  Q_EMIT accepted(uid);
  Q_EMIT changed();
}

void Registrar::exchange() {
  if (!registration_ || !question_) return;
  const floor::TagUid uid = std::exchange(question_, {})->uid;
  const auto puts = registration_->exchange(uid);
  if (!puts.empty() && edit([&] { return edits_.exchange(puts); })) onwards(uid);
}

void Registrar::readAnew() {
  if (!registration_ || !question_) return;
  const floor::TagUid uid = std::exchange(question_, {})->uid;
  const auto here = place();
  const auto puts = registration_->anew();
  if (!edit([&] { return edits_.readAnew(puts); })) return;
  registration_->cleared(document_.map());
  // The tag in the hand is the first one of the tile; otherwise the reader has to go back to it.
  if (place() == here) return accept(uid);
  moved();
}

void Registrar::refuse(Refusal refusal) {
  sound(Sound::Refused);
  Q_EMIT refused(refusal);
}

void Registrar::setSounds(bool on) {
  if (on == choice_.sounds) return;
  choice_.sounds = on;
  memory_.setReader(choice_);
}

void Registrar::sound(Sound sound) {
  if (!choice_.sounds) return;
  if (sounder_) return sounder_(sound);
  QApplication::beep();
  if (sound == Sound::Refused) secondBeep_.start();
}

void Registrar::documentChanged() {
  if (editing_ || !registration_) return;
  const auto undone = registration_->siteChanged(document_.map());
  moved();
  // A redo takes back what the last sentence said.
  tell(undone ? takenBack(*undone) : QString{});
}

void Registrar::keep() {
  // A floor with nothing left to do needs no way back to it.
  const auto progress = registration_->progress();
  const bool done = registration_->stop() == nullptr && progress.skipped == 0;
  const auto course = done ? std::nullopt : std::optional{registration_->course()};
  if (!done && course == kept_) return;
  kept_ = course;
  memory_.keep(course);
}

void Registrar::moved() {
  question_.reset();
  keep();
  Q_EMIT changed();
}

void Registrar::setPaused(bool paused) {
  if (state_ == State::Idle) return;
  state_ = paused ? State::Paused : State::Scanning;
  registration_->pause();
  Q_EMIT changed();
}

void Registrar::back() {
  if (!registration_) return;
  const auto before = document_.map();
  const std::size_t skipped = registration_->progress().skipped;
  const auto puts = registration_->back();
  if (!puts.empty() && !edit([&] { return edits_.takeBack(puts); })) return;
  registration_->restored(document_.map());
  moved();
  std::vector<floor::TagUid> gone;
  for (const scan::Put& put : puts) {
    const auto& uids = tileOf(before->site(), put.place.serial)->uids;
    if (put.place.tag < uids.size() && !uids[put.place.tag].empty()) gone.push_back(uids[put.place.tag]);
  }
  if (!puts.empty()) return tell(takenBack(gone));
  const auto here = place();
  if (here && registration_->progress().skipped < skipped)
    tell(tr("Skipped no longer: tag %1 of tile %2")
             .arg(QString::number(here->tag + 1), QString::fromStdString(here->serial)));
}

QString Registrar::takenBack(const std::vector<floor::TagUid>& uids) {
  if (uids.size() == 1) return tr("Taken back: %1").arg(QString::fromStdString(uids.front().text()));
  return uids.empty() ? tr("Taken back") : tr("Taken back: %n tag(s)", nullptr, static_cast<int>(uids.size()));
}

void Registrar::tell(const QString& sentence) { Q_EMIT told(sentence); }

void Registrar::skip() {
  if (!registration_) return;
  const auto here = place();
  registration_->skip();
  moved();
  if (here)
    tell(tr("Skipped: tag %1 of tile %2").arg(QString::number(here->tag + 1), QString::fromStdString(here->serial)));
}

void Registrar::next() {
  if (registration_ && registration_->next()) moved();
}

void Registrar::previous() {
  if (registration_ && registration_->previous()) moved();
}

void Registrar::goTo(const scan::PlaceName& place) {
  if (registration_ && registration_->goTo(place)) moved();
}

void Registrar::takeUpSkipped() {
  if (!registration_) return;
  registration_->takeUpSkipped();
  moved();
}

}  // namespace tessera::ui
