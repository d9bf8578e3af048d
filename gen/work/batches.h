#pragma once

#include <cstddef>
#include <vector>

#include "work/job.h"

/// Where scene files do not stay, they and their pictures are made for some frames, then for the
/// next ones. The files of a batch go when those of the next are there, which share some.
namespace wold::work {

/// `frames` in batches whose scene files take about a gigabyte, and never less than four frames.
/// `bytes_each`: of the scene files of one frame.
std::vector<std::vector<int>> batches_of(const std::vector<int>& frames, double bytes_each);

/// How many of so many frames have scene files at the same time.
std::size_t frames_at_once(const Job& job, std::size_t frames, double bytes_each);

}  // namespace wold::work
