// What a file holds that a site can be read from, alike for the window and the command line.
#pragma once

#include <optional>
#include <string_view>

namespace tessera::exchange {

enum class Format { Site, TagTable, Layout };

/// By the ending alone, in small or capital letters: *.csv is a table of tags, *.lif and *.lif.json a layout, any other
/// *.json a site. Nothing: another ending.
[[nodiscard]] std::optional<Format> formatOfName(std::string_view name);

/// Looks into a *.json file that is neither *.tessera.json nor *.lif.json: a layout has `layouts`, whatever the file is
/// called. A file of another ending is taken for a site, whose reader says what is wrong.
[[nodiscard]] Format formatOf(std::string_view name, std::string_view text);

}  // namespace tessera::exchange
