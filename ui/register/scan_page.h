// While registering: where to hold the reader, what became of the last read, how far it is.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QToolButton>

#include "ui/base/notice.h"
#include "ui/register/registrar.h"
#include "ui/register/tile_picture.h"

namespace tessera::ui {

class ScanPage : public QWidget {
  Q_OBJECT
public:
  explicit ScanPage(Registrar& registrar, QWidget* parent = nullptr);

  /// Whether this key is one of the page's, done then.
  bool takeKey(const QKeyEvent& key);
  [[nodiscard]] static bool wantsKey(const QKeyEvent& key);
  [[nodiscard]] TilePicture& picture() { return picture_; }
  /// A long time in words, rounded up to minutes.
  [[nodiscard]] static QString timeText(Seconds time);

Q_SIGNALS:
  /// Show this place on the floor, and leave the walk where it is.
  void showRequested(const tessera::scan::PlaceName& place);

protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  void build();
  void retranslate();
  void refresh();
  void showProgress();
  void showContact();
  void showWhetherHeard();
  void showAccepted(const floor::TagUid& uid);
  void showTold(const QString& sentence);
  void showRefused(const Registrar::Refusal& refusal);
  void forgetRefusal();
  void readAnew();

  Registrar& registrar_;
  QLabel title_, detail_, contact_, count_;
  TilePicture picture_;
  Notice deaf_, notice_;
  QPushButton where_, exchange_, anew_;
  QProgressBar bar_;
  QPushButton back_, skip_, pause_, end_, skipped_;
  QToolButton previous_, next_;
  QCheckBox sounds_;
  bool told_ = false;   ///< the notice is what a step other than a read did
  bool asked_ = false;  ///< the refusal that is shown is a question
  std::optional<Registrar::Refusal> refusal_;
};

}  // namespace tessera::ui
