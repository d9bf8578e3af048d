#pragma once

namespace wold::console {

/// Opens /dev/null on those of stdin, stdout and stderr that are closed. Otherwise the next file
/// that is opened takes the place of one of them, and messages are written into it.
void open_standard_streams();

}  // namespace wold::console
