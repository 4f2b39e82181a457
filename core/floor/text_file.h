// Whole files of text, in and out.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"

namespace tessera::floor {

/// At most the first `most` bytes. Error: names the file and why it cannot be read.
[[nodiscard]] Result<std::string> loadText(const std::filesystem::path& path, std::size_t most);

enum class Replacing { Allowed, Refused };

/// Writes a temporary file beside `path`, syncs it and gives it its name: after a failure or a power cut either the old
/// file or the new one stands there whole. Error: what could not be written and why, or that a file stands there
/// already which may not be replaced; that file stands untouched.
[[nodiscard]] Result<void> saveText(const std::string& text, const std::filesystem::path& path, Replacing replacing);

}  // namespace tessera::floor
