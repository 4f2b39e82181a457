// The faults of a verdict as rows, errors first and kinds with many faults last among theirs: a sign for how serious it
// is, and the sentence.
#pragma once

#include <QAbstractListModel>
#include <vector>

#include "sitecheck/site_checker.h"

namespace tessera::ui {

class FaultModel : public QAbstractListModel {
  Q_OBJECT
public:
  using QAbstractListModel::QAbstractListModel;

  void setVerdict(const sitecheck::Verdict& verdict);
  void setShown(bool errors, bool warnings);
  [[nodiscard]] const sitecheck::Fault& fault(int row) const { return *rows_[static_cast<std::size_t>(row)]; }
  /// The row of a fault that is about the same; -1: none.
  [[nodiscard]] int rowOf(const sitecheck::Fault& fault) const;

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  /// The sentences are in another language now.
  void retranslate();

private:
  void sortOut();

  sitecheck::Verdict verdict_;  // holds the faults that the rows point to
  std::vector<const sitecheck::Fault*> rows_;
  bool errors_ = true;
  bool warnings_ = true;
};

}  // namespace tessera::ui
