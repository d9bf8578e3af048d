#include "work/made_files.h"

#include <nlohmann/json.hpp>

#include "work/frame_pictures.h"
#include "work/work.h"

namespace wold::work {
namespace {

using Json = nlohmann::ordered_json;

/// A frame's pictures by renderer.
Json pictures_of(const Job& job, const std::vector<StageTasks>& stages, int frame) {
  Json pictures = Json::object();
  for (const StageTasks& stage : stages)
    if (makes_pictures(stage.stage))
      pictures[std::string(name_of(stage.stage))] =
          picture_path(job, {stage.stage, frame}).string();
  return pictures;
}

}  // namespace

std::string made_text(const Job& job, const std::vector<StageTasks>& stages) {
  std::string pictures, passes;
  for (const int frame : job.frames) {
    for (const StageTasks& stage : stages)
      if (makes_pictures(stage.stage))
        pictures += picture_path(job, {stage.stage, frame}).string() + "\n";
    if (!job.passes.empty()) passes += passes_path(job.out, frame).string() + "\n";
  }
  return pictures + passes;
}

std::string made_json(const Job& job, const std::vector<StageTasks>& stages) {
  Json frames = Json::array();
  for (const int frame : job.frames)
    frames.push_back(
        {{"frame", frame},
         {"pictures", pictures_of(job, stages, frame)},
         {"passes", job.passes.empty() ? Json() : Json(passes_path(job.out, frame).string())}});
  const Json json = {{"version", 1}, {"out", job.out.string()}, {"frames", std::move(frames)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace wold::work
