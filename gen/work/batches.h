#pragma once

#include <cstddef>
#include <vector>

#include "work/file_sizes.h"

/// Where scene files do not stay, they and their pictures are made for some frames, then for the
/// next ones. The files of a batch go when those of the next are there, which share some.
namespace wold::work {

/// `frames`, in their order, in batches of about the same size, whose scene files take a gigabyte
/// at most beside those that all share; four frames may take more. `own_bytes`: SceneBytes::own.
std::vector<std::vector<int>> batches_of(const std::vector<int>& frames, double own_bytes);

/// The most that scene files of so many frames take at the same time, in batches.
double bytes_in_batches(const SceneBytes& bytes, std::size_t frames);

}  // namespace wold::work
