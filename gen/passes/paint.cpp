#include "passes/paint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "core/parallel.h"
#include "landscape/perspective.h"
#include "passes/cryptomatte.h"
#include "passes/leaf_albedo.h"
#include "passes/sights.h"
#include "passes/sway.h"

namespace wold::passes {
namespace {

constexpr int rays_per_side = 4;  ///< of a pixel, for fractions
constexpr int file_format = 1;
constexpr float no_depth = 1e10F;
constexpr float no_cell = -1.0F;

landscape::Perspective perspective_of(const landscape::Landscape& landscape,
                                      const landscape::Camera& camera) {
  return {camera, {landscape.width_px, landscape.height_px}};
}

/// What covers a pixel.
struct Coverage {
  double all = 0.0;                ///< fraction
  std::vector<double> of_species;  ///< fractions, then of "ground" and "snow"
};

/// Of one frame, row by row.
class Painter {
 public:
  Painter(const landscape::Landscape& landscape, const GroundFacts& facts)
      : landscape_(landscape),
        facts_(facts),
        perspective_(perspective_of(landscape, landscape.camera)),
        sights_(landscape),
        pixels_(static_cast<std::size_t>(landscape.width_px) *
                static_cast<std::size_t>(landscape.height_px)) {
    image_.width = landscape.width_px;
    image_.height = landscape.height_px;
  }

  void look_at_middles();
  void look_for_coverage();
  void add(Pass pass);
  LayeredImage image() && { return std::move(image_); }

 private:
  glm::dvec2 middle_px(std::size_t pixel) const {
    const auto width = static_cast<std::size_t>(landscape_.width_px);
    return glm::dvec2(pixel % width, pixel / width) + 0.5;
  }
  glm::dvec3 direction(std::size_t pixel) const { return perspective_.direction(middle_px(pixel)); }
  Coverage coverage(std::size_t pixel, Sight& sight) const;
  void add_covered(const Sight& sight, const glm::dvec3& direction, Coverage& coverage) const;
  void add_grass(int mixture, double fraction, Coverage& coverage) const;
  int mixture_of(const landscape::CellOrigin& origin) const;
  /// Of the cell that is seen.
  const landscape::CellOrigin& origin_of(const SeenPlace& seen) const;
  glm::dvec2 motion_px(const SeenPlace& seen, std::size_t pixel, const landscape::Perspective& next,
                       const Sway& sway) const;

  /// Adds a layer's channel: value(place, pixel) where something is seen, else `nothing`.
  template <class Value>
  void add_channel(Pass pass, char letter, PixelFormat format, float nothing, const Value& value);
  /// The same for channels that are a vector's.
  template <class Value>
  void add_vector(Pass pass, PixelFormat format, const Value& value);

