#include <dlfcn.h>
#include <pthread.h>

#include <algorithm>
#include <cstddef>

/// Preloaded into POV-Ray, whose threads ask for a stack of 4 MiB. It takes 15 KiB of that for each
/// surface of a volume that a ray passes, whatever max_trace_level says: at 280 of them, on rays
/// that graze a meadow in a large picture, it crashed. This gives them 32 MiB, most of it never
/// touched.
extern "C" int pthread_attr_setstacksize(pthread_attr_t* attributes, std::size_t bytes) noexcept {
  constexpr std::size_t min_bytes = std::size_t{32} << 20U;
  using SetStackSize = int (*)(pthread_attr_t*, std::size_t);
  static const auto set_stack_size =
      reinterpret_cast<SetStackSize>(::dlsym(RTLD_NEXT, "pthread_attr_setstacksize"));
  return set_stack_size(attributes, std::max(bytes, min_bytes));
}
