// What registering remembers, in the settings: the reader, and under each site's key how far it has come.
#pragma once

#include <QSettings>

#include "app/tessera/keeper.h"
#include "ui/register/register_memory.h"

namespace tessera::desktop {

class RegisterNotes : public ui::RegisterMemory {
public:
  explicit RegisterNotes(Keeper& keeper) : keeper_{keeper} {}

  [[nodiscard]] ui::ReaderChoice reader() const override;
  void setReader(const ui::ReaderChoice& reader) override;
  [[nodiscard]] std::optional<scan::Course> course() const override;
  void keep(const std::optional<scan::Course>& course) override;
  /// What was noted of the site that had this key is now noted of the open one.
  void takeFrom(const QString& key);

private:
  [[nodiscard]] QString group() const;

  Keeper& keeper_;
  QSettings store_;
};

}  // namespace tessera::desktop
