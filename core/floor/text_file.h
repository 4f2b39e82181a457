// Whole files of text, in and out.
#pragma once

#include <filesystem>
#include <string>

#include "base/result.h"

namespace tessera::floor {

/// At most the first `most` bytes. Error: names the file and why it cannot be read.
[[nodiscard]] Result<std::string> loadText(const std::filesystem::path& path, std::size_t most);

enum class Replacing { Allowed, Refused };

/// Whether a file may be put there: nothing is there, or a file. A device would be gone when something else takes its
/// name. Error: says that `path`, or what it leads to as a link, is a folder, a device or the like.
[[nodiscard]] Result<void> replaceable(const std::filesystem::path& path);

/// Writes a temporary file beside `path`, syncs it and gives it its name: after a failure or a power cut either the old
/// file or the new one stands there whole. Error: what could not be written and why, what replaceable() says, or
/// that a file stands there already which may not be replaced; that file stands untouched.
[[nodiscard]] Result<void> saveText(const std::string& text, const std::filesystem::path& path, Replacing replacing);

}  // namespace tessera::floor
