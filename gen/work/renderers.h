#pragma once

#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/progress.h"
#include "render/capabilities.h"
#include "render/renderer_program.h"
#include "work/job.h"

namespace wold::work {

/// Which program a job's option names for a renderer; empty when it names none.
const std::string& chosen_program(const Job& job, render::Renderer renderer);

/// The programs that make a job's pictures. Each is looked for, asked what it is, and held against
/// what the scene needs when it is asked for the first time.
class Renderers {
 public:
  /// `job` and `progress` have to outlive it; it says to `progress` what people should know.
  Renderers(const Job& job, Progress& progress) : job_(job), progress_(progress) {}

  /// Makes sure of all of them before any is used. Throws RendererError in one sentence when one is
  /// missing, is another program, or cannot show what the scene needs or compute on what it asks
  /// for, and InterruptedError.
  void require(const std::vector<render::Renderer>& wanted);

  /// The program of one; throws what require() throws.
  const render::RendererProgram& program(render::Renderer renderer);

 private:
  void check(const render::RendererProgram& program) const;

  const Job& job_;
  Progress& progress_;
  std::mutex mutex_;
  std::map<render::Renderer, render::RendererProgram> ready_;
};

}  // namespace wold::work
