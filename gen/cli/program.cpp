#include "cli/program.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <memory>
#include <new>

#include "cli/command_facts.h"
#include "cli/command_table.h"
#include "cli/commands.h"
#include "console/output.h"
#include "console/standard_streams.h"
#include "core/interrupt.h"
#include "core/parallel.h"
#include "pages/completion.h"
#include "pages/manual_page.h"
#include "scene/nearest.h"
#include "scene/text.h"

namespace wold::cli {
namespace {

using Action = std::function<ExitCode()>;

/// The command line's declaration and, once parsed, what it asks for.
struct CommandLine {
  CLI::App app{"Wold: a withering meadow on a hillside, for Blender and POV-Ray", "wold"};
  Action action;
  bool json = false;  ///< of --version
};

ExitCode run_man(const std::vector<pages::CommandFacts>& commands) {
  console::print_data(pages::manual_page(commands));
  return ExitCode::done;
}

/// Asks for a command's page in the middle of parsing: nothing else of the line counts.
struct PageAsked {
  std::string command;
};

void add_page(CLI::App& sub) {
  sub.add_flag_callback(
         "--man", [&sub] { throw PageAsked{sub.get_name()}; }, "print the command's manual page")
      ->trigger_on_parse();
}

ExitCode run_page(const CLI::App& app, const std::string& command) {
  const std::vector<pages::CommandFacts> all = command_facts(app);
  console::print_data(
      pages::command_page(*std::ranges::find(all, command, &pages::CommandFacts::name)));
  return ExitCode::done;
}

ExitCode run_completion(const std::vector<pages::CommandFacts>& commands,
                        const std::string& shell) {
  console::print_data(pages::completion(commands, shell));
  return ExitCode::done;
}

void declare(CommandLine& line) {
  CLI::App& app = line.app;
  app.add_flag_callback(
      "--version", [&line] { line.action = [&line] { return run_version(line.json); }; },
      "print the version, what it is built with, and the renderers on this machine");
  app.add_flag("--json", line.json, "with --version: print JSON")->needs("--version");
  app.add_flag_callback(
      "--help-keys", [&line] { line.action = run_help_keys; },
      "list the keys of a scene as markdown");
  app.add_flag_callback(
      "--man", [&line] { line.action = [&line] { return run_man(command_facts(line.app)); }; },
      "print the manual, for man(1)");
  app.add_option_function<std::string>(
         "--completion",
         [&line](const std::string& shell) {
           line.action = [&line, shell] { return run_completion(command_facts(line.app), shell); };
         },
         "print a script by which a shell completes commands, options and keys")
      ->type_name(fmt::format("{}", fmt::join(pages::completion_shells(), "|")));
  app.footer("wold COMMAND --help shows a command's options.");
  for (const Command& command : command_table()) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    sub->footer("Example:\n  " + command.example);
    add_page(*sub);
    sub->final_callback([&line, action = command.declare(*sub)] { line.action = action; });
  }
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Command& command : command_table()) names.push_back(command.name);
  return names;
}

/// CLI11 says of a misspelt command only that it was not expected.
void refuse_unknown_command(int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  const auto names = command_names();
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string suggestion = scene::suggestion(scene::nearest(argv[1], names));
  throw InputError(fmt::format("unknown command {}{}; wold --help lists them",
                               scene::in_quotes(argv[1]), suggestion));
}

/// CLI11 says of a misspelt option only that it was not expected, and in any order.
void refuse_unknown_option(const std::string& option, const CLI::App& command,
                           const std::string& called) {
  std::vector<std::string> names;
  for (const CLI::Option* known : command.get_options())
    for (const std::string& name : known->get_lnames()) names.push_back("--" + name);
  const std::string word = option.substr(0, option.find('='));
  throw InputError(fmt::format("unknown option {} of {}{}; {} --help lists them",
                               scene::in_quotes(word), called,
                               scene::suggestion(scene::nearest(word, names)), called));
}

