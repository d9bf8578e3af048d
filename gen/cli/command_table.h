#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/error.h"

namespace CLI {
class App;
}

namespace wold::cli {

/// A command of the program. `declare` adds its options to the command line and returns what to
/// run once they are filled in.
struct Command {
  std::string name;
  std::string summary;
  std::string example;
  std::function<std::function<ExitCode()>(CLI::App&)> declare;
};

/// All commands, in the order of the help.
const std::vector<Command>& command_table();

}  // namespace wold::cli
