// A map sheet as a file.
#pragma once

#include <QString>

#include "base/result.h"
#include "ui/print/map_sheet.h"

namespace tessera::ui {

/// By the file's ending: .png (150 dots per inch), .svg or .pdf. A file of that name is replaced when the new one is
/// complete. Error: another ending, a picture of more than 16,000 dots a side, a file of lines with more than 300,000
/// places, a page beyond what PDF readers take (5 m), a file that cannot be written; the sentence says what helps.
[[nodiscard]] Result<void> saveSheet(const MapSheet& sheet, const QString& path);

}  // namespace tessera::ui
