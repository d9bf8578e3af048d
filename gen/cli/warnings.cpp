#include "cli/warnings.h"

#include <fmt/format.h>

#include "advice/scene_warnings.h"
#include "console/output.h"

namespace wold::cli {

void print_warnings(const scene::Scene& film, const phenology::FilmSeason* season) {
  for (const std::string& warning : advice::scene_warnings(film, season))
    console::print_message(fmt::format("warning: {}", warning));
}

void print_warnings(std::span<const Problem> warnings) {
  for (const Problem& warning : warnings)
    console::print_message(fmt::format("warning: {}", to_string(warning)));
}

}  // namespace wold::cli
