#include "work/batches.h"

#include <algorithm>

namespace wold::work {
namespace {

constexpr double batch_bytes = 1e9;
/// What several renderers at once show, and what is worth making the ground again for.
constexpr std::size_t few_frames = 4;

std::size_t max_frames(double own_bytes) {
  return std::max(few_frames, static_cast<std::size_t>(batch_bytes / std::max(1.0, own_bytes)));
}

}  // namespace

std::vector<std::vector<int>> batches_of(const std::vector<int>& frames, double own_bytes) {
  const std::size_t max = max_frames(own_bytes);
  const std::size_t count = (frames.size() + max - 1) / max;
  const auto begin_of = [&](std::size_t batch) {
    return frames.begin() + static_cast<std::ptrdiff_t>(frames.size() * batch / count);
  };
  std::vector<std::vector<int>> batches;
  for (std::size_t batch = 0; batch < count; ++batch)
    batches.emplace_back(begin_of(batch), begin_of(batch + 1));
  return batches;
}

double bytes_in_batches(const SceneBytes& bytes, std::size_t frames) {
  return bytes.of(std::min(frames, 2 * max_frames(bytes.own)));
}

}  // namespace wold::work
