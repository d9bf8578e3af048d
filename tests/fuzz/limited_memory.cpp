/// Memory as a machine without sanitizers has it: what is more than that throws std::bad_alloc,
/// where the sanitizer's own operators end the program. Readers have to live with it.

#include <cstdlib>
#include <new>

namespace {

void* taken_if_there(std::size_t bytes) noexcept {
  constexpr std::size_t most_bytes = std::size_t{1} << 30;
  return bytes <= most_bytes ? std::malloc(bytes) : nullptr;
}

void* taken(std::size_t bytes) {
  void* const memory = taken_if_there(bytes);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

void* operator new(std::size_t bytes) { return taken(bytes); }
void* operator new[](std::size_t bytes) { return taken(bytes); }
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
  return taken_if_there(bytes);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
  return taken_if_there(bytes);
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
