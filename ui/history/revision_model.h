// Revisions as rows: when, who, what, how much.
#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <QString>
#include <optional>
#include <vector>

#include "sitediff/tally.h"

namespace tessera::ui {

struct RevisionLine {
  qint64 id = 0;
  QDateTime when;
  QString who;                             ///< empty: nobody knows
  QString what;                            ///< names of steps
  bool found = false;                      ///< not saved here: as the file was when it was opened
  std::optional<sitediff::Tally> changed;  ///< by this saving
};

/// "14/11/2026 09:31:07", in the language's way.
[[nodiscard]] QString revisionTime(const QDateTime& when);
/// "3 tiles laid, 1 route".
[[nodiscard]] QString tallyText(const sitediff::Tally& tally);

class RevisionModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { kWhen, kWho, kWhat, kChanged, kColumns };
  using QAbstractTableModel::QAbstractTableModel;

  /// The newest first.
  void setLines(std::vector<RevisionLine> lines);
  [[nodiscard]] const RevisionLine& line(int row) const { return lines_[static_cast<std::size_t>(row)]; }
  /// -1: none.
  [[nodiscard]] int rowOf(qint64 id) const;
  void retranslate();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  [[nodiscard]] QString cell(const RevisionLine& line, int column) const;

  std::vector<RevisionLine> lines_;
};

}  // namespace tessera::ui
