#pragma once

namespace wold::cli {

/// The whole program: reads the command line, runs the command, prints every error, one line per
/// problem, to stderr. Never throws; returns the exit code of core/error.h.
int run(int argc, char** argv);

}  // namespace wold::cli
