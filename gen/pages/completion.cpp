#include "pages/completion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "core/error.h"
#include "scene/registry.h"

namespace wold::pages {
namespace {

using Commands = std::span<const CommandFacts>;

/// What a value is, as far as a shell can help with it.
enum class Sort { none, flag, words, keys, file, folder, scene };

/// By the names that the help shows for values and arguments.
Sort sort_of(const OptionFacts& option) {
  const bool is_argument = !option.name.starts_with("--");
  const std::string& name = is_argument ? option.name : option.value;
  if (name.empty()) return Sort::flag;
  if (!option.words.empty()) return Sort::words;
  if (name == "KEY=VALUE") return Sort::keys;
  if (name == "DIR") return Sort::folder;
  if (name == "SCENE") return Sort::scene;
  return name.starts_with("FILE") || name == "GOT" || name == "WANT" ? Sort::file : Sort::none;
}

/// All that --set can be followed by: "grass.blades=" for a number, "render.grass=auto" for a word;
/// of tables that may stand many times the first one's.
std::vector<std::string> settings() {
  std::vector<std::string> all;
  const auto add = [&](const scene::Key& key) {
    all.push_back(key.name + "=");
    if (key.kind == scene::Kind::word || key.kind == scene::Kind::words)
      for (const std::string& word : key.words) all.push_back(fmt::format("{}={}", key.name, word));
  };
  for (const scene::Key& key : scene::registry()) add(key);
  for (const scene::TableArray& array : scene::table_arrays())
    for (const scene::Key& key : scene::item_keys(array, 0)) add(key);
  return all;
}

/// In single quotes; all that is written here is without them, or they are made typographic.
std::string quoted(const std::string& text) {
  std::string safe;
  for (const char c : text) safe += c == '\'' ? std::string("\u2019") : std::string(1, c);
  return "'" + safe + "'";
}

// ---- bash

std::string bash_case(const std::string& pattern, const std::string& action) {
  return fmt::format("    {}) {} ;;\n", pattern, action);
}

/// What follows an option or stands as an argument.
std::string bash_answer(const OptionFacts& option) {
  switch (sort_of(option)) {
    case Sort::words:
      return fmt::format("_wold_words '{}'", fmt::join(option.words, " "));
    case Sort::keys:
      return "_wold_settings";
    case Sort::folder:
      return "_wold_files -d";
    case Sort::scene:
      return "_wold_files -f -X '!*.toml'";
    case Sort::file:
      return "_wold_files -f";
    default:
      return ":";
  }
}

std::string bash_command(const CommandFacts& command) {
  std::string options, answers;
  for (const OptionFacts& option : command.options) {
    options += (options.empty() ? "" : " ") + option.name;
    if (sort_of(option) != Sort::flag)
      answers += bash_case(command.name + ":" + option.name, bash_answer(option) + "; return");
  }
  const std::string arguments =
      command.arguments.empty() ? ":" : bash_answer(command.arguments.front());
  return answers + bash_case(command.name + ":*",
                             fmt::format("if [[ $cur == -* ]]; then _wold_words '{}'; else {}; fi",
                                         options, arguments));
}

/// The words are taken from the line itself, because bash also parts them at '='.
std::string bash_script(Commands commands) {
  std::string names, options, cases;
  for (const OptionFacts& option : commands.front().options) {
    options += option.name + " ";
    cases += bash_case(option.name + ":*", bash_answer(option));
  }
  for (const CommandFacts& command : commands.subspan(1)) {
    names += command.name + " ";
    cases += bash_command(command);
  }
  return fmt::format(R"(# Completion of wold for bash, as `wold --completion bash` writes it.
_wold_words() {{ mapfile -t COMPREPLY < <(compgen -W "$1" -- "$cur"); }}
_wold_files() {{
  compopt -o filenames
  mapfile -t COMPREPLY < <(compgen "$@" -- "$cur"; [ "$1" = -d ] || compgen -d -- "$cur")
}}
_wold_settings() {{
  compopt -o nospace
  _wold_words '{2}'
  [[ $cur == *=* ]] && COMPREPLY=("${{COMPREPLY[@]#*=}}")
  return 0
}}
_wold() {{
  local line=${{COMP_LINE:0:COMP_POINT}} words cur prev
  read -ra words <<< "$line"
  [[ $line == *' ' ]] && words+=('')
  cur=${{words[-1]}} prev=${{words[-2]}}
  COMPREPLY=()
  if [ ${{#words[@]}} -le 2 ]; then _wold_words '{0}{1}'; return; fi
  case ${{words[1]}}:$prev in
{3}  esac
}}
complete -F _wold wold
)",
                     names, options, fmt::join(settings(), " "), cases);
}

// ---- zsh

/// In a description of _arguments brackets and colons have a meaning.
std::string zsh_text(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') safe += '\\';
    safe += c;
  }
  return safe;
}

std::string zsh_action(const OptionFacts& option) {
  switch (sort_of(option)) {
    case Sort::words:
      return fmt::format("({})", fmt::join(option.words, " "));
    case Sort::keys:
      return "_wold_settings";
    case Sort::folder:
      return "_files -/";
    case Sort::scene:
      return "_files -g \"*.toml\"";
    case Sort::file:
      return "_files";
    default:
      return " ";
  }
}

std::string zsh_option(const OptionFacts& option) {
  const std::string named = fmt::format("{}{}[{}]", sort_of(option) == Sort::keys ? "*" : "",
                                        option.name, zsh_text(option.doc));
  if (sort_of(option) == Sort::flag) return quoted(named);
  return quoted(fmt::format("{}:{}:{}", named, zsh_text(option.value), zsh_action(option)));
}

std::string zsh_argument(const OptionFacts& argument) {
  return quoted(fmt::format("{}:{}:{}", argument.repeats ? "*" : "", zsh_text(argument.name),
                            zsh_action(argument)));
}

std::string zsh_command(const CommandFacts& command) {
  std::string text = fmt::format("        {}) _arguments", command.name);
  for (const OptionFacts& option : command.options)
    text += fmt::format(" \\\n          {}", zsh_option(option));
  for (const OptionFacts& argument : command.arguments)
    text += fmt::format(" \\\n          {}", zsh_argument(argument));
  return text + " ;;\n";
}

std::string zsh_script(Commands commands) {
  std::string names, options, cases;
  for (const OptionFacts& option : commands.front().options)
    options += fmt::format(" \\\n    {}", zsh_option(option));
  for (const CommandFacts& command : commands.subspan(1)) {
    names += fmt::format("    {}\n", quoted(command.name + ":" + zsh_text(command.summary)));
    cases += zsh_command(command);
  }
  return fmt::format(R"(#compdef wold
# Completion of wold for zsh, as `wold --completion zsh` writes it.
_wold_settings() {{
  local -a settings=('{2}')
  compadd -S '' -- $settings
}}
_wold() {{
  local context state line
  local -a commands=(
{0}  )
  _arguments -C{1} \
    '1:command:->command' '*::argument:->argument'
  case $state in
    command) _describe command commands ;;
    argument)
      case $words[1] in
{3}      esac ;;
  esac
}}
if [ "$funcstack[1]" = _wold ]; then _wold "$@"; else compdef _wold wold; fi
)",
                     names, options, fmt::join(settings(), "' '"), cases);
}

