#include "cloud/timeline.h"

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "light/atmosphere.h"
#include "scene/calendar.h"
#include "scene/cloud_consistency.h"

namespace wold::cloud {
namespace {

using scene::CloudEvent;
using scene::CloudEventKind;
using scene::CloudFade;

/// The events that change this of the layer, by their start.
std::vector<CloudEvent> changes(const scene::CloudsPart& part, std::size_t layer,
                                scene::CloudChange change) {
  std::vector<CloudEvent> found;
  for (const CloudEvent& event : part.events)
    if (scene::happens_to(event, layer) && scene::change_of(event) == change)
      found.push_back(scene::on_clock(part.season, part.season_s, event));
  std::ranges::stable_sort(found, {}, &CloudEvent::start_s);
  return found;
}

std::vector<CloudEvent> shearing(const std::vector<CloudEvent>& events) {
  std::vector<CloudEvent> found;
  std::ranges::copy_if(events, std::back_inserter(found), [](const CloudEvent& event) {
    return event.kind == CloudEventKind::wind && event.shear > 0.0;
  });
  return found;
}

/// How much of an event has happened, in [0, 1].
double done(const CloudEvent& event, double time_s) {
  return std::clamp((time_s - event.start_s) / event.duration_s, 0.0, 1.0);
}

double amount_after(const CloudEvent& event, double before) {
  return event.kind == CloudEventKind::gather ? before + event.fraction * (1.0 - before)
                                              : before * (1.0 - event.fraction);
}

std::uint64_t layer_key(const scene::CloudsPart& part, std::size_t layer) {
  return random_bits({part.seed, key_of("cloud layer"), layer, key_of("drift")});
}

glm::dvec3 colour_of(const CloudEvent& event, double turbidity) {
  if (event.colour.size() == 3) return {event.colour[0], event.colour[1], event.colour[2]};
  return sunlight_colour(event.sun_elevation_deg, turbidity);
}

}  // namespace

glm::dvec3 sunlight_colour(double sun_elevation_deg, double turbidity) {
  const glm::dvec3 relative = light::sunlight_klx(glm::radians(sun_elevation_deg), turbidity) /
                              light::sunlight_klx(glm::radians(90.0), turbidity);
  const glm::dvec3 positive = glm::max(relative, glm::dvec3(0.0));
  return positive / std::max({positive.r, positive.g, positive.b});
}

Timeline::Timeline(const scene::CloudsPart& part, std::size_t layer, double cell_m,
                   const phenology::FilmSeason* season)
    : winds_(shearing(changes(part, layer, scene::CloudChange::drift))),
      amounts_(changes(part, layer, scene::CloudChange::amount)),
      lights_(changes(part, layer, scene::CloudChange::light)),
      shapes_({Shape{}}),
      gathered_(part.layers.at(layer).gathered),
      cell_m_(cell_m),
      drift_(part.layers[layer], changes(part, layer, scene::CloudChange::drift),
             layer_key(part, layer), season_winds(part, season)) {
  for (const CloudEvent& event : lights_)
    light_colours_.push_back(colour_of(event, part.turbidity));
  for (const CloudEvent& event : winds_)
    shapes_.push_back({glm::radians(event.heading_deg), event.shear});
  if (part.layers[layer].motion == scene::Law::paper)
    paper_drift_.emplace(changes(part, layer, scene::CloudChange::drift), part.frame_seconds,
                         layer_key(part, layer));
}

LayerMoment Timeline::at(double time_s) const {
  LayerMoment moment;
  set_way(moment, time_s);
  set_amount(moment, time_s);
  set_shape(moment, time_s);
  set_light(moment, time_s);
  return moment;
}

void Timeline::set_way(LayerMoment& moment, double time_s) const {
  if (paper_drift_) {
    moment.way_m = paper_drift_->way_cells(time_s) * cell_m_;
    return;
  }
  moment.way_m = drift_.way_m(time_s);
  moment.velocity_m_s = drift_.velocity_m_s(time_s);
}

void Timeline::set_amount(LayerMoment& moment, double time_s) const {
  moment.amount = gathered_;
  moment.amount_is_alpha = !amounts_.empty() && amounts_.front().fade == CloudFade::paper;
  for (const CloudEvent& event : amounts_) {
    if (time_s < event.start_s) break;
    moment.amount_is_alpha = event.fade == CloudFade::paper;
    moment.amount =
        std::lerp(moment.amount, amount_after(event, moment.amount), done(event, time_s));
  }
}

void Timeline::set_shape(LayerMoment& moment, double time_s) const {
  for (std::size_t wind = 0; wind < winds_.size() && time_s >= winds_[wind].start_s; ++wind) {
    moment.shape = wind;
    moment.next_shape = wind + 1;
    moment.next_fraction = done(winds_[wind], time_s);
    moment.shapes_by_alpha = winds_[wind].fade == CloudFade::paper;
  }
}

void Timeline::set_light(LayerMoment& moment, double time_s) const {
  for (std::size_t i = 0; i < lights_.size() && time_s >= lights_[i].start_s; ++i)
    moment.light = glm::mix(moment.light, light_colours_[i], done(lights_[i], time_s));
}

}  // namespace wold::cloud
