#include <pthread.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <string_view>

#include "cli/program.h"

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
namespace {

/// As many as a library takes (log4cplus, by way of OpenVDB) before main() is called. Without them
/// it ends the program with no word that would help.
constexpr int threads_at_start = 5;

void* wait_for_turn(void* turn) {
  pthread_mutex_lock(static_cast<pthread_mutex_t*>(turn));
  pthread_mutex_unlock(static_cast<pthread_mutex_t*>(turn));
  return nullptr;
}

/// Whether so many threads can be there at once.
bool threads_can_start() {
  pthread_mutex_t turn = PTHREAD_MUTEX_INITIALIZER;
  std::array<pthread_t, threads_at_start> threads{};
  std::size_t started = 0;
  pthread_mutex_lock(&turn);
  while (started < threads.size() &&
         pthread_create(&threads[started], nullptr, wait_for_turn, &turn) == 0)
    ++started;
  pthread_mutex_unlock(&turn);
  for (std::size_t i = 0; i < started; ++i) pthread_join(threads[i], nullptr);
  return started == threads.size();
}

void require_threads(int, char**, char**) {
  constexpr std::string_view text =
      "error: the system starts no more threads: raise the limit of processes (ulimit -u), or end "
      "others of yours\n";
  if (threads_can_start()) return;
  const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(written < 0 ? 1 : 4);
}

/// Called before the constructors of all libraries.
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const before_libraries)(int, char**, char**) = require_threads;

}  // namespace
#endif

int main(int argc, char** argv) { return wold::cli::run(argc, argv); }