/// Words that stand where nothing takes them: a misspelt option, or a key that has no --set.
void refuse_extras(const CLI::App& app) {
  const std::vector<std::string> extras = app.remaining(/*recurse=*/true);
  const auto commands = app.get_subcommands();
  const CLI::App& command = commands.empty() ? app : *commands.front();
  const std::string called = commands.empty() ? "wold" : "wold " + command.get_name();
  const auto option = std::ranges::find_if(
      extras, [](const std::string& extra) { return extra.starts_with("--"); });
  if (option != extras.end()) refuse_unknown_option(*option, command, called);
  const auto key = std::ranges::find_if(
      extras, [](const std::string& extra) { return extra.find('=') != std::string::npos; });
  if (key == extras.end() || command.get_option_no_throw("--set") == nullptr) return;
  throw InputError(
      fmt::format("{}: found a key by itself, expected --set before each, as in {} "
                  "SCENE --set KEY=VALUE --set KEY=VALUE",
                  scene::in_quotes(*key), called));
}

/// Help and version are answers, the rest are the user's mistakes.
Action answer(const CLI::App& app, const CLI::ParseError& result) {
  if (dynamic_cast<const CLI::ExtrasError*>(&result) != nullptr) refuse_extras(app);
  if (result.get_exit_code() != 0) throw InputError(result.what());
  std::ostringstream text, unused;
  app.exit(result, text, unused);
  return [shown = text.str()] {
    console::print_data(shown);
    return ExitCode::done;
  };
}

ExitCode execute(int argc, char** argv) {
  const auto action = asked_for(argc, argv);
  const StopScope stop([] {
    if (interrupted()) throw InterruptedError();
  });
  return action();
}

ExitCode report(const Error& error) {
  console::print_message(fmt::format("error: {}", error.what()));
  return error.code();
}

ExitCode report(const InputError& error) {
  constexpr std::size_t max = 100;  // more says nothing new, and a file may have a million
  const std::vector<Problem>& problems = error.problems();
  for (std::size_t i = 0; i < std::min(max, problems.size()); ++i)
    console::print_message(fmt::format("error: {}", to_string(problems[i])));
  if (problems.size() > max)
    console::print_message(fmt::format("error: and {} more like these", problems.size() - max));
  return error.code();
}

constexpr std::string_view out_of_memory =
    "out of memory: allow more (--memory, or the machine's), or coarser grass.levels, fewer "
    "grass.variants or fewer --threads";

/// Says what ends the program where nobody can catch it: in a thread that a library starts. Takes
/// no memory, so that it can say that there is none: it writes by the system's own means.
[[noreturn]] void end_with(std::string_view message) {
  for (const std::string_view part : {std::string_view("error: "), message, std::string_view("\n")})
    if (::write(STDERR_FILENO, part.data(), part.size()) < 0) break;
  std::_Exit(static_cast<int>(ExitCode::file));
}

/// Ends the program with what it says. Where memory ends, TBB's threads cannot start further ones,
/// and say so by an exception.
[[noreturn]] void end_of_uncaught() {
  try {
    if (const std::exception_ptr uncaught = std::current_exception())
      std::rethrow_exception(uncaught);
  } catch (const std::bad_alloc&) {
    end_with(out_of_memory);
  } catch (const std::exception& error) {
    end_with(error.what());
  }
  std::abort();
}

ExitCode run_and_report(int argc, char** argv) {
  try {
    return execute(argc, argv);
  } catch (const InputError& error) {
    return report(error);
  } catch (const InterruptedError& error) {
    console::print_message("interrupted; the same command goes on where it stopped");
    return error.code();
  } catch (const Error& error) {
    return report(error);
  } catch (const std::bad_alloc&) {
    return report(FileError(std::string(out_of_memory)));
  } catch (const std::exception& error) {
    return report(FileError(error.what()));
  }
}

}  // namespace

std::function<ExitCode()> asked_for(int argc, char** argv) {
  refuse_unknown_command(argc, argv);
  const auto line = std::make_shared<CommandLine>();
  declare(*line);
  try {
    line->app.parse(argc, argv);
  } catch (const CLI::ParseError& result) {
    return answer(line->app, result);
  } catch (const PageAsked& page) {
    return [line, command = page.command] { return run_page(line->app, command); };
  }
  if (!line->action) throw InputError("a command was expected; wold --help lists them");
  return [line] { return line->action(); };
}

int run(int argc, char** argv) {
  console::open_standard_streams();
  catch_interrupts();
  ignore_size_limits();
  std::set_terminate(end_of_uncaught);
  return static_cast<int>(run_and_report(argc, argv));
}

}  // namespace wold::cli
