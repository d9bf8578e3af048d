#include "snow/paper_flakes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "core/random.h"
#include "core/simd_turns.h"
#include "snow/size_distribution.h"

namespace wold::snow {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double gravity_m_s2 = 9.81;
constexpr double step_s = 0.04;  ///< dt, of 25 pictures a second

constexpr double flutter_m_s = 0.3, slowest_flutter_per_s = 0.3, flutter_range_per_s = 0.7;

double draw(std::uint64_t key, std::uint64_t purpose) {
  return static_cast<double>(static_cast<std::int64_t>(mixed(key ^ purpose) >> 11)) * 0x1.0p-53;
}

/// Thirty-two bits as a number in [0, 1).
double unit_fraction(std::uint32_t bits) {
  return 0.5 + static_cast<double>(static_cast<std::int32_t>(bits ^ 0x80000000U)) * 0x1p-32;
}

std::uint32_t low_half(std::uint64_t bits) { return static_cast<std::uint32_t>(bits); }
std::uint32_t high_half(std::uint64_t bits) { return static_cast<std::uint32_t>(bits >> 32); }

/// The distance at which 1/e of the flakes are drawn.
double reach_of(const glm::dvec3& box_m) { return std::min(box_m.x, box_m.y); }

}  // namespace

glm::dvec3 PaperFlake::velocity_m_s() const {
  return v0_m_s + vf_m_s + vr_m_s + glm::dvec3(0.0, 0.0, -gravity_m_s2 * step_s);
}

PaperSnow::PaperSnow(const scene::PrecipitationPart& part, const Weather& weather,
                     const FlakePictures& pictures)
    : weather_(weather),
      pictures_(pictures),
      wind_(weather, part.wind.field == scene::WindPattern::steady ? 0.0 : part.wind.turbulence,
            random_bits({part.seed, key_of("paper snow"), 0, key_of("wind")})),
      key_(random_bits({part.seed, key_of("paper snow"), 0, key_of("flakes")})),
      box_m_(part.snowfall.box_m[0], part.snowfall.box_m[1], part.snowfall.box_m[2]),
      crystal_(part.snowfall.crystal),
      asked_for_(part.snowfall.flakes),
      shutter_s_(part.snowfall.shutter_s) {
  constexpr std::uint64_t max_of_the_papers = 4000;
  if (part.wind.field == scene::WindPattern::tornado)
    tornado_.emplace(part, key_,
                     asked_for_ > 0.0 ? static_cast<std::uint64_t>(asked_for_) : max_of_the_papers);
}

PaperSnow::Moment PaperSnow::moment(double time_s) const {
  return {time_s, wind_.common(time_s), wind_.moment(time_s)};
}

PaperSnow::Carried PaperSnow::carried(const Moment& moment, const PaperBox& box) {
  const glm::dvec2 way =
      (glm::dvec2(moment.common.way_m) - glm::dvec2(box.low_m)) / glm::dvec2(box.size_m);
  return {
      {turn_of(way.x), turn_of(way.y)}, moment.time_s / box.size_m.z, box.low_m.z / box.size_m.z};
}

WOLD_LANES_WIDE void PaperSnow::drift(std::uint64_t first, const Carried& carried,
                                      const PaperBox& box, Drifting& flakes) const {
  const Carried by = carried;
  const glm::dvec3 size_m = box.size_m;
  Lanes<std::uint64_t> starts, births;
  for (std::size_t i = 0; i < lanes; ++i) {
    flakes.key[i] = mixed(key_ ^ (first + i));
    starts[i] = mixed(flakes.key[i] ^ key_of("start"));
  }
  for (std::size_t i = 0; i < lanes; ++i) {
    const double v0_m_s = -(0.5 + 0.5 * unit_fraction(low_half(starts[i])));
    const double boxes = unit_fraction(high_half(starts[i])) +
                         (v0_m_s - gravity_m_s2 * step_s) * by.per_m_s - by.bottom;
    // The whole number below, and as an integer the end of its bits when it is so raised.
    constexpr double rounder = 0x1.8p52;
    const double raised = (boxes - 0.5) + rounder;
    flakes.births[i] = std::bit_cast<std::int64_t>(rounder) - std::bit_cast<std::int64_t>(raised);
    flakes.z_m[i] = size_m.z * (boxes - (raised - rounder));
    flakes.v0_m_s[i] = v0_m_s;
  }
  for (std::size_t i = 0; i < lanes; ++i)
    births[i] = mixed(flakes.key[i] ^ static_cast<std::uint64_t>(flakes.births[i]));
  for (std::size_t i = 0; i < lanes; ++i) {
    flakes.x_m[i] = size_m.x * unit_fraction(low_half(births[i]) + by.way.x);
    flakes.y_m[i] = size_m.y * unit_fraction(high_half(births[i]) + by.way.y);
  }
}

