#include "grass/ageing/patch_state.h"

#include <fmt/format.h>

namespace wold::grass {

std::string PatchState::name() const {
  std::string name = fmt::format("k{:02}", key_frame);
  if (snow > 0) name += fmt::format("_s{}", snow);
  if (light > 0) name += fmt::format("_l{}", light);
  return name;
}

}  // namespace wold::grass
