// Joins reader, walk and document: what a read means is the registration's to say, what becomes of it is seen to here.
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <optional>

#include "ui/register/keyboard_reader.h"
#include "ui/register/register_edits.h"
#include "ui/register/register_memory.h"
#include "ui/register/scan_bench.h"

namespace tessera::ui {

class Registrar : public QObject {
  Q_OBJECT
public:
  enum class State { Idle, Scanning, Paused };
  enum class Contact { Keyboard, Opening, Open, Lost };
  /// Why a read was not taken.
  struct Refusal {
    QString sentence;
    std::optional<scan::PlaceName> where;
    bool belongsThere = false;  ///< the tag says so itself; otherwise it is registered there
  };
  /// A tag was read that is registered at another place of the tile: what shall be done about it?
  struct Question {
    floor::TagUid uid;
    bool isHereOne = false;  ///< another tag is registered at the place: the two would be exchanged
  };

  /// All must outlive it.
  Registrar(SiteDocument& document, ScanBench& bench, RegisterMemory& memory, QObject* parent = nullptr);

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] Contact contact() const { return contact_; }
  [[nodiscard]] const ReaderChoice& reader() const { return choice_; }
  /// Nullopt: idle.
  [[nodiscard]] const std::optional<scan::Registration>& registration() const { return registration_; }
  /// Where a scan is to go; nullopt: idle, or all is done.
  [[nodiscard]] std::optional<scan::PlaceName> place() const;
  [[nodiscard]] std::optional<Point> point() const;
  /// Nullopt: none is open. Any step but an answer gives it up.
  [[nodiscard]] const std::optional<Question>& question() const { return question_; }
  [[nodiscard]] ScanBench& bench() { return bench_; }
  [[nodiscard]] RegisterMemory& memory() { return memory_; }
  [[nodiscard]] SiteDocument& document() { return document_; }
  [[nodiscard]] RegisterEdits& edits() { return edits_; }

  void start(const scan::Course& course, const ReaderChoice& reader);
  /// What was reached is kept, to go on another day.
  void end();
  void setPaused(bool paused);
  void back();
  void skip();
  void next();
  void previous();
  void goTo(const scan::PlaceName& place);
  void takeUpSkipped();
  // Answers to the question.
  void exchange();
  void readAnew();
  void setSounds(bool on);
  enum class Sound { Registered, Refused };
  /// What sounds in place of the system's beep, which is one for a tag that is registered and two for one that is not.
  void setSounder(std::function<void(Sound)> sounder) { sounder_ = std::move(sounder); }
  /// A read, or what came in place of one.
  void take(const scan::Heard& heard);

Q_SIGNALS:
  /// The state, the place, the site or the reader's port is another.
  void changed();
  void accepted(const tessera::floor::TagUid& uid);
  void refused(const tessera::ui::Registrar::Refusal& refusal);
  /// What another step did: one sentence. Empty: what was told last holds no longer.
  void told(const QString& sentence);
  /// The reader's port is gone; one sentence.
  void lost(const QString& sentence);
  void found();

private:
  void connectReader();
  /// wasTyped: as a read, which may stand in the site since.
  void refusePiece(const QString& piece, bool wasTyped);
  void accept(const floor::TagUid& uid);
  /// Ours: the walk follows it by itself. False: it was refused, which has been told.
  bool edit(const std::function<Result<void>()>& what);
  void onwards(const floor::TagUid& uid);
  void refuse(Refusal refusal);
  [[nodiscard]] static QString takenBack(const std::vector<floor::TagUid>& uids);
  void tell(const QString& sentence);
  void documentChanged();
  void keep();
  void moved();
  void sound(Sound sound);
  [[nodiscard]] Seconds now() const { return Seconds{static_cast<double>(clock_.elapsed()) / 1000.0}; }

  SiteDocument& document_;
  ScanBench& bench_;
  RegisterMemory& memory_;
  RegisterEdits edits_;
  KeyboardReader keys_;
  scan::Reader ears_;
  ReaderChoice choice_;
  State state_ = State::Idle;
  Contact contact_ = Contact::Keyboard;
  std::optional<scan::Registration> registration_;
  std::optional<scan::Course> kept_;
  std::optional<Question> question_;
  std::function<void(Sound)> sounder_;
  QElapsedTimer clock_;
  QTimer asking_;
  QTimer secondBeep_;
  bool editing_ = false;  ///< the document changes by our own hand
};

}  // namespace tessera::ui
