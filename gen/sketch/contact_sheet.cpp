#include "sketch/contact_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "preview/camera_picture.h"
#include "preview/relief_map.h"
#include "preview/sheet.h"
#include "preview/sky_picture.h"
#include "scene/key_frames.h"
#include "scene/shots.h"
#include "sketch/preview_film.h"

namespace wold::sketch {
namespace fs = std::filesystem;
namespace {

using preview::Tile;

/// First, middle and last; of a film of shots the middle of each, of as many as find room.
std::vector<int> shown_frames(const scene::Scene& scene) {
  std::vector<int> frames;
  if (scene.shots.empty()) {
    for (const int frame : some_of(scene::frame_count(scene), 3)) frames.push_back(frame + 1);
    return frames;
  }
  constexpr int max = 6;
  const std::vector<scene::Take> takes = scene::takes_of(scene);
  for (const int number : some_of(static_cast<int>(takes.size()), max)) {
    const scene::Take& take = takes[static_cast<std::size_t>(number)];
    frames.push_back(take.first + take.count / 2);
  }
  return frames;
}

std::string caption_of(const scene::Scene& scene, const landscape::Landscape& landscape) {
  if (const scene::Shot* shot = scene::shot_of(scene, landscape.frame))
    return fmt::format("Frame {}, {}", landscape.frame, shot->name);
  return fmt::format("Frame {}, weathering degree {:.3g}", landscape.frame, landscape.weathering);
}

/// What multiplies the radiance of grass, developed, on the mean of the terrain: where its light is
/// known, which on large terrain is where grass is drawn. Full light if that is nowhere.
glm::vec3 mean_light(const landscape::Landscape& landscape) {
  glm::dvec3 sum(0.0);
  int count = 0;
  for (const glm::vec3& light : landscape.light.values()) {
    if (light == glm::vec3(0.0F)) continue;
    sum += light;
    ++count;
  }
  return glm::vec3(count == 0 ? glm::dvec3(landscape.exposure_gain)
                              : sum * landscape.exposure_gain / static_cast<double>(count));
}

constexpr int map_beside_sky_px = 336;

/// Of a picture of the camera; one alone is as high as the square map beside it.
int camera_width_px(const scene::Scene& scene, std::size_t frames) {
  if (frames > 1) return preview::width_of_each(static_cast<int>(frames));
  const auto [width_px, height_px] = scene.render.size_px;
  const double aspect = std::clamp(static_cast<double>(width_px) / height_px, 0.5, 3.0);
  return static_cast<int>((preview::width_of_each(1) - preview::gap_px) * aspect / (aspect + 1.0));
}

/// The scene drawn part by part.
class Preview {
 public:
  Preview(const scene::Scene& scene, std::shared_ptr<const phenology::FilmSeason> season,
          const std::vector<int>& frames, const fs::path& scratch, Progress& progress)
      : width_px_(camera_width_px(scene, frames.size())),
        scene_(simplified(scene, width_px_)),
        frames_(frames),
        progress_(begun(progress, frames.size())),
        film_(scene_, std::move(season), frames, scratch),
        font_(preview::label_font()) {
    progress_.advance(site_units, "ground");
  }

  preview::Sheet sheet() {
    preview::Sheet sheet;
    sheet.title = scene_.name;
    const std::size_t count = scene_.ageing.frames.size();
    sheet.subtitle = fmt::format(
        "A sketch: coarser than the renderers' pictures, and grass in the distance is only colour. "
        "{} frame{}, terrain of {:.6g} m.",
        count, count == 1 ? "" : "s", scene_.terrain.size_m);
    std::vector<landscape::Landscape> landscapes;
    for (const int frame : frames_) {
      landscapes.push_back(film_.landscape(frame));
      progress_.advance(1, fmt::format("frame {}", frame));
    }
    std::vector<Tile> camera_row(landscapes.size());
    parallel_for(landscapes.size(), [&](std::size_t i) {
      camera_row[i] = {preview::camera_picture(landscapes[i], width_px_),
                       caption_of(scene_, landscapes[i])};
    });
    progress_.advance(frames_.size(), "pictures");
    std::vector<Tile> around = surroundings(landscapes.front());
    if (frames_.size() == 1) {
      camera_row.push_back(std::move(around.front()));
      around.erase(around.begin());
    }
    sheet.rows = {std::move(camera_row), std::move(around),
                  grass_row(mean_light(landscapes.front()))};
    progress_.advance(2, "surroundings and grass");
    progress_.end();
    return sheet;
  }

