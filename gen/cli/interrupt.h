#pragma once

namespace wold::cli {

/// From now on SIGINT, SIGTERM and SIGHUP ask the work to stop; a second one ends the program at
/// once.
void catch_interrupts();

/// Whether the user asked to stop.
bool interrupted();

}  // namespace wold::cli
