#pragma once

#include <vector>

#include "scene/consistency.h"

namespace wold::scene {

/// What an event changes: two events may not change the same of one layer at the same time.
enum class CloudChange { drift, amount, light };

/// What an event of that kind changes.
CloudChange change_of(const CloudEvent& event);

/// Whether the event happens to the layer, counted from 0.
bool happens_to(const CloudEvent& event, std::size_t layer);

/// Adds a problem for clouds and events that contradict each other or themselves: layers that are
/// not there, keys that an event of this kind has no use for, and
/// events that would change the same thing of one layer at the same time; these name both lines.
void report_cloud_contradictions(const Scene& scene, const Places& places,
                                 std::vector<Problem>& problems);

}  // namespace wold::scene
