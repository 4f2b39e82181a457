// A line to type into, over the floor: what is found is listed below, Enter goes there.
#pragma once

#include <QFrame>
#include <vector>

#include "ui/base/site_document.h"
#include "ui/find/place_search.h"

class QLabel;
class QLineEdit;
class QListWidget;

namespace tessera::ui {

class FindBox : public QFrame {
  Q_OBJECT
public:
  /// `over`: in whose upper middle it appears; hidden until opened.
  FindBox(const SiteDocument& document, QWidget* over);

  /// Shows it, with what was typed last chosen, and takes the keys.
  void open();

Q_SIGNALS:
  void chosen(const tessera::ui::SiteBox& place);
  /// It was left without choice.
  void left();

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void look();
  void go(int row);
  void fitOver();

  const SiteDocument& document_;
  QLineEdit* text_;
  QListWidget* list_;
  QLabel* none_;
  std::vector<FoundPlace> found_;
};

}  // namespace tessera::ui
