// Files on disk: whole or not at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <fstream>

#include "floor/random_site.h"
#include "floor/site_json.h"
#include "floor/text_file.h"

namespace tessera::floor {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class SiteFile : public ::testing::Test {
protected:
  SiteFile() {
    std::string pattern = (fs::temp_directory_path() / "tessera-site-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~SiteFile() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] auto count() const { return std::distance(fs::directory_iterator{folder_}, fs::directory_iterator{}); }

private:
  fs::path folder_;
};

TEST_F(SiteFile, isReadBackAndLeavesNothingBeside) {
  const Site site = randomSite(1);
  ASSERT_TRUE(saveSite(site, file("a.tessera.json")));
  const auto back = loadSite(file("a.tessera.json"));
  ASSERT_TRUE(back) << back.error().sentence;
  EXPECT_EQ(writeSite(*back), writeSite(site));
  ASSERT_TRUE(saveSite(randomSite(2), file("a.tessera.json")));
  EXPECT_EQ(writeSite(*loadSite(file("a.tessera.json"))), writeSite(randomSite(2)));
  EXPECT_EQ(count(), 1);
}

TEST_F(SiteFile, errorsNameTheFile) {
  EXPECT_THAT(loadSite(file("none.json")).error().sentence,
              AllOf(HasSubstr(file("none.json").string()), HasSubstr("No such file")));
  EXPECT_THAT(loadSite(file("")).error().sentence, HasSubstr("folder"));
  EXPECT_THAT(saveSite(randomSite(1), file("none/a.json")).error().sentence,
              AllOf(HasSubstr("none/a.json"), HasSubstr("No such file")));
  std::ofstream{file("bad.json")} << "{";
  EXPECT_THAT(loadSite(file("bad.json")).error().sentence, HasSubstr("bad.json: line 1"));
}

TEST_F(SiteFile, anEndlessFileIsNotReadToItsEnd) {
  EXPECT_THAT(loadSite("/dev/zero").error().sentence, HasSubstr("64 MiB"));
}

TEST_F(SiteFile, whenTheDiskIsFullTheOldFileStands) {
  const fs::path path = file("a.tessera.json");
  ASSERT_TRUE(saveSite(randomSite(1), path));
  // A limit on the size of files that may be written acts as a full disk does: write() fails half way.
  ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  ::getrlimit(RLIMIT_FSIZE, &before);
  const rlimit small{100, before.rlim_max};
  ::setrlimit(RLIMIT_FSIZE, &small);
  const auto saved = saveSite(randomSite(2), path);
  ::setrlimit(RLIMIT_FSIZE, &before);
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().sentence, AllOf(HasSubstr(path.string()), HasSubstr("was not changed")));
  EXPECT_EQ(writeSite(*loadSite(path)), writeSite(randomSite(1)));
  EXPECT_EQ(count(), 1) << "no temporary file is left";
}

TEST_F(SiteFile, keepsTheRightsOfTheFileAndHidesANewOnesKeysFromOthers) {
  const fs::path path = file("a.tessera.json");
  ASSERT_TRUE(saveSite(randomSite(1), path));
  EXPECT_EQ(fs::status(path).permissions() & fs::perms::others_all, fs::perms::none);
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(saveSite(randomSite(2), path));
  EXPECT_EQ(fs::status(path).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(SiteFile, whatIsNoFileIsNotReplaced) {
  const fs::path pipe = file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  fs::create_directory(file("folder"));
  fs::create_symlink("pipe", file("link"));
  fs::create_symlink("link", file("link to the link"));
  // Asked about alone: nothing is ever written to a device here.
  fs::create_symlink("/dev/null", file("device"));
  for (const char* name : {"pipe", "folder", "link", "link to the link", "device"}) {
    const auto fit = replaceable(file(name));
    ASSERT_FALSE(fit) << name;
    EXPECT_THAT(fit.error().sentence, AllOf(HasSubstr(file(name).string()), HasSubstr("is not replaced"))) << name;
  }
  for (const char* name : {"pipe", "folder", "link", "link to the link"}) {
    const auto saved = saveSite(randomSite(1), file(name));
    ASSERT_FALSE(saved) << name;
    EXPECT_THAT(saved.error().sentence, HasSubstr("is not replaced")) << name;
  }
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_TRUE(fs::is_directory(file("folder")));
  EXPECT_EQ(count(), 5) << "and nothing is left beside";
  EXPECT_TRUE(replaceable(file("none.json")));
}

TEST_F(SiteFile, aLinkStaysALink) {
  ASSERT_TRUE(saveSite(randomSite(1), file("real.json")));
  fs::create_symlink("real.json", file("link.json"));
  ASSERT_TRUE(saveSite(randomSite(2), file("link.json")));
  EXPECT_TRUE(fs::is_symlink(file("link.json")));
  EXPECT_EQ(writeSite(*loadSite(file("real.json"))), writeSite(randomSite(2)));
}

}  // namespace
}  // namespace tessera::floor
