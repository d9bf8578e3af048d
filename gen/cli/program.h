#pragma once

#include <functional>

#include "core/error.h"

namespace wold::cli {

/// What a command line asks for, which calling it does. Reads and writes nothing itself. Throws
/// InputError.
std::function<ExitCode()> asked_for(int argc, char** argv);

/// The whole program: reads the command line, runs the command, prints every error, one line per
/// problem, to stderr. Never throws; returns the exit code of core/error.h.
int run(int argc, char** argv);

}  // namespace wold::cli
