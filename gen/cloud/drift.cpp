#include "cloud/drift.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/complex_plane.h"
#include "core/elementary.h"
#include "core/random.h"
#include "phenology/film_season.h"
#include "scene/calendar.h"

namespace wold::cloud {
namespace {

using scene::CloudEventKind;
using std::numbers::pi;

constexpr int gust_waves = 8;
constexpr double shortest_gust_s = 20.0, longest_gust_s = 900.0;

/// The heading nearest to `from` that points where `to` does.
double nearest_turn(double from, double to) { return from + std::remainder(to - from, 2.0 * pi); }

glm::dvec2 east_north(const std::complex<double>& north_east) {
  return {north_east.imag(), north_east.real()};
}

double fraction_done(const DriftSegment& segment, double seconds) {
  return std::clamp(seconds / segment.duration_s, 0.0, 1.0);
}

struct Wave {
  double per_s;  ///< angular frequency
  double phase;
};

Wave gust_wave(int wave, int axis, std::uint64_t key) {
  const double period_s = shortest_gust_s * math::pow(longest_gust_s / shortest_gust_s,
                                                      static_cast<double>(wave) / (gust_waves - 1));
  return {2.0 * pi / period_s,
          2.0 * pi *
              random_uniform({key, key_of("gust"), static_cast<std::uint64_t>(wave),
                              static_cast<std::uint64_t>(axis)})};
}

/// Sum over the waves of `amplitude * value(wave)`, whose squared mean over time is deviation^2.
template <class Value>
glm::dvec2 gusts(double deviation_m_s, std::uint64_t key, const Value& value) {
  const double amplitude = deviation_m_s * std::sqrt(2.0 / gust_waves);
  glm::dvec2 sum(0.0);
  for (int axis = 0; axis < 2; ++axis)
    for (int wave = 0; wave < gust_waves; ++wave)
      sum[axis] += amplitude * value(gust_wave(wave, axis, key));
  return sum;
}

/// What an event adds to [Wang2010]'s rate of drift while it lasts, in cells a frame.
double boost_of(CloudEventKind kind) {
  constexpr double speed_increment = 0.01;
  if (kind == CloudEventKind::faster) return speed_increment;
  return kind == CloudEventKind::slower ? -speed_increment : 0.0;
}

double speed_after(const scene::CloudEvent& event, double before_m_s) {
  if (event.kind == CloudEventKind::wind) return event.speed_m_s;
  return event.kind == CloudEventKind::faster ? before_m_s * event.factor
                                              : before_m_s / event.factor;
}

WindNow wind_at(const std::vector<WindNow>& winds, double time_s) {
  const auto after = std::ranges::upper_bound(winds, time_s, {}, &WindNow::time_s);
  if (after == winds.begin()) return winds.front();
  if (after == winds.end()) return winds.back();
  const WindNow& before = *(after - 1);
  const double fraction = (time_s - before.time_s) / (after->time_s - before.time_s);
  return {time_s, std::lerp(before.speed_factor, after->speed_factor, fraction),
          std::lerp(before.turned_rad, after->turned_rad, fraction)};
}

DriftSegment part_of(const DriftSegment& whole, double from_s, double to_s,
                     const std::vector<WindNow>& winds) {
  const double from = fraction_done(whole, from_s - whole.start_s);
  const double to = fraction_done(whole, to_s - whole.start_s);
  const WindNow first = wind_at(winds, from_s), last = wind_at(winds, to_s);
  return {from_s,
          to_s - from_s,
          first.speed_factor * std::lerp(whole.speed_m_s, whole.speed_end_m_s, from),
          last.speed_factor * std::lerp(whole.speed_m_s, whole.speed_end_m_s, to),
          first.turned_rad + std::lerp(whole.heading_rad, whole.heading_end_rad, from),
          last.turned_rad + std::lerp(whole.heading_rad, whole.heading_end_rad, to)};
}

/// The drift with what the winds make of it: cut where a wind begins, even between the cuts.
std::vector<DriftSegment> in_winds(const std::vector<DriftSegment>& segments,
                                   const std::vector<WindNow>& winds) {
  std::vector<DriftSegment> parts;
  for (const DriftSegment& segment : segments) {
    double now_s = segment.start_s;
    const double end_s = segment.start_s + segment.duration_s;
    for (const WindNow& wind : winds)
      if (wind.time_s > now_s && wind.time_s < end_s) {
        parts.push_back(part_of(segment, now_s, wind.time_s, winds));
        now_s = wind.time_s;
      }
    parts.push_back(part_of(segment, now_s, end_s, winds));
  }
  return parts;
}

}  // namespace

glm::dvec2 way_m(const DriftSegment& segment, double seconds) {
  using Complex = std::complex<double>;
  const double t = seconds;
  const double turn = (segment.heading_end_rad - segment.heading_rad) / segment.duration_s;
  const double gain = (segment.speed_end_m_s - segment.speed_m_s) / segment.duration_s;
  const double speed = segment.speed_m_s;
  const Complex ahead = from_polar(1.0, segment.heading_rad);
  constexpr double small_turn = 1e-3;  // below it the closed form loses digits, the series none
  if (std::abs(turn * t) < small_turn) {
    const Complex i(0.0, turn);
    return east_north(ahead * (speed * t + (gain + speed * i) * t * t / 2.0 +
                               (gain + speed * i / 2.0) * i * t * t * t / 3.0 +
                               (gain / 2.0 + speed * i / 6.0) * i * i * t * t * t * t / 4.0));
  }
  const Complex turned = from_polar(1.0, turn * t);
  const Complex i(0.0, 1.0);
  return east_north(ahead * (-i * ((speed + gain * t) * turned - speed) / turn +
                             gain * (turned - 1.0) / (turn * turn)));
}

glm::dvec2 gust_way_m(double deviation_m_s, double time_s, std::uint64_t key) {
  return gusts(deviation_m_s, key, [&](const Wave& wave) {
    return (math::sin(wave.per_s * time_s + wave.phase) - math::sin(wave.phase)) / wave.per_s;
  });
}

glm::dvec2 gust_velocity_m_s(double deviation_m_s, double time_s, std::uint64_t key) {
  return gusts(deviation_m_s, key,
               [&](const Wave& wave) { return math::cos(wave.per_s * time_s + wave.phase); });
}

std::vector<WindNow> season_winds(const scene::CloudsPart& part,
                                  const phenology::FilmSeason* season) {
  if (season == nullptr) return {};
  const double days = scene::season_length_days(part.season);
  const double last_s = part.season_s;
  std::vector<WindNow> winds;
  for (int day = 0; day <= days; ++day) {
    const phenology::WindChange wind = season->wind(day);
    winds.push_back(
        {last_s * day / days, wind.speed_factor,
         winds.empty() ? wind.turned_rad : nearest_turn(winds.back().turned_rad, wind.turned_rad)});
  }
  return winds;
}

Drift::Drift(const scene::CloudLayer& layer, const std::vector<scene::CloudEvent>& in_order,
             std::uint64_t key, const std::vector<WindNow>& winds)
    : gusts_m_s_(layer.gusts_m_s), key_(key) {
  constexpr double for_ever_s = std::numeric_limits<double>::max();
  double speed = layer.speed_m_s;
  double heading = glm::radians(layer.heading_deg);
  double now_s = 0.0;
  for (const scene::CloudEvent& event : in_order) {
    if (event.start_s > now_s)
      segments_.push_back({now_s, event.start_s - now_s, speed, speed, heading, heading});
    const double next_speed = speed_after(event, speed);
    const double next_heading = event.kind == CloudEventKind::wind
                                    ? nearest_turn(heading, glm::radians(event.heading_deg))
                                    : heading;
    segments_.push_back(
        {event.start_s, event.duration_s, speed, next_speed, heading, next_heading});
    now_s = event.start_s + event.duration_s;
    speed = next_speed;
    heading = next_heading;
  }
  segments_.push_back({now_s, for_ever_s, speed, speed, heading, heading});
  if (!winds.empty()) segments_ = in_winds(segments_, winds);
}

glm::dvec2 Drift::way_m(double time_s) const {
  glm::dvec2 way = gust_way_m(gusts_m_s_, time_s, key_);
  for (const DriftSegment& segment : segments_) {
    if (time_s <= segment.start_s) break;
    way += cloud::way_m(segment, std::min(time_s - segment.start_s, segment.duration_s));
  }
  return way;
}

glm::dvec2 Drift::velocity_m_s(double time_s) const {
  const DriftSegment* now = &segments_.front();
  for (const DriftSegment& segment : segments_)
    if (segment.start_s <= time_s) now = &segment;
  const double fraction = fraction_done(*now, time_s - now->start_s);
  const double heading = std::lerp(now->heading_rad, now->heading_end_rad, fraction);
  return std::lerp(now->speed_m_s, now->speed_end_m_s, fraction) *
             glm::dvec2(math::sin(heading), math::cos(heading)) +
         gust_velocity_m_s(gusts_m_s_, time_s, key_);
}

PaperDrift::PaperDrift(const std::vector<scene::CloudEvent>& in_order, double frame_seconds,
                       std::uint64_t key)
    : rates_({{0.0, 1e-4}}),
      frame_seconds_(frame_seconds),
      start_(random_uniform({key, key_of("paper drift")})) {
  double rate = 1e-4;
  for (const scene::CloudEvent& event : in_order) {
    if (event.kind == CloudEventKind::wind) rate = -rate;
    rates_.push_back({event.start_s, rate + boost_of(event.kind)});
    rates_.push_back({event.start_s + event.duration_s, rate});
  }
}

glm::dvec2 PaperDrift::way_cells(double time_s) const {
  double x = start_;
  for (std::size_t i = 0; i < rates_.size() && rates_[i].start_s < time_s; ++i) {
    const double end_s = i + 1 < rates_.size() ? std::min(time_s, rates_[i + 1].start_s) : time_s;
    x += rates_[i].per_frame * (end_s - rates_[i].start_s) / frame_seconds_;
  }
  return {x, math::sin(x)};
}

}  // namespace wold::cloud
