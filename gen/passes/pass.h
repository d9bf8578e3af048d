#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace wold::passes {

/// What is said of every pixel beside its picture, in the order of files and lists.
enum class Pass {
  depth,
  normal,
  position,
  motion,
  species,
  instance,
  snow,
  weathering,
  wetness,
  albedo,
  light
};

/// A pass, as its file and `wold inspect` explain it.
struct PassFacts {
  Pass pass;
  std::string_view name;     ///< its layer's, and its word on the command line
  std::string_view letters;  ///< its channels'; empty: those of Cryptomatte
  std::string_view unit;     ///< "m"; "1" of a fraction or a unit vector
  std::string_view meaning;  ///< with axes, and what stands where nothing is
};

/// All that there are, in order.
std::span<const PassFacts> all_passes();
const PassFacts& facts_of(Pass pass);

/// What a pixel of a pass takes in a file that is not packed, in bytes. `names`: how many may cover
/// it.
double bytes_per_pixel(Pass pass, std::size_t names);

/// The names of all.
std::string names_of_all();

/// The passes that a list such as "depth,normal" names, or "all": in order, each once. Throws
/// InputError that lists what there is, also for an empty list.
std::vector<Pass> passes_of(std::string_view text);

/// The list that names them: "all" where they are all.
std::string text_of(std::span<const Pass> passes);

}  // namespace wold::passes
