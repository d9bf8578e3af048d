#include "render/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <thread>

#include "core/error.h"
#include "core/machine.h"

namespace wold::render {
namespace {

constexpr std::chrono::milliseconds grace{1000};  // between asking to terminate and killing
constexpr std::chrono::milliseconds pause{20};
constexpr std::chrono::milliseconds patience{100};  // longest time between two questions

/// What this program ignores or blocks, the renderer must still feel.
void reset_signals() {
  struct sigaction usual = {};
  usual.sa_handler = SIG_DFL;
  for (int signal = 1; signal < NSIG; ++signal) ::sigaction(signal, &usual, nullptr);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
}

/// 0: what this program has itself.
rlimit data_limit(double memory_bytes) {
  rlimit limit{};
  ::getrlimit(RLIMIT_DATA, &limit);
  if (memory_bytes > 0.0)
    limit.rlim_cur = std::min(static_cast<rlim_t>(memory_bytes), limit.rlim_max);
  return limit;
}

/// The child's side of a fork: becomes the program, in a group of its own that goes with the thread
/// that started it, or writes errno to `failure`. Only what is safe while other threads hold locks.
[[noreturn]] void become(char* const* arguments, const char* folder, const rlimit& data, int output,
                         int failure, pid_t parent) {
  ::setpgid(0, 0);
  reset_signals();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(127);  // it was killed before it could be watched
  ::setrlimit(RLIMIT_DATA, &data);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (::chdir(folder) == 0 && ::dup2(nothing, STDIN_FILENO) >= 0 &&
      ::dup2(output, STDOUT_FILENO) >= 0 && ::dup2(output, STDERR_FILENO) >= 0)
    ::execv(arguments[0], arguments);
  const int error = errno;
  ::_exit(::write(failure, &error, sizeof error) < 0 ? 126 : 127);
}

struct Pipe {
  int out = -1;
  int in = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw RendererError(fmt::format("cannot make a pipe: {}", std::strerror(errno)));
  return {ends[0], ends[1]};
}

std::vector<char*> c_arguments(const std::vector<std::string>& arguments) {
  std::vector<char*> pointers;
  pointers.reserve(arguments.size() + 1);
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

Process::Process(const std::vector<std::string>& arguments, const std::filesystem::path& folder,
                 double memory_bytes) {
  const Pipe output = make_pipe();
  const Pipe failure = make_pipe();
  const std::vector<char*> pointers = c_arguments(arguments);
  const rlimit data = data_limit(memory_bytes);
  const pid_t parent = ::getpid();
  group_ = ::fork();
  int error = group_ < 0 ? errno : 0;
  if (group_ == 0) become(pointers.data(), folder.c_str(), data, output.in, failure.in, parent);
  ::close(output.in);
  ::close(failure.in);
  output_ = output.out;
  // Ends without a byte when the program has started.
  const bool failed = group_ < 0 || ::read(failure.out, &error, sizeof error) > 0;
  ::close(failure.out);
  if (!failed) return;
  if (group_ > 0) ::waitpid(group_, nullptr, 0);
  ::close(output_);
  throw RendererError(fmt::format("cannot start {} in {}: {}", arguments.front(), folder.string(),
                                  std::strerror(error)));
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
  if (info.si_code == CLD_EXITED) return ProcessEnd{.code = info.si_status};
  return ProcessEnd{.signal = info.si_status};
}

double Process::memory_bytes() const { return memory_of_process_bytes(group_); }

void Process::stop() {
  const auto give_up = std::chrono::steady_clock::now() + grace;
  if (!ended()) ::kill(-group_, SIGTERM);
  while (!ended() && std::chrono::steady_clock::now() < give_up) std::this_thread::sleep_for(pause);
  ::kill(-group_, SIGKILL);
}

std::optional<ProcessEnd> run_to_end(const std::vector<std::string>& arguments,
                                     const std::filesystem::path& folder,
                                     const ProcessLimits& limits,
                                     const std::function<void(std::string_view)>& hear,
                                     const std::function<bool()>& interrupted) {
  using Clock = std::chrono::steady_clock;
  Process process(arguments, folder, limits.memory_bytes);
  double max_memory_bytes = 0.0;
  const auto deadline = Clock::now() + limits.time;
  while (!process.ended()) {
    hear(process.read(patience));
    max_memory_bytes = std::max(max_memory_bytes, process.memory_bytes());
    if (interrupted()) throw InterruptedError();
    if (Clock::now() > deadline) return std::nullopt;
  }
  process.stop();
  for (std::string rest; !(rest = process.read({})).empty();) hear(rest);
  std::optional<ProcessEnd> end = process.ended();
  if (end) end->max_memory_bytes = max_memory_bytes;
  return end;
}

}  // namespace wold::render
