// What registering remembers beyond the program's end: the reader, and for each site how far it has come.
#pragma once

#include <QString>
#include <optional>

#include "scan/reader.h"
#include "scan/registration.h"

namespace tessera::ui {

struct ReaderChoice {
  bool keyboard = true;  ///< it types; port and baud do not matter then
  QString port;
  int baud = 9600;
  scan::ReaderForm form = scan::ReaderForm::HexLines;
  bool sounds = true;
  bool operator==(const ReaderChoice&) const = default;
};

class RegisterMemory {
public:
  RegisterMemory() = default;
  RegisterMemory(const RegisterMemory&) = delete;
  RegisterMemory& operator=(const RegisterMemory&) = delete;
  virtual ~RegisterMemory() = default;

  [[nodiscard]] virtual ReaderChoice reader() const = 0;
  virtual void setReader(const ReaderChoice& reader) = 0;
  /// Of the open site; nullopt: nothing was begun, or all of it is done.
  [[nodiscard]] virtual std::optional<scan::Course> course() const = 0;
  /// Kept when this returns, and the site's registered tags soon after: the program may be killed.
  virtual void keep(const std::optional<scan::Course>& course) = 0;
};

}  // namespace tessera::ui
