// What happened, line by line: a bounded list, and a filter over it by severity, vehicle and words.
#pragma once

#include <QAbstractTableModel>
#include <QDateTime>
#include <QSortFilterProxyModel>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "supervisor/event.h"
#include "ui/base/site_document.h"
#include "ui/base/wording.h"
#include "ui/fleet/journal.h"
#include "ui/fleet/roles.h"

namespace tessera::ui {

class EventModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { When, Who, What, ColumnCount };
  static constexpr std::size_t kMost = 5000;

  explicit EventModel(SiteDocument& document, QObject* parent = nullptr);

  void setClock(std::function<QDateTime(Seconds)> clock) { clock_ = std::move(clock); }
  void append(const std::vector<supervisor::Event>& events);
  /// Older lines, oldest first, before all others.
  void prepend(const std::vector<JournalLine>& lines);
  void clear();
  void refreshTexts();

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  void trim(std::size_t coming);
  [[nodiscard]] QString shown(const JournalLine& line, int column) const;
  [[nodiscard]] QString nameOf(const std::optional<VehicleId>& vehicle) const;

  SiteDocument& document_;
  std::function<QDateTime(Seconds)> clock_;
  std::deque<JournalLine> lines_;
};

class EventFilter : public QSortFilterProxyModel {
  Q_OBJECT
public:
  using QSortFilterProxyModel::QSortFilterProxyModel;

  void set(supervisor::Severity least, std::optional<VehicleId> vehicle, const QString& words);
  [[nodiscard]] bool isActive() const { return least_ != supervisor::Severity::Info || vehicle_ || !words_.isEmpty(); }

protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
  supervisor::Severity least_ = supervisor::Severity::Info;
  std::optional<VehicleId> vehicle_;
  QString words_;
};

}  // namespace tessera::ui
