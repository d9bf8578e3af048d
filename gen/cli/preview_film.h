#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/tubes.h"
#include "grass/time_varying_texel.h"
#include "landscape/landscape.h"
#include "landscape/patch_look.h"
#include "landscape/site.h"
#include "scene/scene.h"

namespace wold::cli {

/// A scene that shows the same landscape with far less work: coarser, without volumes; grass stands
/// as blades near the camera and is painted on the ground beyond.
scene::Scene simplified(scene::Scene scene, int width_px);

/// The landscapes of a simplified scene, made at once.
class PreviewFilm {
 public:
  /// Makes the site and, in `scratch`, the looks that far grass of these frames (from 1) has.
  /// `scene` has to outlive it. Throws what make_site() does, and FileError.
  PreviewFilm(const scene::Scene& scene, const std::vector<int>& frames,
              const std::filesystem::path& scratch);

  /// A frame as the scene's camera sees it.
  landscape::Landscape landscape(int frame);

  /// The same ground under another camera in a picture of that size, in clear air and all grass
  /// painted on it.
  landscape::Landscape overview(int frame, const scene::Camera& camera, const glm::ivec2& size_px);

  /// The first variant's blades at a key frame, without snow.
  Tubes blades(int key_frame) const { return blades(0, {key_frame, 0}); }

 private:
  Tubes blades(int variant, const grass::PatchState& state) const;
  landscape::Landscape assembled(const scene::Scene& scene, int frame);
  landscape::PatchLook far_look(const grass::PatchState& state) const;
  landscape::BladeMesh mesh(int variant, const grass::PatchState& state);

  const scene::Scene& scene_;
  landscape::Site site_;
  grass::TimeVaryingTexel texels_;
  std::map<std::pair<int, grass::PatchState>, landscape::BladeMesh> meshes_;
};

}  // namespace wold::cli
