#include "cli/command_facts.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

#include "cli/command_table.h"

namespace wold::cli {
namespace {

/// "a|b|c" of lower-case words; "FILE.svg|FILE.csv" are none.
std::vector<std::string> words_of(const std::string& value) {
  const bool is_choice =
      value.find('|') != std::string::npos &&
      std::ranges::none_of(value, [](unsigned char c) { return std::isupper(c); });
  return is_choice ? CLI::detail::split(value, '|') : std::vector<std::string>{};
}

/// The names of values without what CLI11 adds about checks.
std::string value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));
}

pages::OptionFacts facts_of(const CLI::Option& option) {
  pages::OptionFacts facts;
  facts.name = option.get_positional() ? option.get_name(/*positional=*/true)
                                       : "--" + option.get_lnames().front();
  facts.value = value_of(option);
  facts.doc = option.get_description();
  facts.usual = option.get_default_str();
  facts.words = words_of(facts.value);
  facts.required = option.get_required();
  facts.repeats = option.get_items_expected_max() > 1;
  return facts;
}

pages::CommandFacts facts_of(const CLI::App& app) {
  pages::CommandFacts facts;
  facts.name = app.get_name();
  facts.summary = app.get_description();
  for (const CLI::Option* option : app.get_options())
    (option->get_positional() ? facts.arguments : facts.options).push_back(facts_of(*option));
  return facts;
}

}  // namespace

std::vector<pages::CommandFacts> command_facts(const CLI::App& program) {
  std::vector<pages::CommandFacts> all = {facts_of(program)};
  for (const Command& command : command_table()) {
    all.push_back(facts_of(*program.get_subcommand(command.name)));
    all.back().example = command.example;
  }
  return all;
}

}  // namespace wold::cli
