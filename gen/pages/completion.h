#pragma once

#include <span>
#include <string>
#include <vector>

#include "pages/command_facts.h"

namespace wold::pages {

/// The shells that completion() knows: "bash", "zsh", "fish".
const std::vector<std::string>& completion_shells();

/// A script for the shell that completes commands, options, their words and files, and after --set
/// the keys of a scene and what they may be. `commands` are command_facts().
std::string completion(std::span<const CommandFacts> commands, const std::string& shell);

}  // namespace wold::pages
