#include <gmock/gmock.h>
#include <toml++/toml.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "core/file_list.h"
#include "core/files.h"
#include "program.h"
#include "support/places.h"
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

std::string text_at(const toml::table& row, const std::string& key,
                    const std::string& otherwise = "true") {
  const std::optional<std::string> text = row[key].value<std::string>();
  return text ? *text : otherwise;
}

Input input_of(const toml::table& row, const std::string& kind) {
  const toml::node_view<const toml::node> view(row);
  Input input;
  input.name = kind + "_" + text_at(row, "name", "");
  input.setup = text_at(row, "setup");
  input.before = text_at(row, "before");
  input.run = text_at(row, "run", "");
  input.code = view["code"].value<int>().value_or(2);
  input.says = texts(view["says"]);
  input.seconds = view["seconds"].value<int>().value_or(20);
  return input;
}

std::string replaced(const std::string& text, const std::string& word, const std::string& by) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at; (at = text.find(word, from)) != std::string::npos; from = at + word.size())
    result.append(text, from, at - from).append(by);
  return result.append(text, from, std::string::npos);
}

/// Calls visit(row) for the rows of a list of a table, if there is one.
template <class Visit>
void for_rows(const toml::table& table, const char* list, const Visit& visit) {
  if (const toml::array* rows = table[list].as_array())
    for (const toml::node& row : *rows) visit(*row.as_table());
}

/// A reader given a file with a fault.
Input faulty_file(const toml::table& reader, const toml::table& fault, const std::string& kind) {
  const std::string file = text_at(reader, "file");
  const bool is_file = fault["is_file"].value<bool>().value_or(true);
  Input input;
  input.name = kind + "_" + text_at(reader, "name") + "_" + text_at(fault, "name");
  input.setup = text_at(reader, "setup") + "; " + replaced(text_at(fault, "setup"), "FILE", file);
  input.run = replaced(text_at(reader, "run"), "FILE", file);
  input.code = reader[is_file ? "code" : "code_without_file"].value<int>().value_or(4);
  for (const std::string& taken : texts(toml::node_view<const toml::node>(reader)["takes"]))
    if (taken == text_at(fault, "name")) input.code = 0;
  if (input.code != 0) input.says = {file};
  return input;
}

/// An option given each of a list of values.
void append_options(const toml::table& option, const std::string& kind,
                    std::vector<Input>& inputs) {
  int number = 0;
  for (const std::string& value : texts(toml::node_view<const toml::node>(option)["values"])) {
    Input input = input_of(option, kind);
    input.name.append("_").append(std::to_string(++number));
    input.run = replaced(input.run, "VALUE", quoted(value));
    inputs.push_back(input);
  }
}

void append_inputs(const fs::path& file, std::vector<Input>& inputs) {
  const toml::table table = toml::parse_file(file.string());
  const std::string kind = file.stem().string();
  for_rows(table, "input", [&](const auto& row) { inputs.push_back(input_of(row, kind)); });
  for_rows(table, "option", [&](const auto& row) { append_options(row, kind, inputs); });
  for_rows(table, "reader", [&](const auto& reader) {
    for_rows(table, "fault",
             [&](const auto& fault) { inputs.push_back(faulty_file(reader, fault, kind)); });
  });
}

std::vector<Input> all_inputs() {
  std::vector<Input> inputs;
  for (const fs::path& file : files_below(tests_folder() / "hostile"))
    if (file.extension() == ".toml") append_inputs(tests_folder() / "hostile" / file, inputs);
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
  write("scene.toml", read_file(tests_folder() / "hostile/scene.toml.txt"));
  fs::create_directory(folder_ / "outside");
  write("outside/precious", "mine");
  const std::string make =
      "make() { python3 " + quoted((tests_folder() / "hostile/make.py").string()) + " \"$@\"; }; ";
  const std::string ours = "ours() { mkdir -p out/tasks && : >out/tasks/lock; }; ";
  const Result setup = shell(make + ours + input.setup);
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
