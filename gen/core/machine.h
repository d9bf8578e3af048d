#pragma once

namespace wold {

/// Bytes of main memory that the program may use: the machine's, or less where a control group of
/// Linux, such as a container's, allows less.
double machine_memory_bytes();

}  // namespace wold
