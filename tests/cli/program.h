#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <filesystem>
#include <string>

/// The program as its user sees it: exit code, stdout and stderr.
namespace wold::test {

namespace fs = std::filesystem;

struct Result {
  int code = -1;  ///< -1: it did not end by itself
  std::string out;
  std::string err;
};

/// A shell command at work in a process of its own.
class Running {
 public:
  /// Starts it in `folder`; its output goes to .out and .err there.
  Running(fs::path folder, const std::string& command);
  /// Kills what was not waited for.
  ~Running();
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  void send(int signal) const;
  /// A process that it has started, such as a renderer; 0 when there is none.
  pid_t child() const;
  /// What stands on stderr so far.
  std::string messages() const;
  Result finish();

 private:
  fs::path folder_;
  pid_t process_ = -1;
};

/// A folder of its own for every test, in which `wold` runs.
class Program : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// The command line of `wold ARGUMENTS`, which may redirect the output; `environment` is a list
  /// of NAME=VALUE.
  static std::string command(const std::string& arguments, const std::string& environment = "");

  /// Runs a command to its end in the test's folder.
  Result shell(const std::string& command) const;
  Result wold(const std::string& arguments, const std::string& environment = "") const {
    return shell(command(arguments, environment));
  }

  /// Whether a program is on this machine.
  bool is_installed(const std::string& program) const {
    return shell("command -v " + program).code == 0;
  }

  /// Whether a renderer is on this machine and should make every picture. Debian's Blender does not
  /// from 5.0 on: it shows no volumes. An older one that says so is at fault.
  bool can_render(const std::string& renderer) const;

  void write(const std::string& name, const std::string& text) const;

  fs::path folder_;
};

/// As one word for the shell.
std::string quoted(const std::string& text);

void expect_contains(const std::string& text, const std::string& part);

}  // namespace wold::test
