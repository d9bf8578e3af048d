#include "grass/patch_state.h"

#include <fmt/format.h>

namespace wold::grass {

std::string PatchState::name() const {
  if (snow == 0) return fmt::format("k{:02}", key_frame);
  return fmt::format("k{:02}_s{}", key_frame, snow);
}

}  // namespace wold::grass
