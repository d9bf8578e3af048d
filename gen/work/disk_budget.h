#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "work/estimate.h"
#include "work/work.h"

/// Whether the disk has room for what is to be made.
namespace wold::work {

/// What of so many tasks' files is there at the same time: those of all, but where scene files do
/// not stay. `each`: the estimate of one. Throws what FilmDemand does.
double bytes_at_once(const Job& job, const Stage& stage, std::size_t tasks, const Estimate& each,
                     Work& work);

/// The most that files which are not there take at the same time: those of the stages' tasks that
/// were never done, and those that were removed and are needed again.
double missing_bytes(const Job& job, const std::vector<StageTasks>& stages, Work& work);

/// What this process may still write where a folder is or would be made; nothing when the system
/// does not say.
std::optional<double> free_bytes(const std::filesystem::path& folder);

/// Throws FileError when the disk of the output folder is sure to be full before all is done:
/// estimates are right within 30 %, so two thirds of missing_bytes() have to be free.
void require_disk(const Job& job, const std::vector<StageTasks>& stages);

}  // namespace wold::work