PaperFlake PaperSnow::flake(const Drifting& drifting, std::size_t lane, const Moment& moment,
                            const PaperBox& box) const {
  const std::uint64_t key = drifting.key[lane];
  PaperFlake flake;
  flake.start_assign = drifting.births[lane];
  const std::uint64_t looks = mixed(key ^ key_of("size")), turns = mixed(key ^ key_of("rot"));
  flake.size_m = 0.006 + 0.01 * unit_fraction(low_half(looks));
  flake.colour.a = static_cast<float>(0.7 + 0.3 * unit_fraction(high_half(looks)));
  flake.rot_per_s = unit_fraction(low_half(turns)) - 0.5;
  flake.angle_turns = off_whole(unit_fraction(high_half(turns)) + flake.rot_per_s * moment.time_s);

  // Level winds alone: the height says when a flake is born again.
  const auto gust = wind_.own_gust(moment.gusts, mixed(key ^ key_of("vf")));
  flake.v0_m_s = {0.0, 0.0, drifting.v0_m_s[lane]};
  flake.vf_m_s = {
      glm::dvec2(moment.common.velocity_m_s) + glm::dvec2(gust.velocity_m_s.x, gust.velocity_m_s.y),
      0.0};
  const std::uint64_t flutters = mixed(key ^ key_of("flutter"));
  const double flutter_per_s =
      slowest_flutter_per_s + flutter_range_per_s * unit_fraction(low_half(flutters));
  const auto flutter = static_cast<float>(
      off_whole(unit_fraction(high_half(flutters)) + flutter_per_s * moment.time_s));
  const glm::dvec2 circle(cosine_of_turns(flutter), sine_of_turns(flutter));
  flake.vr_m_s = flutter_m_s * glm::dvec3(-circle.y, circle.x, 0.0);

  const glm::dvec2 own_way_m =
      glm::dvec2(gust.way_m.x, gust.way_m.y) + flutter_m_s / (two_pi * flutter_per_s) * circle;
  flake.pos_m = box.low_m + glm::dvec3(drifting.x_m[lane], drifting.y_m[lane], drifting.z_m[lane]) +
                glm::dvec3(own_way_m, 0.0);
  return flake;
}

PaperFlake PaperSnow::flake(std::uint64_t i, const Moment& moment, const PaperBox& box) const {
  Drifting drifting;
  drift(i, carried(moment, box), box, drifting);
  return flake(drifting, 0, moment, box);
}

double PaperSnow::farthest_own_way_m() const {
  return wind_.farthest_own_gust_m() + flutter_m_s / (two_pi * slowest_flutter_per_s);
}

double PaperSnow::flakes_in_view(double rate_mm_h) const {
  if (asked_for_ > 0.0) return asked_for_;
  constexpr std::array<glm::dvec2, 4> figure_6 = {
      {{0.0, 0.0}, {0.4, 500.0}, {1.2, 1000.0}, {4.0, 4000.0}}};
  for (std::size_t i = 1; i < figure_6.size(); ++i) {
    const glm::dvec2& low = figure_6[i - 1];
    const glm::dvec2& high = figure_6[i];
    if (rate_mm_h <= high.x)
      return std::lerp(low.y, high.y, (rate_mm_h - low.x) / (high.x - low.x));
  }
  return figure_6.back().y;
}

PaperBox PaperSnow::box_of(const Frustum& frustum, const Heightfield& ground) const {
  const glm::dvec3& eye_m = frustum.eye_m();
  const glm::dvec2 ahead(frustum.ahead());
  // Most of it before the eye: half its lesser side ahead, or none where the view is steep.
  const glm::dvec2 centre_m = glm::dvec2(eye_m) + 0.5 * std::min(box_m_.x, box_m_.y) * ahead;
  const auto ground_m = static_cast<double>(ground.sample(eye_m.x, eye_m.y));
  // From the ground, unless the eye is so high that it would not see the top.
  const double bottom_m = std::max(ground_m, eye_m.z - 0.5 * box_m_.z);
  return {{centre_m - 0.5 * glm::dvec2(box_m_), bottom_m}, box_m_};
}

