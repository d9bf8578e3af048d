#include "scene/cloud_consistency.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/calendar.h"
#include "scene/keys.h"
#include "scene/registry.h"
#include "scene/text.h"

namespace wold::scene {
namespace {

struct Report {
  const Scene& scene;
  const Places& places;
  std::vector<Problem>& problems;

  /// Of a key of an item, or of the item when the key was not given.
  SourcePosition place(const std::string& item, const char* leaf) const {
    const auto key = places.given.find(fmt::format("{}.{}", item, leaf));
    if (key != places.given.end()) return key->second;
    const auto table = places.given.find(item);
    return table == places.given.end() ? SourcePosition{} : table->second;
  }
  bool failed(const std::string& item, const char* leaf) const {
    return places.failed.count(fmt::format("{}.{}", item, leaf)) > 0;
  }
  void add(const std::string& item, const char* leaf, const std::string& message) {
    problems.push_back({place(item, leaf), fmt::format("{}.{}: {}", item, leaf, message)});
  }
};

std::string event_name(std::size_t event) { return item_name("cloud_events", event); }

/// The kinds of events that alone have this key; none when every kind has it.
std::vector<CloudEventKind> kinds_with(std::string_view leaf) {
  using enum CloudEventKind;
  if (leaf == "heading" || leaf == "speed" || leaf == "shear") return {wind};
  if (leaf == "factor") return {faster, slower};
  if (leaf == "by") return {gather, dissipate};
  if (leaf == "colour" || leaf == "sun_elevation") return {light};
  if (leaf == "fade") return {wind, gather, dissipate};
  return {};
}

/// A key is of no use to the event when another kind of event has it and it is not its default.
void report_useless_keys(Report& report, std::size_t event) {
  Scene plain;
  plain.cloud_events.resize(event + 1);
  const CloudEvent& found = report.scene.cloud_events[event];
  for (const Key& key : cloud_event_keys(event)) {
    const std::string leaf(leaf_of(key.name));
    const auto kinds = kinds_with(leaf);
    if (kinds.empty() || std::ranges::count(kinds, found.kind) > 0 ||
        key.get(report.scene) == key.get(plain))
      continue;
    std::vector<std::string_view> words(kinds.size());
    std::ranges::transform(kinds, words.begin(), word_of<CloudEventKind>);
    report.add(event_name(event), leaf.c_str(),
               fmt::format("found in a \"{}\" event, expected only in: {}", word_of(found.kind),
                           fmt::join(words, ", ")));
  }
}

void report_missing_layer(Report& report, std::size_t event) {
  const auto layers = static_cast<int>(report.scene.clouds.size());
  const int layer = report.scene.cloud_events[event].layer;
  if (layers > 0 && layer <= layers) return;
  report.add(event_name(event), "layer",
             fmt::format("found {}, but the scene has {} [[clouds]]", layer, layers));
}

void report_half_a_colour(Report& report, std::size_t event) {
  const std::size_t items = report.scene.cloud_events[event].colour.size();
  if (items != 0 && items != 3)
    report.add(event_name(event), "colour",
               fmt::format("found a list of {}, expected three numbers, or none", items));
}

bool is_day(const std::vector<std::int64_t>& date) {
  return date.size() == 3 && date_of(date).ok();
}

/// Whether the season's days are known, and those of an event in it.
bool has_days(const Scene& scene, const CloudEvent& event) {
  const Season& season = scene.season;
  return is_day(season.first) && is_day(season.last) &&
         date_of(season.first) < date_of(season.last) && is_day(event.date) &&
         (event.until.empty() || is_day(event.until));
}

void report_day(Report& report, std::size_t event, const char* leaf,
                const std::vector<std::int64_t>& date) {
  if (!is_day(date))
    report.add(event_name(event), leaf,
               fmt::format("found {}, expected a year, month and day of the calendar", date));
}

/// Days, and no seconds beside them.
void report_days(Report& report, std::size_t event) {
  static const CloudEvent usual;
  const CloudEvent& found = report.scene.cloud_events[event];
  const std::string name = event_name(event);
  if (found.date.empty()) {
    if (!found.until.empty())
      report.add(name, "until", "found a day, expected one with date, the day on which it begins");
    return;
  }
  if (!is_season(report.scene)) {
    report.add(name, "date",
               "found a day of a season, but the scene is none; expected start, or season.first");
    return;
  }
  report_day(report, event, "date", found.date);
  if (!found.until.empty()) report_day(report, event, "until", found.until);
  if (found.start_s != usual.start_s)
    report.add(name, "start", "found beside date, expected one of the two");
  if (!found.until.empty() && found.duration_s != usual.duration_s)
    report.add(name, "duration", "found beside until, expected one of the two");
  if (!has_days(report.scene, found)) return;
  const Season& season = report.scene.season;
  if (date_of(found.date) < date_of(season.first) || date_of(found.date) > date_of(season.last))
    report.add(name, "date",
               fmt::format("found {}, expected a day of the season, from {} to {}", found.date,
                           season.first, season.last));
  if (!found.until.empty() && date_of(found.until) <= date_of(found.date))
    report.add(name, "until",
               fmt::format("found {}, expected a day after date ({})", found.until, found.date));
}

/// The key that says when an event begins.
const char* begins(const CloudEvent& event) { return event.date.empty() ? "start" : "date"; }

std::string span_text(const Scene& scene, const CloudEvent& given) {
  const CloudEvent event = on_clock(scene, given);
  if (!given.date.empty())
    return fmt::format("\"{}\" from {} {}", word_of(event.kind), given.date,
                       given.until.empty() ? fmt::format("on for {} s", event.duration_s)
                                           : fmt::format("to {}", given.until));
  return fmt::format("\"{}\" from {} to {} s", word_of(event.kind), event.start_s,
                     event.start_s + event.duration_s);
}

std::string line_text(const SourcePosition& where) {
  return where.line == 0 ? "" : fmt::format(", line {}", where.line);
}

/// The events that change one thing of one layer, by their start.
std::vector<std::size_t> changes(const Report& report, std::size_t layer, CloudChange change) {
  const auto& events = report.scene.cloud_events;
  std::vector<std::size_t> found;
  for (std::size_t event = 0; event < events.size(); ++event) {
    const bool judged =
        !report.failed(event_name(event), "kind") && !report.failed(event_name(event), "layer") &&
        !report.failed(event_name(event), "start") &&
        !report.failed(event_name(event), "duration") &&
        !report.failed(event_name(event), "date") && !report.failed(event_name(event), "until") &&
        (events[event].date.empty() || has_days(report.scene, events[event]));
    if (judged && happens_to(events[event], layer) && change_of(events[event]) == change)
      found.push_back(event);
  }
  std::ranges::stable_sort(
      found, {}, [&](std::size_t event) { return on_clock(report.scene, events[event]).start_s; });
  return found;
}

void report_overlaps(Report& report, std::size_t layer, CloudChange change) {
  const auto& events = report.scene.cloud_events;
  const std::vector<std::size_t> in_order = changes(report, layer, change);
  for (std::size_t i = 1; i < in_order.size(); ++i) {
    const CloudEvent before = on_clock(report.scene, events[in_order[i - 1]]);
    const CloudEvent next = on_clock(report.scene, events[in_order[i]]);
    if (next.start_s >= before.start_s + before.duration_s) continue;
    const std::string other = event_name(in_order[i - 1]);
    report.add(
        event_name(in_order[i]), begins(next),
        fmt::format("found {} on layer {}, before {} ({}{}) has ended; expected one change "
                    "of a layer's {} after the other",
                    span_text(report.scene, next), layer + 1, span_text(report.scene, before),
                    other, line_text(report.place(other, begins(before))),
                    change == CloudChange::drift    ? "drift"
                    : change == CloudChange::amount ? "amount"
                                                    : "light"));
  }
}

}  // namespace

CloudChange change_of(const CloudEvent& event) {
  switch (event.kind) {
    case CloudEventKind::gather:
    case CloudEventKind::dissipate:
      return CloudChange::amount;
    case CloudEventKind::light:
      return CloudChange::light;
    case CloudEventKind::wind:
    case CloudEventKind::faster:
    case CloudEventKind::slower:
      break;
  }
  return CloudChange::drift;
}

bool happens_to(const CloudEvent& event, std::size_t layer) {
  return event.layer == 0 || event.layer == static_cast<int>(layer) + 1;
}

void report_cloud_contradictions(const Scene& scene, const Places& places,
                                 std::vector<Problem>& problems) {
  Report report{scene, places, problems};
  for (std::size_t event = 0; event < scene.cloud_events.size(); ++event) {
    report_missing_layer(report, event);
    report_half_a_colour(report, event);
    report_days(report, event);
    report_useless_keys(report, event);
  }
  for (std::size_t layer = 0; layer < scene.clouds.size(); ++layer)
    for (const CloudChange change : {CloudChange::drift, CloudChange::amount, CloudChange::light})
      report_overlaps(report, layer, change);
}

}  // namespace wold::scene
