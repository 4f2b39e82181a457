// The names of things of the site as a list: one is chosen, and renamed in its place.
#pragma once

#include <QListWidget>
#include <QStringList>

namespace tessera::ui {

class NameList : public QListWidget {
  Q_OBJECT
public:
  explicit NameList(const char* objectName, QWidget* parent = nullptr);

  /// Shows these names with the chosen one as the current row. Returns what the chosen one is called now: where its row
  /// has another name it was renamed, or that was undone; empty: it is gone.
  [[nodiscard]] QString setNames(const QStringList& names, const QString& chosen);
  /// Lets the chosen name be edited.
  void startRenaming();

Q_SIGNALS:
  /// By the operator.
  void nameChosen(const QString& name);
  /// The operator typed another name; setNames() shows what became of it.
  void renameRequested(const QString& from, const QString& to);

private:
  bool filling_ = false;  ///< what changes is not the operator's doing
};

}  // namespace tessera::ui
