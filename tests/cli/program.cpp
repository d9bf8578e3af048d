#include "program.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "support/places.h"

namespace wold::test {

Running::Running(fs::path folder, const std::string& command) : folder_(std::move(folder)) {
  fs::remove(folder_ / ".err");  // of an earlier command, which would be taken for this one's
  const std::string line = "cd '" + folder_.string() + "' && exec >.out 2>.err && " + command;
  process_ = ::fork();
  if (process_ != 0) return;
  ::execl("/bin/sh", "sh", "-c", line.c_str(), static_cast<char*>(nullptr));
  ::_exit(127);
}

Running::~Running() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, nullptr, 0);
}

void Running::send(int signal) const { ::kill(process_, signal); }

pid_t Running::child() const {
  std::error_code gone;
  const fs::path threads = "/proc/" + std::to_string(process_) + "/task";
  for (const auto& thread : fs::directory_iterator(threads, gone))
    if (pid_t child = 0; std::ifstream(thread.path() / "children") >> child) return child;
  return 0;
}

std::string Running::messages() const {
  return fs::exists(folder_ / ".err") ? read_file(folder_ / ".err") : "";
}

Result Running::finish() {
  int status = 0;
  ::waitpid(process_, &status, 0);
  process_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_file(folder_ / ".out"), messages()};
}

void Program::SetUp() {
  std::string pattern = (fs::path(testing::TempDir()) / "wold cli XXXXXX").string();
  folder_ = ::mkdtemp(pattern.data());
  // What renderers can do is asked once for all tests, and not kept among the user's own files.
  ::setenv("XDG_CACHE_HOME", (build_folder() / "test_cache").c_str(), 1);
}

void Program::TearDown() { fs::remove_all(folder_); }

std::string Program::command(const std::string& arguments, const std::string& environment) {
  return "exec env " + environment + " '" + wold_program().string() + "' " + arguments;
}

Result Program::shell(const std::string& command) const {
  return Running(folder_, command).finish();
}

bool Program::can_render(const std::string& renderer) const {
  const auto found = nlohmann::json::parse(wold("doctor --json").out);
  return std::ranges::any_of(found.at("renderers"), [&](const nlohmann::json& one) {
    return one.at("renderer") == renderer && one.at("program").is_string() &&
           (one.at("state") == "complete" || std::stoi(one.at("version").get<std::string>()) < 5);
  });
}

void Program::write(const std::string& name, const std::string& text) const {
  write_file(folder_ / name, text);
}

std::string quoted(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in:\n" << text;
}

}  // namespace wold::test
