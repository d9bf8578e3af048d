#pragma once

namespace wold {

/// From now on SIGINT, SIGTERM and SIGHUP ask the work to stop; a second one ends the program at
/// once. Those that were ignored when the program started, as by nohup, still are.
void catch_interrupts();

/// A file that grows beyond the limit of the shell (ulimit -f) is an error of writing, which is
/// told and cleaned up after, and not the end of the program.
void ignore_size_limits();

/// Whether the user asked to stop.
bool interrupted();

}  // namespace wold
