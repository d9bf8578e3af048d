#pragma once

#include <string>
#include <vector>

#include "work/tasks.h"

namespace wold::work {

/// The names of the pictures and passes that stages have made, one a line: all pictures frame by
/// frame, then all passes.
std::string made_text(const Job& job, const std::vector<StageTasks>& stages);

/// The same as JSON: {"version": 1, "out": DIR, "frames": [...]}, of each frame its number, its
/// pictures by renderer, and the file of its passes or null. Names of files that are no text have
/// replacement characters.
std::string made_json(const Job& job, const std::vector<StageTasks>& stages);

}  // namespace wold::work
