// The radio module on this computer: read its parameters, compare them with the site's, write the site's.
#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTableWidget>
#include <optional>

#include "floor/site.h"
#include "ui/base/notice.h"
#include "ui/base/radio_bench.h"
#include "ui/connect/jumper_picture.h"

namespace tessera::ui {

class RadioDialog : public QDialog {
  Q_OBJECT
public:
  RadioDialog(RadioBench& bench, const floor::RadioSetup& site, QWidget* parent = nullptr);

  /// Sentences on what is heard of vehicles that are set otherwise than the site; empty: nothing to say.
  void setAdvice(const QStringList& sentences);
  /// Closing gives up what is under way.
  void done(int result) override;

protected:
  void changeEvent(QEvent* event) override;

private:
  enum class Work { None, Reading, Writing };

  void layOut();
  void retranslate();
  void begin(Work work);
  void end();
  void showFound(const link::E32Parameters& parameters);
  void showFailed(const QString& sentence);
  void fill();
  [[nodiscard]] link::E32Parameters wanted() const;

  RadioBench& bench_;
  floor::RadioSetup site_;
  std::optional<link::E32Parameters> module_;
  Work work_ = Work::None;

  QLabel steps_;
  JumperPicture off_{JumperPicture::Jumpers::Off};
  JumperPicture on_{JumperPicture::Jumpers::On};
  Notice advice_;
  QTableWidget table_;
  QLabel powerLabel_;
  QComboBox power_;
  QLabel powerHint_;
  QPushButton read_;
  QPushButton write_;
  QPushButton cancel_;
  QProgressBar progress_;
  Notice result_;
  QDialogButtonBox buttons_;
};

}  // namespace tessera::ui
