#include <fmt/format.h>

#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/warnings.h"
#include "console/output.h"
#include "core/angle.h"
#include "core/elementary.h"
#include "film/machine_check.h"
#include "scene/parse.h"

namespace wold::cli {
namespace {

void check_place(const place::WindPoint& point, double size_m) {
  if (Square{.size_m = size_m}.contains(point.place_m)) return;
  throw InputError(fmt::format("--at: found {},{}, expected a place on the terrain, 0 to {} m",
                               point.place_m.x, point.place_m.y, size_m));
}

/// Where it blows to, clockwise from north, in [0, 360).
double heading_deg(const glm::dvec3& velocity_m_s) {
  const double heading = degrees(math::atan2(velocity_m_s.x, velocity_m_s.y));
  return heading < 0.0 ? heading + 360.0 : heading;
}

std::string text_of(const std::vector<place::WindPoint>& points,
                    const std::vector<glm::dvec3>& velocities_m_s) {
  std::string text =
      fmt::format("{:>10} {:>10} {:>8} {:>10} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "x_m", "y_m", "z_m",
                  "t_s", "east", "north", "up", "m/s", "to_deg");
  for (std::size_t i = 0; i < points.size(); ++i) {
    const place::WindPoint& at = points[i];
    const glm::dvec3& v = velocities_m_s[i];
    text +=
        fmt::format("{:10.2f} {:10.2f} {:8.2f} {:10.3f} {:8.3f} {:8.3f} {:8.3f} {:8.3f} {:8.1f}\n",
                    at.place_m.x, at.place_m.y, at.height_m, at.time_s, v.x, v.y, v.z,
                    glm::length(v), heading_deg(v));
  }
  return text;
}

std::string json_of(const std::vector<place::WindPoint>& points,
                    const std::vector<glm::dvec3>& velocities_m_s) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const place::WindPoint& at = points[i];
    const glm::dvec3& v = velocities_m_s[i];
    all.push_back({{"version", 1},
                   {"place_m", {at.place_m.x, at.place_m.y}},
                   {"height_m", at.height_m},
                   {"time_s", at.time_s},
                   {"velocity_m_s", {v.x, v.y, v.z}}});
  }
  return all.dump(2) + '\n';
}

}  // namespace

ExitCode run_wind(const WindOptions& options) {
  const auto [scene, places, warnings] =
      scene::read_located_scene(options.scene, options.overrides);
  print_warnings(warnings);
  film::require_files(scene, places);
  for (const place::WindPoint& point : options.points) check_place(point, scene.terrain.size_m);
  const std::vector<glm::dvec3> velocities_m_s = place::wind_at(scene, options.points);
  console::print_data(options.json ? json_of(options.points, velocities_m_s)
                                   : text_of(options.points, velocities_m_s));
  return ExitCode::done;
}

}  // namespace wold::cli
