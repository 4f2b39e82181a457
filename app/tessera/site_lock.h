// Tells two running copies of the program apart that have the same site open: the later one is told of the earlier.
#pragma once

#include <QLockFile>
#include <memory>
#include <optional>
#include <string>

namespace tessera::desktop {

/// Among the programs of this user on this machine. A copy that died holds nothing.
class SiteLock {
public:
  /// From now on the site that is kept under this key is ours, unless another copy has it, and the one before is not.
  /// Where no lock can be made (a full disk, say) nobody is told of anybody.
  void take(const std::string& key);
  /// The process of another copy that has this site open; nullopt: none.
  [[nodiscard]] std::optional<qint64> holderOf(const std::string& key) const;

private:
  std::unique_ptr<QLockFile> lock_;
  std::string key_;
};

}  // namespace tessera::desktop
