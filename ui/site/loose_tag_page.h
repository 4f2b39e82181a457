// The table of tags that belong to no tile, with what adds and removes them.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QWidget>

#include "ui/base/notice.h"
#include "ui/site/loose_tag_model.h"

namespace tessera::ui {

class LooseTagPage : public QWidget {
  Q_OBJECT
public:
  explicit LooseTagPage(std::vector<floor::LooseTag> tags, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<floor::LooseTag>& tags() const { return model_.tags(); }
  void retranslate();

Q_SIGNALS:
  void edited();

private:
  void add();
  void remove();
  void offerWhatCanBeDone();

  LooseTagModel model_;
  QLabel what_;
  QTableView table_;
  QPushButton add_;
  QPushButton remove_;
  Notice refusal_;
};

}  // namespace tessera::ui
