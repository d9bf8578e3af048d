#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/tubes.h"
#include "grass/texel/time_varying_texel.h"
#include "landscape/landscape.h"
#include "meadow/cells.h"
#include "meadow/far_field.h"
#include "meadow/frame_grass.h"
#include "place/site.h"
#include "scene/scene.h"

namespace wold::sketch {

/// At most `max` of the whole numbers from 0 to count - 1: first, last and evenly between.
std::vector<int> some_of(int count, int max);

/// A scene that shows the same landscape with far less work: coarser, without volumes and with few
/// key frames; grass stands as blades near the camera and is painted on the ground beyond.
scene::Scene simplified(scene::Scene scene, int width_px);

/// The landscapes of a simplified scene, made at once.
class PreviewFilm {
 public:
  /// Makes the site and, in `scratch`, the looks that far grass of these frames (from 1) has.
  /// `season`: phenology::film_season() of the scene, which has to outlive this. Throws what
  /// make_site() does, and FileError.
  PreviewFilm(const scene::Scene& scene, std::shared_ptr<const phenology::FilmSeason> season,
              const std::vector<int>& frames, const std::filesystem::path& scratch);

  /// One of the frames as the scene's camera sees it. Behind clouds only the first one's picture of
  /// the whole sky is fine enough to be shown.
  landscape::Landscape landscape(int frame);

  /// terrain::Paths::lines_m(), as far as there are any.
  std::vector<std::vector<glm::dvec2>> paths_m() const {
    if (!site_.paths) return {};
    return site_.paths->lines_m();
  }

  /// The blades of a patch at a key frame, without snow: of the mixture that stood most often
  /// before the camera in landscape().
  Tubes blades(int key_frame) const { return blades(usual_patch_, {key_frame, 0}); }

 private:
  /// What a frame has in common under all cameras: all its grass bears the same snow in the same
  /// light, the nearest of those that there are.
  struct Moment {
    place::Site site;
    meadow::FrameGrass grass;
    int snow = 0;   ///< PatchState's
    int light = 0;  ///< likewise

    grass::PatchState at(int key_frame) const { return {key_frame, snow, light}; }
  };

  Tubes blades(int variant, const grass::PatchState& state) const;
  meadow::PatchAppearance far_appearance(int variant, const grass::PatchState& state) const;
  void make_site(int frame, bool with_sky);
  void make_looks(const std::vector<int>& frames);
  void make_meshes(std::span<const meadow::CellChoice> cells);

  const scene::Scene& scene_;
  place::Site site_;
  grass::TimeVaryingTexel texels_;
  std::map<int, Moment> moments_;  ///< by frame
  meadow::PatchAppearances looks_;
  int usual_patch_ = 0;
  std::map<std::pair<int, grass::PatchState>, landscape::BladeMesh> meshes_;
};

}  // namespace wold::sketch
