#include "work/frame_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

#include "core/error.h"
#include "scene/nearest.h"
#include "scene/shots.h"
#include "scene/text.h"

namespace wold::work {
namespace {

std::vector<int> of_numbers(const std::vector<int>& numbers, int count) {
  for (const int frame : numbers)
    if (frame > count)
      throw InputError(
          fmt::format("--frames: found {}, expected frames from 1 to {}: the scene has {}", frame,
                      count, count));
  return numbers;
}

[[noreturn]] void refuse_shot(const std::string& name, const std::vector<scene::Shot>& shots) {
  if (shots.empty())
    throw InputError(
        fmt::format("--shot: found {}, but the scene has no [[shots]]; --frames takes some of its "
                    "frames by number",
                    scene::in_quotes(name)));
  std::vector<std::string> names;
  for (const scene::Shot& shot : shots) names.push_back(shot.name);
  throw InputError(fmt::format("--shot: found {}, expected one of {}{}", scene::in_quotes(name),
                               fmt::join(names, ", "),
                               scene::suggestion(scene::nearest(name, names))));
}

std::vector<int> of_shots(const std::vector<std::string>& names, const scene::Scene& scene) {
  const std::vector<scene::Take> takes = scene::takes_of(scene);
  std::vector<int> frames;
  for (const std::string& name : names) {
    const auto shot = std::ranges::find(scene.shots, name, &scene::Shot::name);
    if (shot == scene.shots.end()) refuse_shot(name, scene.shots);
    const scene::Take& take = takes[static_cast<std::size_t>(shot - scene.shots.begin())];
    for (int frame = take.first; frame <= take.last(); ++frame) frames.push_back(frame);
  }
  std::ranges::sort(frames);
  frames.erase(std::unique(frames.begin(), frames.end()), frames.end());
  return frames;
}

}  // namespace

std::vector<int> chosen_frames(const FrameChoice& choice, const scene::Scene& scene) {
  if (!choice.shots.empty()) return of_shots(choice.shots, scene);
  const int count = scene::frame_count(scene);
  return choice.numbers.empty() ? counted(count) : of_numbers(choice.numbers, count);
}

std::vector<int> counted(int count) {
  std::vector<int> numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 1);
  return numbers;
}

std::string ranges_text(const std::vector<int>& rising) {
  std::string text;
  for (std::size_t first = 0; first < rising.size();) {
    std::size_t last = first;
    while (last + 1 < rising.size() && rising[last + 1] == rising[last] + 1) ++last;
    text += fmt::format("{}{}", text.empty() ? "" : ",", rising[first]);
    if (last > first) text += fmt::format("-{}", rising[last]);
    first = last + 1;
  }
  return text;
}

}  // namespace wold::work
