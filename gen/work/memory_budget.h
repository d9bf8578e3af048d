#pragma once

#include "work/work.h"

/// Keeping to --memory: what cannot be done with it is refused, what is done gets limits.
namespace wold::work {

/// Throws InputError that names, for each stage, what it would need; nothing without --memory.
void require_memory(const Job& job, const std::vector<StageTasks>& stages);

/// How many of a stage's tasks fit into the job's memory at the same time; at least 1.
std::size_t tasks_within_memory(const Job& job, const StageTasks& stage, Work& work);

/// What is left for renderers, beside what this process keeps to from here on while it waits for
/// them with pictures of the job's size.
double memory_for_renderers(const Job& job, std::size_t pictures_at_once);

}  // namespace wold::work
