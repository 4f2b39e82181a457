// The floor checked by driving over it: how far it is, what lies otherwise than the site says, and the button that
// mends the site.
#pragma once

#include <QWidget>
#include <variant>

#include "ui/tilecheck/tile_watch.h"

class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace tessera::ui {

class TileCheckPanel : public QWidget {
  Q_OBJECT
public:
  /// Both must outlive it.
  TileCheckPanel(TileWatch& watch, FleetLink& fleet, QWidget* parent = nullptr);

Q_SIGNALS:
  /// The operator wants to see this place on the floor.
  void placeWanted(const tessera::ui::SiteBox& place);
  /// One sentence: why something was not done.
  void refused(const QString& sentence);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void refresh();
  void refreshButtons();
  void goTo(int row);
  void mend();
  [[nodiscard]] QString whatNow() const;

  TileWatch& watch_;
  FleetLink& fleet_;
  QPushButton* run_;
  QPushButton* reset_;
  QProgressBar* bar_;
  QLabel* counts_;
  QStackedWidget* pages_;
  QLabel* empty_;
  QListWidget* list_;
  QPushButton* show_;
  QPushButton* mend_;
  // A row of the list: tiles that lie otherwise first.
  using Found = std::variant<tilecheck::TileSuspect, tilecheck::TagFinding>;
  [[nodiscard]] static const Sentence& sentenceOf(const Found& found);
  /// By which it is known again when more was read.
  [[nodiscard]] static std::string subjectOf(const Found& found);
  [[nodiscard]] const Found* foundAt(int row) const;
  std::vector<Found> listed_;
  bool live_ = false;  ///< a supervision runs
};

}  // namespace tessera::ui
