#pragma once

#include <span>
#include <string>

#include "pages/command_facts.h"

namespace wold::pages {

/// The manual as one page for man(1): the program's commands with their options, every key of a
/// scene, files and exit codes. `commands` are command_facts().
std::string manual_page(std::span<const CommandFacts> commands);

/// A command's own page: what it does, its options, an example.
std::string command_page(const CommandFacts& command);

}  // namespace wold::pages
