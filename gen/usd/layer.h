#pragma once

#include <string>
#include <string_view>

namespace wold::usd {

/// First and last time code of a stage: numbers of frames.
struct TimeRange {
  int first = 1;
  int last = 1;
};

/// How a stage begins: metres, z up, frames as time codes, its default prim "Landscape", and what
/// its numbers mean, in words. `facts`: more entries of its customLayerData, each a line.
std::string layer_header(const TimeRange& time, std::string_view doc, std::string_view facts = {});

/// The begin of the prim /Landscape, whose variant set `light` has "baked" chosen.
std::string landscape_begin();

}  // namespace wold::usd
