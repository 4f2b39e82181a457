#include "ui/check/fault_model.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "ui/base/icon.h"
#include "ui/base/wording.h"

namespace tessera::ui {

using sitecheck::Fault;
using sitecheck::Severity;

void FaultModel::setVerdict(const sitecheck::Verdict& verdict) {
  beginResetModel();
  verdict_ = verdict;
  sortOut();
  endResetModel();
}

void FaultModel::setShown(bool errors, bool warnings) {
  if (errors == errors_ && warnings == warnings_) return;
  beginResetModel();
  errors_ = errors;
  warnings_ = warnings;
  sortOut();
  endResetModel();
}

void FaultModel::sortOut() {
  rows_.clear();
  verdict_.forEach([this](const Fault& fault) {
    if (fault.severity == Severity::Error ? errors_ : warnings_) rows_.push_back(&fault);
  });
  // Of a kind that a floor has hundreds of, one is like the next: what is rare is not to drown in it.
  constexpr std::size_t few = 20;
  std::array<std::size_t, sitecheck::kFaultKinds> ofKind{};
  for (const Fault* f : rows_) ofKind.at(static_cast<std::size_t>(f->kind)) += f->stands;
  const auto rank = [&](const Fault* f) {
    const std::size_t count = ofKind.at(static_cast<std::size_t>(f->kind));
    const bool many = count > few;
    return std::tuple{f->severity != Severity::Error, many ? count : 0, many ? f->kind : sitecheck::FaultKind{}};
  };
  std::stable_sort(rows_.begin(), rows_.end(), [&](const Fault* a, const Fault* b) { return rank(a) < rank(b); });
}

int FaultModel::rowOf(const Fault& fault) const {
  const auto found = [&](const auto& same) {
    const auto at = std::find_if(rows_.begin(), rows_.end(), [&](const Fault* f) { return same(*f); });
    return at == rows_.end() ? -1 : static_cast<int>(at - rows_.begin());
  };
  const int exact = found([&](const Fault& f) { return f == fault; });
  if (exact >= 0) return exact;
  return found([&](const Fault& f) { return f.kind == fault.kind && f.objects == fault.objects; });
}

int FaultModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant FaultModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Fault& f = fault(index.row());
  const bool error = f.severity == Severity::Error;
  switch (role) {
    case Qt::DisplayRole:
      return text(f.sentence);
    case Qt::DecorationRole:
      return icon(error ? QStringLiteral("error") : QStringLiteral("warning"));
    case Qt::ToolTipRole:
      return f.fix ? tr("%1\nCan be mended: %2.").arg(text(f.sentence), text(f.fix->sentence)) : text(f.sentence);
    case Qt::AccessibleTextRole:
      return (error ? tr("Error: %1") : tr("Warning: %1")).arg(text(f.sentence));
    default:
      return {};
  }
}

void FaultModel::retranslate() {
  if (!rows_.empty()) Q_EMIT dataChanged(index(0), index(rowCount() - 1));
}

}  // namespace tessera::ui