Flake PaperSnow::shown(const PaperFlake& flake, std::uint64_t bits) const {
  constexpr double mm_per_m = 1000.0;
  return {flake.pos_m,
          flake.velocity_m_s(),
          flake.size_m,
          picked_crystal(crystal_fractions(crystal_, mm_per_m * flake.size_m),
                         draw(bits, key_of("crystal"))),
          bits,
          flake.colour.a,
          static_cast<float>(flake.angle_turns)};
}

SeenFlakes PaperSnow::at(double time_s, const SnowView& view, const Heightfield& ground) const {
  const double rate_mm_h = weather_.falling_snow_mm_h(time_s, view.eye_m.z);
  if (!(rate_mm_h > 0.0)) return {};
  const Frustum frustum(view);
  const PaperBox box = box_of(frustum, ground);
  const Moment now = moment(time_s);
  const FlakeLook look(pictures_, frustum, shutter_s_);

  // Of n flakes per m3 those in view are n times the integral of exp(-r / reach) over the pyramid,
  // as far as the box goes.
  const double reach_m = reach_of(box_m_);
  const double x = std::min(box_m_.x, box_m_.y) / reach_m;
  const double seen_m3 = frustum.solid_angle_sr() * math::pow(reach_m, 3) *
                         (2.0 - (x * x + 2.0 * x + 2.0) * math::exp(-x));
  const double in_box = flakes_in_view(rate_mm_h) * box_m_.x * box_m_.y * box_m_.z / seen_m3;

  const FlakeCuller culler(look, frustum, ground);
  const auto margin_m = static_cast<float>(farthest_own_way_m());
  const Carried moved = carried(now, box);
  const glm::dvec3 low_from_eye_m = box.low_m - frustum.eye_m();
  std::vector<Range> parts;
  split(0, 0, static_cast<std::uint64_t>(std::llround(in_box)), parts);
  FlakeCollector collector;
  collector.add(parts.size(), [&](std::size_t part, std::vector<SeenFlake>& seen) {
    FlakeLanes flakes = {};
    std::size_t count = 0;
    const auto see = [&] {
      culler.see(
          flakes, std::exchange(count, 0), [](std::size_t) { return true; }, seen);
    };
    Drifting drifting;
    VectorLanes from_eye;
    const Frustum pyramid = frustum;
    for (std::uint64_t first = parts[part].first; first < parts[part].last; first += lanes) {
      drift(first, moved, box, drifting);
      for (std::size_t i = 0; i < lanes; ++i) {
        from_eye.x[i] = static_cast<float>(low_from_eye_m.x + drifting.x_m[i]);
        from_eye.y[i] = static_cast<float>(low_from_eye_m.y + drifting.y_m[i]);
        from_eye.z[i] = static_cast<float>(low_from_eye_m.z + drifting.z_m[i]);
      }
      const Chosen chosen = Chosen::by(
          [&](std::size_t i) { return pyramid.touches_from_eye(from_eye.at(i), margin_m); },
          std::min<std::uint64_t>(lanes, parts[part].last - first));
      for (std::size_t n = 0; n < chosen.count; ++n) {
        const std::size_t i = chosen.lane[n];
        const auto distance_m = static_cast<double>(glm::length(from_eye.at(i)));
        const std::uint64_t bits = mixed(drifting.key[i] ^ key_of("look"));
        if (draw(bits, key_of("drawn")) >= math::exp(-distance_m / reach_m)) continue;
        flakes.set(count++, shown(flake(drifting, i, now, box), bits), frustum.eye_m());
        if (count == lanes) see();
      }
    }
    see();
  });
  const FlakeLook whirled(pictures_, frustum, std::max(shutter_s_, whirl_shutter_s));
  if (tornado_) collector.add(*tornado_, time_s, whirled, frustum, ground);
  return {collector.farthest_first(view.eye_m),
          gunn_marshall(rate_mm_h).extinction_per_m(seen_efficiency)};
}

}  // namespace wold::snow
