#pragma once

#include <cstddef>
#include <string_view>

namespace wold {

/// Where long work reports how far it is and what it noticed. Implementations are thread-safe. A
/// sink may throw InterruptedError from advance(), which stops the work.
class Progress {
 public:
  virtual ~Progress() = default;
  /// A stage starts: what is done, and how many units it has.
  virtual void begin(std::string_view stage, std::size_t units) = 0;
  /// `units` more are done; `detail` names the last of them.
  virtual void advance(std::size_t units, std::string_view detail) = 0;
  /// The stage is complete.
  virtual void end() = 0;
  /// Tells people what they should know and what does not stop the work.
  virtual void say(std::string_view message) = 0;
};

/// Reports to nobody.
class SilentProgress final : public Progress {
 public:
  void begin(std::string_view, std::size_t) override {}
  void advance(std::size_t, std::string_view) override {}
  void end() override {}
  void say(std::string_view) override {}
};

}  // namespace wold
