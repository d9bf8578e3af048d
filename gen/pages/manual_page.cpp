#include "pages/manual_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "core/version.h"
#include "pages/command_descriptions.h"
#include "scene/registry.h"

namespace wold::pages {
namespace {

/// As troff has it: nothing of the text is taken for a request or a hyphen of prose.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else if (c == '^')
      result += "\\(ha";
    else if (c == '~')
      result += "\\(ti";
    else if (c == '\n')
      result += ' ';
    else
      result += c;
  }
  return result.starts_with('.') || result.starts_with('\'') ? fmt::format("\\&{}", result)
                                                             : result;
}

std::string bold(std::string_view text) { return fmt::format("\\fB{}\\fR", escaped(text)); }
std::string italic(std::string_view text) { return fmt::format("\\fI{}\\fR", escaped(text)); }

std::string section(std::string_view title) { return fmt::format(".SH {}\n", title); }
std::string subsection(std::string_view title) {
  return fmt::format(".SS \"{}\"\n", escaped(title));
}

/// A term and what it means.
std::string item(const std::string& term, std::string_view meaning) {
  return fmt::format(".TP\n{}\n{}\n", term, escaped(meaning));
}

std::string sentence(std::string text) {
  if (text.empty()) return text;
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  if (text.back() != '.') text += '.';
  return text;
}

std::string item(const OptionFacts& option) {
  std::string term = bold(option.name);
  if (!option.value.empty() && option.name.starts_with("--"))
    term += fmt::format(" {}", italic(option.value));
  const std::string usual = option.usual.empty() ? "" : fmt::format(" ({})", option.usual);
  return item(term, sentence(option.doc + usual));
}

std::string synopsis(const CommandFacts& command) {
  std::string text = fmt::format("{} {}", bold("wold"), bold(command.name));
  if (!command.options.empty()) text += fmt::format(" [{}]", italic("options"));
  for (const OptionFacts& argument : command.arguments)
    text += fmt::format(" {}{}", italic(argument.name), argument.repeats ? "..." : "");
  return text + "\n";
}

/// Options that print a page and do nothing.
bool is_page(const OptionFacts& option) {
  return option.name == "--help" || option.name == "--man";
}

std::string options_text(const CommandFacts& command) {
  std::string text;
  for (const OptionFacts& argument : command.arguments) text += item(argument);
  for (const OptionFacts& option : command.options)
    if (!is_page(option)) text += item(option);
  return text;
}

std::string example_text(const CommandFacts& command) {
  return fmt::format(".EX\n{}\n.EE\n", escaped(command.example));
}

std::string command_text(const CommandFacts& command) {
  return subsection(fmt::format("wold {}", command.name)) + escaped(sentence(command.summary)) +
         "\n" + options_text(command) + ".IP\n" + example_text(command);
}

/// The page's first line, as man(1) wants it.
std::string title(const std::string& name) {
  return fmt::format(".TH {} 1 \"\" \"Wold {}\" \"User Commands\"\n", name, version);
}

std::string key_text(const scene::Key& key, const scene::Scene& defaults) {
  return item(bold(key.name), fmt::format("{} Accepts {}. Default: {}.", key.doc, expected(key),
                                          scene::toml_text(key.get(defaults))));
}

std::string keys_text() {
  scene::Scene defaults;
  std::string text, table = "none yet";
  for (const scene::Key& key : scene::registry()) {
    if (const std::string next(scene::table_of(key.name)); next != table)
      text += subsection((table = next).empty() ? "Top level" : fmt::format("[{}]", next));
    text += key_text(key, defaults);
  }
  for (const scene::TableArray& array : scene::table_arrays()) {
    text += subsection(fmt::format("[[{}]], once for each {}, at most {}", array.name, array.item,
                                   array.max_items));
    array.append(defaults);
    for (const scene::Key& key : array.keys(0)) text += key_text(key, defaults);
  }
  return text;
}

std::string exit_text() {
  return item("0", "Done.") + item("1", "Compared and different.") +
         item("2", "The command line or the scene is wrong; nothing was written.") +
         item("3",
              "A renderer is missing, failed, timed out or produced no valid picture; its log is "
              "named.") +
         item("4", "Reading or writing files failed.") +
         item("130", "Interrupted; the same command goes on where it stopped.");
}

std::string files_text() {
  return item(italic("out/NAME/frames/"), "The pictures, by renderer, one per frame.") +
         item(italic("out/NAME/blender/, out/NAME/povray/"),
              "Scenes that work on their own, copied to a machine that has only the renderer.") +
         item(italic("out/NAME/manifest.json"), "When all is done: every file that was written.") +
         item(italic("out/NAME/logs/"), "The renderers' own words.");
}

}  // namespace

std::string manual_page(std::span<const CommandFacts> commands) {
  const CommandFacts& program = commands.front();
  std::string text = title("WOLD");
  text += section("NAME") + "wold \\- a landscape that ages, for Blender and POV\\-Ray\n";
  text += section("SYNOPSIS") + ".nf\n";
  for (const CommandFacts& command : commands.subspan(1)) text += synopsis(command);
  text += ".fi\n" + section("DESCRIPTION") +
          "Turns one scene file (TOML) into a landscape that withers, with clouds and snow, and "
          "writes scenes for Blender (OpenVDB) and POV\\-Ray (df3) that show the same picture.\n"
          "Data goes to stdout, messages and progress to stderr.\n";
  text += section("OPTIONS");
  for (const OptionFacts& option : program.options) text += item(option);
  text += section("COMMANDS");
  for (const CommandFacts& command : commands.subspan(1)) text += command_text(command);
  text += section("\"KEYS OF A SCENE\"") +
          escaped(
              "What a scene file does not say is as it is by default. --set TABLE.KEY=VALUE "
              "wins over the file.") +
          "\n" + keys_text();
  return text + section("FILES") + files_text() + section("\"EXIT STATUS\"") + exit_text();
}

std::string command_page(const CommandFacts& command) {
  std::string name = fmt::format("wold-{}", command.name);
  std::string text =
      section("NAME") + fmt::format("{} \\- {}\n", escaped(name), escaped(command.summary));
  text += section("SYNOPSIS") + synopsis(command);
  text += section("DESCRIPTION") + escaped(command_description(command.name)) + "\n";
  text += section("OPTIONS") + options_text(command);
  text += section("EXAMPLE") + example_text(command);
  text += section("\"EXIT STATUS\"") + exit_text();
  text += section("\"SEE ALSO\"") + bold("wold") + "(1), which has every key of a scene\n";
  std::ranges::transform(name, name.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return title(escaped(name)) + text;
}

}  // namespace wold::pages
