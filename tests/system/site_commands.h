// Runs `tessera-cli site ...` in a folder of its own, as a script would.
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/exit_codes.h"
#include "system/program.h"

namespace tessera::system_test {

using Words = std::vector<std::string>;

class SiteCommands : public testing::Test {
protected:
  [[nodiscard]] std::string at(const std::string& name) const { return folder_.path().toStdString() + "/" + name; }
  static std::string bytesOf(const std::string& path) {
    std::ifstream in{path, std::ios::binary};
    return {std::istreambuf_iterator<char>{in}, {}};
  }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream{at(name), std::ios::binary} << text;
  }
  // Runs `site ...`: its standard output; complaints stay in errors().
  std::string run(Words words, int code) {
    words.insert(words.begin(), "site");
    Program cli{TESSERA_CLI, words};
    EXPECT_EQ(cli.exitCode(), code) << cli.errors() << cli.output();
    errors_ = cli.errors();
    return cli.output();
  }
  nlohmann::json json(Words words, int code) {
    words.emplace_back("--json");
    return nlohmann::json::parse(run(std::move(words), code), nullptr, false);
  }
  void makeFloor(const std::string& name, bool practice) {
    Words words{"new", at(name), "--tile-type", "60x60 one-in-two 15", "--columns", "5", "--rows", "4"};
    if (practice) words.emplace_back("--practice");
    run(words, cli::kDone);
  }
  [[nodiscard]] const std::string& errors() const { return errors_; }

private:
  QTemporaryDir folder_;
  std::string errors_;
};

}  // namespace tessera::system_test