// ---- fish

std::string fish_values(const OptionFacts& option) {
  switch (sort_of(option)) {
    case Sort::flag:
      return "";
    case Sort::words:
      return fmt::format(" -x -a '{}'", fmt::join(option.words, " "));
    case Sort::keys:
      return " -x -a '(__wold_settings)'";
    case Sort::folder:
      return " -x -a '(__fish_complete_directories)'";
    case Sort::file:
      return " -r -F";
    default:
      return " -x";
  }
}

std::string fish_option(const std::string& condition, const OptionFacts& option) {
  return fmt::format("complete -c wold -n '{}' -l {}{} -d {}\n", condition, option.name.substr(2),
                     fish_values(option), quoted(option.doc));
}

std::string fish_argument(const std::string& condition, const OptionFacts& argument) {
  switch (sort_of(argument)) {
    case Sort::scene:
      return fmt::format("complete -c wold -n '{}' -k -x -a '(__fish_complete_suffix .toml)'\n",
                         condition);
    case Sort::folder:
      return fmt::format("complete -c wold -n '{}' -x -a '(__fish_complete_directories)'\n",
                         condition);
    case Sort::file:
      return fmt::format("complete -c wold -n '{}' -F\n", condition);
    default:
      return "";
  }
}

std::string fish_settings() {
  std::string text = "function __wold_settings\n";
  for (const std::string& setting : settings()) text += fmt::format("  echo '{}'\n", setting);
  return text + "end\n";
}

std::string fish_script(Commands commands) {
  std::string text = "# Completion of wold for fish, as `wold --completion fish` writes it.\n" +
                     fish_settings() + "complete -c wold -f\n";
  for (const OptionFacts& option : commands.front().options)
    text += fish_option("__fish_use_subcommand", option);
  for (const CommandFacts& command : commands.subspan(1)) {
    const std::string condition = "__fish_seen_subcommand_from " + command.name;
    text += fmt::format("complete -c wold -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        quoted(command.summary));
    for (const OptionFacts& option : command.options) text += fish_option(condition, option);
    if (!command.arguments.empty()) text += fish_argument(condition, command.arguments.front());
  }
  return text;
}

const std::map<std::string, std::string (*)(Commands)>& writers() {
  static const std::map<std::string, std::string (*)(Commands)> all = {
      {"bash", bash_script}, {"fish", fish_script}, {"zsh", zsh_script}};
  return all;
}

}  // namespace

const std::vector<std::string>& completion_shells() {
  static const std::vector<std::string> shells = {"bash", "zsh", "fish"};
  return shells;
}

std::string completion(Commands commands, const std::string& shell) {
  const auto writer = writers().find(shell);
  if (writer == writers().end())
    throw InputError(fmt::format("--completion: found {}, expected one of: {}", shell,
                                 fmt::join(completion_shells(), ", ")));
  return writer->second(commands);
}

}  // namespace wold::pages
