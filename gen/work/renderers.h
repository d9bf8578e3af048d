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

/// The programs that make a job's pictures. Each is looked for, asked what it is, and held against
/// what the scene needs when it is asked for the first time.
class Renderers {
 public:
  /// `job` and `progress` have to outlive it; it says to `progress` what people should know.
  Renderers(const Job& job, Progress& progress) : job_(job), progress_(progress) {}

  /// Makes sure of the renderers of all of these before any is used. Throws RendererError in one
  /// sentence when one is missing, is another program, or cannot show what the scene needs or
  /// compute on what it asks for, and InterruptedError.
  void require(const exporter::Exporters& wanted);

  /// The program that makes pictures of an exporter's files; throws what require() throws.
  const render::RendererProgram& program(const exporter::Exporter& exporter);

 private:
  void check(const render::RendererProgram& program) const;

  const Job& job_;
  Progress& progress_;
  std::mutex mutex_;
  std::map<const exporter::Exporter*, render::RendererProgram> ready_;
};

}  // namespace wold::work
