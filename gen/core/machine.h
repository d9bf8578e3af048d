#pragma once

#include <sys/types.h>

namespace wold {

/// Bytes of main memory that the program may use: the machine's, or less where a control group of
/// Linux, such as a container's, allows less.
double machine_memory_bytes();

/// Bytes of memory that a process has of its own, written to or not, which is what Linux limits
/// (RLIMIT_DATA): main memory that it does not share is less. 0 when it has ended.
double memory_of_process_bytes(pid_t process);

/// From here on this process gets no more than that much memory of its own: what asks for more
/// throws std::bad_alloc. The programs that it starts get as much each, unless told otherwise.
void limit_own_memory(double bytes);

}  // namespace wold
