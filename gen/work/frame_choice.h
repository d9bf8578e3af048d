#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace wold::work {

/// Which frames of a film somebody asks for: by number, or those of shots. Nothing: all.
struct FrameChoice {
  std::vector<int> numbers = {};        ///< from 1, rising
  std::vector<std::string> shots = {};  ///< by name; only where there are no numbers

  bool operator==(const FrameChoice&) const = default;
};

/// Their numbers, from 1, rising. `scene` is a film, see phenology::as_film(). Throws InputError
/// where the film does not have them.
std::vector<int> chosen_frames(const FrameChoice& choice, const scene::Scene& scene);

/// 1 to `count`.
std::vector<int> counted(int count);

/// "1-3,7": the form in which frames are given.
std::string ranges_text(const std::vector<int>& rising);

}  // namespace wold::work