  const fs::path& font() const { return font_; }

 private:
  /// Measured: making the ground takes as long as a frame's landscape and its picture.
  static constexpr std::size_t site_units = 2;

  static Progress& begun(Progress& progress, std::size_t frames) {
    progress.begin("preview", site_units + 2 * frames + 2);
    return progress;
  }

  /// What is around in a frame: the terrain's map, the sky, flakes.
  std::vector<Tile> surroundings(const landscape::Landscape& landscape) {
    constexpr int flakes_px = 240;
    const bool snows = !landscape.flakes.pictures.empty();
    const int whole_px = preview::width_of_each(1);
    const bool is_map_above = frames_.size() == 1;  // beside the camera's picture
    const int map_px = is_map_above ? whole_px - preview::gap_px - width_px_ : map_beside_sky_px;
    const int sky_px = whole_px - (is_map_above ? 0 : map_px + preview::gap_px) -
                       (snows ? flakes_px + preview::gap_px : 0);
    std::vector<Tile> row = {map(landscape, map_px), sky(landscape, sky_px)};
    if (snows)
      row.push_back(
          {preview::flakes_picture(landscape.flakes, {flakes_px, flakes_px}),
           fmt::format("Flakes and drops; {} in the picture", landscape.flakes.flakes.size())});
    return row;
  }

  Tile map(const landscape::Landscape& landscape, int width_px) const {
    const double interval_m = preview::contour_interval_m(landscape.terrain);
    const std::string lines =
        interval_m > 0.0 ? fmt::format("contour lines every {:.3g} m", interval_m) : "level";
    return {
        preview::relief_map(landscape.terrain, landscape.camera, film_.paths_m(), width_px, font_),
        "From above, with the camera; " + lines};
  }

  Tile sky(const landscape::Landscape& landscape, int width_px) const {
    Image picture = preview::sky_picture(landscape, width_px);
    int quarter = 0;
    for (const char* name : {"N", "E", "S", "W"}) {
      const int x = std::max(12, quarter++ * width_px / 4);
      preview::write_label(picture, name, {{x, picture.height - 10}, 15, glm::vec3(1.0F), true, 2},
                           font_);
    }
    return {
        std::move(picture),
        fmt::format("Sky all around, from the horizon to the zenith, frame {}", landscape.frame)};
  }

  /// Grass at some of its key frames under `light`.
  std::vector<Tile> grass_row(const glm::vec3& light) const {
    constexpr int max = 6;
    const std::vector<double> key_frames = scene::key_frames(scene_);
    const std::vector<int> shown = some_of(static_cast<int>(key_frames.size()), max);
    const int width_px = preview::width_of_each(max);
    std::vector<Tile> row(shown.size());
    parallel_for(row.size(), [&](std::size_t i) {
      row[i] = {
          preview::patch_picture(film_.blades(shown[i]), scene_.grass.patch_m,
                                 1.3 * scene_.grass.height_m, light, {width_px, width_px * 9 / 10}),
          fmt::format("Grass at degree {:.3g}", key_frames[static_cast<std::size_t>(shown[i])])};
    });
    return row;
  }

  int width_px_;
  scene::Scene scene_;
  std::vector<int> frames_;
  Progress& progress_;
  PreviewFilm film_;
  fs::path font_;
};

}  // namespace

bool has_labels() { return !preview::label_font().empty(); }

Image contact_sheet(const scene::Scene& scene, std::shared_ptr<const phenology::FilmSeason> season,
                    const fs::path& scratch, Progress& progress) {
  Preview preview(scene, std::move(season), shown_frames(scene), scratch, progress);
  return preview::drawn(preview.sheet(), preview.font());
}

}  // namespace wold::sketch