  const landscape::Landscape& landscape_;
  const GroundFacts& facts_;
  landscape::Perspective perspective_;
  Sights sights_;
  std::size_t pixels_;
  std::vector<SeenPlace> seen_;
  std::vector<float> covered_;
  std::optional<Cryptomatte> species_;
  LayeredImage image_;
};

void Painter::look_at_middles() {
  seen_.resize(pixels_);
  const auto width = static_cast<std::size_t>(landscape_.width_px);
  parallel_for_with_scratch(
      static_cast<std::size_t>(landscape_.height_px), [] { return Sight(); },
      [&](std::size_t row, Sight& sight) {
        for (std::size_t pixel = row * width; pixel < (row + 1) * width; ++pixel) {
          const glm::dvec3 along = direction(pixel);
          sights_.look(along, sight);
          seen_[pixel] = sight.seen(landscape_.camera.eye_m, along);
        }
      });
}

void Painter::look_for_coverage() {
  covered_.resize(pixels_);
  std::vector<std::string> names = facts_.species;
  names.insert(names.end(), {"ground", "snow"});
  species_.emplace(std::string(facts_of(Pass::species).name), std::move(names), pixels_);
  const auto width = static_cast<std::size_t>(landscape_.width_px);
  parallel_for_with_scratch(
      static_cast<std::size_t>(landscape_.height_px), [] { return Sight(); },
      [&](std::size_t row, Sight& sight) {
        for (std::size_t pixel = row * width; pixel < (row + 1) * width; ++pixel) {
          const Coverage seen = coverage(pixel, sight);
          covered_[pixel] = static_cast<float>(seen.all);
          species_->set(pixel, seen.of_species);
        }
      });
}

Coverage Painter::coverage(std::size_t pixel, Sight& sight) const {
  constexpr double rays = rays_per_side * rays_per_side;
  Coverage coverage{0.0, std::vector<double>(facts_.species.size() + 2, 0.0)};
  for (int y = 0; y < rays_per_side; ++y)
    for (int x = 0; x < rays_per_side; ++x) {
      const glm::dvec2 from_middle =
          (glm::dvec2(x, y) + 0.5) / static_cast<double>(rays_per_side) - 0.5;
      const glm::dvec3 along = perspective_.direction(middle_px(pixel) + from_middle);
      sights_.look(along, sight);
      add_covered(sight, along, coverage);
    }
  for (double& fraction : coverage.of_species) fraction /= rays;
  coverage.all = std::accumulate(coverage.of_species.begin(), coverage.of_species.end(), 0.0);
  return coverage;
}

void Painter::add_covered(const Sight& sight, const glm::dvec3& direction,
                          Coverage& coverage) const {
  double left = 1.0;
  for (const Veil& veil : sight.grass.veils) {
    add_grass(mixture_of(landscape_.cells[static_cast<std::size_t>(veil.cell)].origin),
              veil.opacity, coverage);
    left -= veil.opacity;
  }
  if (sight.meets_blade())
    add_grass(mixture_of(landscape_.blade_cells[static_cast<std::size_t>(sight.blade.cell)].origin),
              left, coverage);
  if (!sight.meets_ground()) return;
  const glm::dvec3 at_m = landscape_.camera.eye_m + sight.ground_m * direction;
  const PaintedGrass painted = facts_.painted_grass(at_m);
  add_grass(painted.mixture, left * painted.opacity, coverage);
  left *= 1.0 - painted.opacity;
  const double white = facts_.white_fraction(glm::dvec2(at_m));
  coverage.of_species[facts_.species.size()] += left * (1.0 - white);
  coverage.of_species[facts_.species.size() + 1] += left * white;
}

int Painter::mixture_of(const landscape::CellOrigin& origin) const {
  return facts_.mixture_of_patch.at(static_cast<std::size_t>(origin.patch));
}

void Painter::add_grass(int mixture, double fraction, Coverage& coverage) const {
  const std::vector<double>& shares = facts_.mixtures.at(static_cast<std::size_t>(mixture));
  for (std::size_t i = 0; i < shares.size(); ++i) coverage.of_species[i] += fraction * shares[i];
}

const landscape::CellOrigin& Painter::origin_of(const SeenPlace& seen) const {
  const auto cell = static_cast<std::size_t>(seen.cell);
  return seen.thing == SeenPlace::Thing::blade ? landscape_.blade_cells[cell].origin
                                               : landscape_.cells[cell].origin;
}

template <class Value>
void Painter::add_channel(Pass pass, char letter, PixelFormat format, float nothing,
                          const Value& value) {
  ImageChannel channel{fmt::format("{}.{}", facts_of(pass).name, letter), format,
                       std::vector<float>(pixels_, nothing)};
  parallel_for_blocks(pixels_, [&](std::size_t pixel) {
    if (seen_[pixel].is_any())
      channel.values[pixel] = static_cast<float>(value(seen_[pixel], pixel));
  });
  image_.channels.push_back(std::move(channel));
}

template <class Value>
void Painter::add_vector(Pass pass, PixelFormat format, const Value& value) {
  std::vector<glm::vec3> vectors(pixels_);
  parallel_for_blocks(pixels_, [&](std::size_t pixel) {
    if (seen_[pixel].is_any()) vectors[pixel] = glm::vec3(value(seen_[pixel], pixel));
  });
  for (int axis = 0; axis < 3; ++axis)
    add_channel(pass, facts_of(pass).letters[static_cast<std::size_t>(axis)], format, 0.0F,
                [&](const SeenPlace&, std::size_t pixel) { return vectors[pixel][axis]; });
}

bool is_same(const landscape::Camera& a, const landscape::Camera& b) {
  return a.eye_m == b.eye_m && a.target_m == b.target_m;
}

/// A part of the way from one to the next.
landscape::Camera between(const landscape::Camera& from, const landscape::Camera& to, double part) {
  return {glm::mix(from.eye_m, to.eye_m, part), glm::mix(from.target_m, to.target_m, part),
          from.field_of_view_deg};
}

/// What is infinitely far moves as the camera turns. What the next camera has passed or nearly
/// touches goes on as it goes at first.
glm::dvec2 Painter::motion_px(const SeenPlace& seen, std::size_t pixel,
                              const landscape::Perspective& next, const Sway& sway) const {
  constexpr double nearest = 0.1;  // of the depth that it has
  const glm::dvec3 sway_m = sway.of(seen);
  if (is_same(landscape_.camera, facts_.next_camera) && sway_m == glm::dvec3(0.0))
    return glm::dvec2(0.0);
  const glm::dvec3 along = seen.is_any() ? seen.at_m - landscape_.camera.eye_m : direction(pixel);
  const auto later = [&](const landscape::Perspective& eye, double part) {
    return eye.seen(seen.is_any() ? seen.at_m + part * sway_m : eye.eye_m() + along);
  };
  const double least_m = nearest * perspective_.depth_along(along);
  glm::dvec3 then = later(next, 1.0);
  double part = 1.0;
  while (then.z < least_m) {
    part *= 0.5;
    const landscape::Camera camera = between(landscape_.camera, facts_.next_camera, part);
    then = later(perspective_of(landscape_, camera), part);
  }
  return (glm::dvec2(then) - middle_px(pixel)) / part;
}

void Painter::add(Pass pass) {
  const auto at = [](const SeenPlace& seen) { return glm::dvec2(seen.at_m); };
  const auto number = [&](const GroundFacts::Number& of) {
    add_channel(pass, 'V', PixelFormat::half, 0.0F,
                [&](const SeenPlace& seen, std::size_t) { return of(at(seen)); });
  };
  switch (pass) {
    case Pass::depth:
      add_channel(pass, 'Z', PixelFormat::float32, no_depth,
                  [&](const SeenPlace& seen, std::size_t pixel) {
                    return seen.distance_m * perspective_.depth_along(direction(pixel));
                  });
      image_.channels.push_back({"depth.A", PixelFormat::half, covered_});
      break;
    case Pass::normal:
      add_vector(pass, PixelFormat::half, [&](const SeenPlace& seen, std::size_t) {
        return seen.thing == SeenPlace::Thing::blade ? glm::dvec3(seen.blade_normal)
                                                     : sights_.ground_normal(seen.at_m);
      });
      break;
    case Pass::position:
      add_vector(pass, PixelFormat::float32,
                 [](const SeenPlace& seen, std::size_t) { return seen.at_m; });
      break;
    case Pass::motion: {
      const landscape::Perspective next = perspective_of(landscape_, facts_.next_camera);
      const Sway sway(landscape_, facts_);
      for (const int axis : {0, 1}) {
        ImageChannel channel{fmt::format("motion.{}", "XY"[axis]), PixelFormat::float32,
                             std::vector<float>(pixels_)};
        parallel_for_blocks(pixels_, [&](std::size_t pixel) {
          channel.values[pixel] =
              static_cast<float>(motion_px(seen_[pixel], pixel, next, sway)[axis]);
        });
        image_.channels.push_back(std::move(channel));
      }
      break;
    }
    case Pass::species:
      species_->add_to(image_);
      break;
    case Pass::instance:
      for (const int axis : {0, 1})
        add_channel(pass, "XY"[axis], PixelFormat::float32, no_cell,
                    [&](const SeenPlace& seen, std::size_t) {
                      if (seen.thing == SeenPlace::Thing::ground) return no_cell;
                      return static_cast<float>(origin_of(seen).cell[axis]);
                    });
      break;
    case Pass::snow:
      number(facts_.snow_m);
      break;
    case Pass::weathering:
      number(facts_.weathering);
      break;
    case Pass::wetness:
      number(facts_.wetness);
      break;
    case Pass::albedo: {
      const std::vector<glm::vec3> leaves = leaf_albedo(landscape_, seen_);
      add_vector(pass, PixelFormat::half, [&](const SeenPlace& seen, std::size_t pixel) {
        return seen.thing == SeenPlace::Thing::ground ? facts_.albedo(at(seen)) : leaves[pixel];
      });
      break;
    }
    case Pass::light:
      add_vector(pass, PixelFormat::half,
                 [&](const SeenPlace& seen, std::size_t) { return facts_.irradiance(at(seen)); });
      break;
  }
}

}  // namespace

LayeredImage paint(const landscape::Landscape& landscape, const GroundFacts& facts,
                   std::span<const Pass> passes) {
  Painter painter(landscape, facts);
  painter.look_at_middles();
  const auto has = [&](Pass pass) { return std::ranges::count(passes, pass) > 0; };
  if (has(Pass::depth) || has(Pass::species)) painter.look_for_coverage();
  for (const Pass pass : passes) painter.add(pass);
  LayeredImage image = std::move(painter).image();
  for (const Pass pass : passes)
    image.attributes[fmt::format("wold/{}", facts_of(pass).name)] =
        fmt::format("{}; {}", facts_of(pass).unit, facts_of(pass).meaning);
  const landscape::Camera& camera = landscape.camera;
  const auto place = [](const glm::dvec3& at_m) {
    return fmt::format("{:.9g} {:.9g} {:.9g}", at_m.x, at_m.y, at_m.z);
  };
  image.attributes["wold/camera"] =
      fmt::format("eye_m {}; target_m {}; horizontal field of view {:.9g} deg; up is Z",
                  place(camera.eye_m), place(camera.target_m), camera.field_of_view_deg);
  image.attributes["wold/frame"] = std::to_string(landscape.frame);
  image.attributes["wold/format"] = std::to_string(file_format);
  return image;
}

}  // namespace wold::passes
