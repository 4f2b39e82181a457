// What an import would change in the site, one sentence each, before anything is changed.
#pragma once

#include <QDialog>

#include "exchange/preview.h"

namespace tessera::ui {

class ChangesDialog : public QDialog {
  Q_OBJECT
public:
  /// file: shown as the source.
  ChangesDialog(const exchange::Preview& preview, const QString& file, QWidget* parent = nullptr);

private:
  /// "1,997 new, 1 changed"
  [[nodiscard]] static QString totalsOf(const sitediff::Changes& changes);
};

}  // namespace tessera::ui
