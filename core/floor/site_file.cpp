// Files on disk: read whole, written so that nothing half-written is ever seen.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <system_error>

#include "floor/json_node.h"
#include "floor/site_json.h"
#include "floor/text_file.h"

namespace tessera::floor {
namespace {

namespace fs = std::filesystem;

// What a person meets is said in the window's language; the rest as the system has it.
Sentence reason(int error) {
  switch (error) {
    case ENOENT:
      return phrase("Core", "No such file or directory");
    case EACCES:
    case EPERM:
      return phrase("Core", "Permission denied");
    case ENOSPC:
    case EDQUOT:
      return phrase("Core", "No space left on device");
    case EROFS:
      return phrase("Core", "Read-only file system");
    case EIO:
      return phrase("Core", "Input/output error");
    default:
      return std::generic_category().message(error);
  }
}

// A temporary file that is gone again unless it took its final name.
class TemporaryFile {
public:
  explicit TemporaryFile(const fs::path& beside) : name_{beside.string() + ".XXXXXX"} {
    handle_ = ::mkstemp(name_.data());
    exists_ = handle_ >= 0;
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (handle_ >= 0) ::close(handle_);
    if (exists_) ::unlink(name_.c_str());
  }
  [[nodiscard]] bool open() const { return exists_; }
  [[nodiscard]] bool write(const std::string& text) const {
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t n = ::write(handle_, text.data() + done, text.size() - done);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return false;
      done += static_cast<std::size_t>(n);
    }
    return true;
  }
  // mkstemp lets nobody else read: give the rights of the file that is replaced, or those of any new file.
  [[nodiscard]] bool rights(const fs::path& of) const {
    struct stat old {};
    if (::stat(of.c_str(), &old) == 0) return ::fchmod(handle_, old.st_mode & 07777) == 0;
    return ::fchmod(handle_, 0640) == 0;
  }
  [[nodiscard]] bool sync() const { return ::fsync(handle_) == 0; }
  [[nodiscard]] bool rename(const fs::path& to, Replacing replacing) {
    if (replacing == Replacing::Allowed) {
      if (::rename(name_.c_str(), to.c_str()) != 0) return false;
      exists_ = false;
      return true;
    }
    // A second name that must be new; the temporary one then goes away. Unlike a look beforehand nothing can come
    // between.
    return ::link(name_.c_str(), to.c_str()) == 0;
  }

private:
  std::string name_;
  int handle_ = -1;
  bool exists_ = false;
};

// A rename is safe from a power cut once its folder is on disk. Not every file system can; the file is whole all the
// same.
void syncFolder(const fs::path& folder) {
  const int handle = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (handle < 0) return;
  static_cast<void>(::fsync(handle));
  ::close(handle);
}

}  // namespace

Result<std::string> loadText(const fs::path& path, std::size_t most) {
  std::error_code error;
  if (fs::is_directory(path, error))
    return failure(phrase("Core", "%1: expected a file, found a folder.").with(path.string()));
  std::ifstream in{path, std::ios::binary};
  if (!in) return failure(phrase("Core", "%1: cannot be read: %2.").with(path.string(), reason(errno)));
  // Reads no more than will be taken, whatever the file's size says (it may be a device).
  std::string text;
  std::array<char, 65536> block{};
  while (in && text.size() < most) {
    in.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  if (in.bad()) return failure(phrase("Core", "%1: cannot be read to its end.").with(path.string()));
  return text;
}

Result<void> replaceable(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);  // of what a link leads to
  if (!fs::exists(status) || fs::is_regular_file(status)) return {};
  return failure(
      phrase("Core", "%1: is no file but a folder, a device or the like, which is not replaced.").with(path.string()));
}

Result<void> saveText(const std::string& text, const fs::path& path, Replacing replacing) {
  // A link stays a link: what it leads to is replaced.
  std::error_code error;
  const fs::path target = fs::is_symlink(path, error) ? fs::weakly_canonical(path, error) : path;
  const auto failed = [&path](const Sentence& what) {
    return failure(phrase("Core", "%1: %2: %3. The file was not changed.").with(path.string(), what, reason(errno)));
  };
  if (const auto fit = replaceable(path); !fit) return fit;
  if (replacing == Replacing::Refused && fs::exists(target, error))
    return failure(phrase("Core", "%1: the file is there already.").with(path.string()));
  TemporaryFile file{target};
  if (!file.open()) return failed(phrase("Core", "a temporary file beside it cannot be made"));
  if (!file.write(text)) return failed(phrase("Core", "cannot be written"));
  if (!file.rights(target)) return failed(phrase("Core", "cannot be given its rights"));
  if (!file.sync()) return failed(phrase("Core", "cannot be brought to disk"));
  if (!file.rename(target, replacing)) {
    if (errno == EEXIST) return failure(phrase("Core", "%1: the file is there already.").with(path.string()));
    return failed(phrase("Core", "cannot be replaced"));
  }
  syncFolder(target.parent_path());
  return {};
}

Result<Site> loadSite(const fs::path& path) {
  const auto text = loadText(path, kMostJson + 1);
  if (!text) return tl::unexpected{text.error()};
  return parseSite(*text, path.string());
}

Result<void> saveSite(const Site& site, const fs::path& path) {
  return saveText(writeSite(site), path, Replacing::Allowed);
}

}  // namespace tessera::floor
