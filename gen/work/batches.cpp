#include "work/batches.h"

#include <algorithm>

namespace wold::work {
namespace {

constexpr double batch_bytes = 1e9;
/// What several renderers at once show, and what is worth making the ground again for.
constexpr std::size_t min_frames = 4;

std::size_t frames_of_batch(double bytes_each) {
  return std::max(min_frames, static_cast<std::size_t>(batch_bytes / std::max(1.0, bytes_each)));
}

}  // namespace

std::vector<std::vector<int>> batches_of(const std::vector<int>& frames, double bytes_each) {
  const std::size_t size = frames_of_batch(bytes_each);
  std::vector<std::vector<int>> batches;
  for (std::size_t first = 0; first < frames.size(); first += size) {
    const std::size_t count = std::min(size, frames.size() - first);
    const auto begin = frames.begin() + static_cast<std::ptrdiff_t>(first);
    batches.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(count));
  }
  return batches;
}

std::size_t frames_at_once(const Job& job, std::size_t frames, double bytes_each) {
  return job.keep == Keep::pictures ? std::min(frames, 2 * frames_of_batch(bytes_each)) : frames;
}

}  // namespace wold::work
