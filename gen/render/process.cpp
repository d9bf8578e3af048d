#include "render/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include "core/error.h"

namespace wold::render {
namespace {

constexpr std::chrono::milliseconds grace{1000};  // between asking to terminate and killing
constexpr std::chrono::milliseconds pause{20};

/// What the child is started with; owns the C structures.
class SpawnSettings {
 public:
  SpawnSettings(const std::filesystem::path& folder, int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addchdir_np(&actions_, folder.c_str());
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, output, STDERR_FILENO);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(
        &attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK);
    reset_signals();
  }
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;

  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  /// What this program ignores or blocks, the renderer must still feel.
  void reset_signals() {
    sigset_t all;
    sigset_t none;
    sigfillset(&all);
    sigemptyset(&none);
    posix_spawnattr_setsigdefault(&attributes_, &all);
    posix_spawnattr_setsigmask(&attributes_, &none);
  }

  posix_spawn_file_actions_t actions_{};
  posix_spawnattr_t attributes_{};
};

std::vector<char*> c_arguments(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  for (const std::string& argument : arguments)
    pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

std::string to_string(const ProcessEnd& end) {
  if (end.signal == 0) return fmt::format("exit code {}", end.code);
  const char* meaning = sigdescr_np(end.signal);
  return fmt::format("killed by signal {} ({}{})", end.signal, meaning ? meaning : "unknown",
                     end.signal == SIGKILL ? "; is the memory full?" : "");
}

Process::Process(const std::vector<std::string>& arguments, const std::filesystem::path& folder) {
  std::array<int, 2> pipe_ends{};
  if (::pipe2(pipe_ends.data(), O_CLOEXEC) != 0)
    throw RendererError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  const SpawnSettings settings(folder, pipe_ends[1]);
  const int failed = posix_spawn(&group_, arguments.front().c_str(), settings.actions(),
                                 settings.attributes(), c_arguments(arguments).data(), environ);
  ::close(pipe_ends[1]);
  output_ = pipe_ends[0];
  if (failed == 0) return;
  ::close(output_);
  throw RendererError(fmt::format("cannot start {} in {}: {}", arguments.front(), folder.string(),
                                  std::strerror(failed)));
}

Process::~Process() {
  stop();
  // Only now is the id given back: until here no other process can have taken it.
  ::waitpid(group_, nullptr, 0);
  ::close(output_);
}

std::string Process::read(std::chrono::milliseconds wait) {
  pollfd ready{output_, POLLIN, 0};
  if (::poll(&ready, 1, static_cast<int>(wait.count())) <= 0) return {};
  std::array<char, 65536> buffer;
  const ssize_t count = ::read(output_, buffer.data(), buffer.size());
  // The output may be closed long before the program ends.
  if (count <= 0) std::this_thread::sleep_for(wait);
  return {buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

std::optional<ProcessEnd> Process::ended() const {
  siginfo_t info{};
  if (::waitid(P_PID, static_cast<id_t>(group_), &info, WEXITED | WNOHANG | WNOWAIT) != 0 ||
      info.si_pid == 0)
    return std::nullopt;
  if (info.si_code == CLD_EXITED) return ProcessEnd{info.si_status, 0};
  return ProcessEnd{0, info.si_status};
}

void Process::stop() {
  const auto give_up = std::chrono::steady_clock::now() + grace;
  if (!ended()) ::kill(-group_, SIGTERM);
  while (!ended() && std::chrono::steady_clock::now() < give_up) std::this_thread::sleep_for(pause);
  ::kill(-group_, SIGKILL);
}

}  // namespace wold::render
