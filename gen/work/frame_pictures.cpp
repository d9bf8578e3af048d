#include "work/frame_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "core/error.h"
#include "core/number_text.h"
#include "film/exporters.h"
#include "scene/parse.h"
#include "scene/shots.h"
#include "work/frame_choice.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

/// The frame that a picture is of, by its name.
std::optional<int> frame_of(const fs::path& picture) {
  const std::string stem = picture.stem().string();
  const auto frame = number_in<int>(stem);
  if (picture.extension() != ".png" || !frame || *frame < 1 || fmt::format("{:04}", *frame) != stem)
    return std::nullopt;
  return frame;
}

/// Pictures alone make a film, too: none where the folder's scene is missing or cannot be read.
std::optional<scene::Scene> scene_in(const fs::path& out) {
  try {
    return scene::read_scene(out / "scene.toml");
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<FramePictures> frame_pictures(const fs::path& out) {
  if (!fs::is_directory(out))
    throw FileError(
        fmt::format("found {}, expected a folder that `wold render` has made", out.string()));
  std::vector<FramePictures> all;
  for (const exporter::Exporter* one : film::exporters()) {
    FramePictures pictures{std::string(one->name), out / "frames" / one->name, {}};
    std::error_code none;
    for (const fs::directory_entry& entry : fs::directory_iterator(pictures.folder, none))
      if (const auto frame = frame_of(entry.path())) pictures.by_frame[*frame] = entry.path();
    if (!pictures.by_frame.empty()) all.push_back(std::move(pictures));
  }
  return all;
}

std::string display_name(const FramePictures& pictures) {
  const exporter::Exporter* exporter = find_exporter(film::exporters(), pictures.renderer);
  return exporter ? std::string(exporter->display_name) : pictures.renderer;
}

fs::path passes_path(const fs::path& out, int frame) {
  return out / "passes" / fmt::format("{:04}.exr", frame);
}

std::vector<int> missing_frames(const FramePictures& pictures, const std::vector<int>& frames) {
  std::vector<int> missing;
  for (const int frame : frames)
    if (!pictures.by_frame.contains(frame)) missing.push_back(frame);
  return missing;
}

std::vector<int> expected_frames(const fs::path& out, const std::vector<FramePictures>& pictures) {
  if (const auto scene = scene_in(out)) return counted(scene::frame_count(*scene));
  int last = 0;
  for (const FramePictures& one : pictures) last = std::max(last, one.by_frame.rbegin()->first);
  return counted(last);
}

std::vector<int> frames_of_shots(const fs::path& out, const std::vector<std::string>& shots) {
  const auto scene = scene_in(out);
  if (!scene)
    throw InputError(fmt::format("--shot: expected a scene in {}; --frames takes frames by number",
                                 (out / "scene.toml").string()));
  return chosen_frames({.shots = shots}, *scene);
}

scene::FilmTiming film_timing(const fs::path& out) {
  return scene_in(out).value_or(scene::Scene()).film;
}

}  // namespace wold::work
