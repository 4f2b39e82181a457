// A tag reader that is a keyboard to the computer: what is typed faster than a person types is a read and reaches no
// field; what a person types goes where it always goes, a moment later. A read that came in pieces is none.
#pragma once

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>
#include <memory>
#include <vector>

namespace tessera::ui {

class KeyboardReader : public QObject {
  Q_OBJECT
public:
  static constexpr int kPauseMs = 80;            ///< fewer characters than a read's, and then so long none: a person's
  static constexpr int kReadPauseMs = 400;       ///< as many as a read's, and then so long none: that was all
  static constexpr int kRestMs = 1000;           ///< what begins sooner after such a silence belongs to what was before
  static constexpr qsizetype kShortest = 8;      ///< characters of a read without Enter
  static constexpr qsizetype kShortestLine = 4;  ///< and with it
  static constexpr qsizetype kLongest = 120;

  explicit KeyboardReader(QObject* parent = nullptr);

  /// Listens to the whole program's keys. Whether the reader sends Enter is learned anew each time.
  void setListening(bool on);
  [[nodiscard]] bool isListening() const { return listening_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void typed(const QString& line);
  /// A piece of a read, and no read. wasTyped: it was told as one before, and what followed shows that it was none.
  void torn(const QString& piece, bool wasTyped);

private:
  /// What a silence ended last.
  enum class Before {
    Nothing,
    Keys,   ///< too few for a read: a person's, or the beginning of one
    Piece,  ///< of a read, which was refused
    Read,   ///< told as one
  };
  [[nodiscard]] bool takes(const QKeyEvent& key) const;
  [[nodiscard]] static bool ends(const QKeyEvent& key);
  bool press(QObject* watched, QKeyEvent& key);
  void turn();
  void silence();
  void enter();
  /// The read that was told is taken back, or this piece refused.
  void tear();
  /// As if nobody had held them back.
  void letGo();
  void drop();
  [[nodiscard]] int longestPause() const { return text_.size() < kShortest ? kPauseMs : kReadPauseMs; }
  [[nodiscard]] bool soon(const QKeyEvent& key) const;

  struct Held {
    QPointer<QObject> target;
    std::unique_ptr<QKeyEvent> event;
  };
  bool listening_ = false;
  bool lettingGo_ = false;
  bool sendsEnter_ = false;
  QString text_;
  bool rest_ = false;  ///< text_ began soon after what was before
  Before before_ = Before::Nothing;
  QString told_;  ///< before_ == Read
  std::vector<Held> held_;
  QTimer pause_;
  int turns_ = 0;
  quint64 stamp_ = 0;  ///< of the last character, by the window system; 0: it does not say
  QElapsedTimer since_;
};

}  // namespace tessera::ui
