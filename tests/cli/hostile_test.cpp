#include <gmock/gmock.h>
#include <toml++/toml.h>

#include <chrono>
#include <string>
#include <vector>

#include "core/file_list.h"
#include "core/files.h"
#include "program.h"
#include "support/sanitized.h"

/// What strangers' files and users' slips may and may not do: the rows of tests/hostile/*.toml.
namespace wold::test {
namespace {

/// A row: see tests/hostile/README.md.
struct Input {
  std::string name;
  std::string setup;
  std::string before;
  std::string run;
  int code = 2;
  std::vector<std::string> says;
  int seconds = 20;
};

void PrintTo(const Input& input, std::ostream* out) { *out << input.run; }

std::vector<std::string> texts(const toml::node_view<const toml::node>& list) {
  std::vector<std::string> all;
  if (const toml::array* array = list.as_array())
    for (const toml::node& text : *array) all.push_back(text.value_or(std::string()));
  return all;
}

void append_inputs(const fs::path& file, std::vector<Input>& inputs) {
  const toml::table table = toml::parse_file(file.string());
  const std::string kind = file.stem().string();
  for (const toml::node& node : *table["input"].as_array()) {
    const toml::table& row = *node.as_table();
    const toml::node_view<const toml::node> view(row);
    Input input;
    input.name = kind + "_" + view["name"].value_or(std::string());
    input.setup = view["setup"].value_or(std::string("true"));
    input.before = view["before"].value_or(std::string("true"));
    input.run = view["run"].value_or(std::string());
    input.code = view["code"].value_or(2);
    input.says = texts(view["says"]);
    input.seconds = view["seconds"].value_or(20);
    inputs.push_back(input);
  }
}

std::vector<Input> all_inputs() {
  std::vector<Input> inputs;
  for (const fs::path& file : files_below(fs::path(WOLD_TESTS_DIR) / "hostile"))
    if (file.extension() == ".toml")
      append_inputs(fs::path(WOLD_TESTS_DIR) / "hostile" / file, inputs);
  return inputs;
}

class Hostile : public Program, public testing::WithParamInterface<Input> {
 protected:
  /// What lies outside of the output folder, which nothing may change.
  std::string outside() const {
    return shell("cd outside && find . -printf '%y %p %l\\n' -type f -exec cat {} + | sort").out;
  }
};

TEST_P(Hostile, IsTakenAsTheTableSays) {
  const Input& input = GetParam();
  write("scene.toml", read_file(fs::path(WOLD_TESTS_DIR) / "hostile/scene.toml.txt"));
  fs::create_directory(folder_ / "outside");
  write("outside/precious", "mine");
  const std::string make =
      "make() { python3 " + quoted(WOLD_TESTS_DIR "/hostile/make.py") + " \"$@\"; }; ";
  const Result setup = shell(make + input.setup);
  ASSERT_EQ(setup.code, 0) << setup.err;
  const std::string before = outside();
  const auto begin = std::chrono::steady_clock::now();
  const std::string memory = sanitized ? "" : "ulimit -v 8000000; ";
  const std::string run = memory + input.before + "\n" + command(input.run);
  const Result result =
      shell("timeout -k 1 " + std::to_string(3 * input.seconds) + " sh -c " + quoted(run));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  const std::string printed = result.out + result.err;
  EXPECT_EQ(result.code, input.code) << printed;
  for (const std::string& words : input.says) EXPECT_THAT(printed, testing::HasSubstr(words));
  EXPECT_LT(took.count(), input.seconds);
  EXPECT_EQ(outside(), before);
  for (const char* raw : {"terminate called", "filesystem error", "/vsimem", "std::", "\x1b"})
    EXPECT_THAT(printed, testing::Not(testing::HasSubstr(raw)));
}

INSTANTIATE_TEST_SUITE_P(Table, Hostile, testing::ValuesIn(all_inputs()),
                         [](const auto& each) { return each.param.name; });

}  // namespace
}  // namespace wold::test
