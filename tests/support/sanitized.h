#pragma once

namespace wold::test {

/// Sanitizers reserve terabytes: in builds with them no process keeps to a limit of memory.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace wold::test
