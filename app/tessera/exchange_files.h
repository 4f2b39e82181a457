// Importing from and exporting to files of others, with the questions on the way: tables of tags, layouts, pictures.
#pragma once

#include <QObject>
#include <QString>

#include "ui/base/site_document.h"

class QWidget;

namespace tessera::desktop {

class ExchangeFiles : public QObject {
  Q_OBJECT
public:
  /// Both must outlive it.
  ExchangeFiles(ui::SiteDocument& document, QWidget& window);

  /// Asks for a table (*.csv), a layout (*.lif, *.lif.json) or another site (*.tessera.json), shows what it would
  /// change, and changes it as one step.
  void importAsking();
  /// True: the site has changed.
  bool importFrom(const QString& path);
  void exportAsking();
  /// By the ending: *.csv is the table of the tiles' tags, *.places.csv that of all tags with their places, *.lif.json
  /// a layout.
  bool exportTo(const QString& path);
  /// planShown: the floor plan beneath the floor is to be seen just now.
  void savePictureAsking(bool planShown);

Q_SIGNALS:
  /// One sentence for the status line: what was done.
  void told(const QString& sentence);

private:
  [[nodiscard]] QString proposal(const QString& suffix) const;
  void tell(const QString& title, const QString& sentence);

  ui::SiteDocument& document_;
  QWidget& window_;
};

}  // namespace tessera::desktop
