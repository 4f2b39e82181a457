// A tag reader that is a keyboard to the computer: what is typed faster than a person types is a read and reaches no
// field; what a person types goes where it always goes, a moment later.
#pragma once

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
  static constexpr int kPauseMs = 80;            ///< no reader makes a longer one between two characters
  static constexpr qsizetype kShortest = 8;      ///< characters of a read without Enter
  static constexpr qsizetype kShortestLine = 4;  ///< and with it
  static constexpr qsizetype kLongest = 120;

  explicit KeyboardReader(QObject* parent = nullptr);

  /// Listens to the whole program's keys.
  void setListening(bool on);
  [[nodiscard]] bool isListening() const { return listening_; }

  bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
  void typed(const QString& line);

private:
  [[nodiscard]] bool takes(const QKeyEvent& key) const;
  [[nodiscard]] static bool ends(const QKeyEvent& key);
  bool press(QObject* watched, QKeyEvent& key);
  void silence();
  /// As if nobody had held them back.
  void letGo();

  struct Held {
    QPointer<QObject> target;
    std::unique_ptr<QKeyEvent> event;
  };
  bool listening_ = false;
  bool lettingGo_ = false;
  QString text_;
  std::vector<Held> held_;
  QTimer pause_;
};

}  // namespace tessera::ui
