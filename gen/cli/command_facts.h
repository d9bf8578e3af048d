#pragma once

#include <vector>

#include "pages/command_facts.h"

namespace CLI {
class App;
}

namespace wold::cli {

/// The program itself first, then its commands in the order of the help.
std::vector<pages::CommandFacts> command_facts(const CLI::App& program);

}  // namespace wold::cli
