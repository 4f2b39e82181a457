// What the program remembers of a person between two runs.
#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

#include "app/tessera/appearance.h"
#include "ui/base/connection_choice.h"

namespace tessera::desktop {

/// Longest list of recent sites.
inline constexpr int kMostRecent = 8;

class Settings {
public:
  [[nodiscard]] QByteArray geometry() const { return store_.value("window/geometry").toByteArray(); }
  [[nodiscard]] QByteArray layout() const { return store_.value("window/layout").toByteArray(); }
  void setWindow(const QByteArray& geometry, const QByteArray& layout);

  /// Empty: as the system says.
  [[nodiscard]] QString language() const { return store_.value("language").toString(); }
  void setLanguage(const QString& code) { store_.setValue("language", code); }
  [[nodiscard]] Appearance appearance() const { return appearanceOf(store_.value("appearance").toString()); }
  void setAppearance(Appearance appearance) { store_.setValue("appearance", nameOf(appearance)); }

  /// The site that was open last; empty: none.
  [[nodiscard]] QString site() const { return store_.value("site").toString(); }
  void setSite(const QString& path) { store_.setValue("site", path); }
  /// Paths, the newest first.
  [[nodiscard]] QStringList recent() const { return store_.value("recent").toStringList(); }
  void addRecent(const QString& path);
  void forgetRecent(const QString& path);

  /// Under which name sites are saved; empty: as the system calls the person.
  [[nodiscard]] QString author() const { return store_.value("author").toString(); }
  void setAuthor(const QString& name) { store_.setValue("author", name); }

  /// Room in metres that vehicles are to keep around them when the site is checked.
  [[nodiscard]] double clearance() const { return store_.value("check/clearance_m", 0.0).toDouble(); }
  void setClearance(double metres) { store_.setValue("check/clearance_m", metres); }

  [[nodiscard]] ui::ConnectionChoice connection() const;
  void setConnection(const ui::ConnectionChoice& choice);

private:
  QSettings store_;
};

}  // namespace tessera::desktop
