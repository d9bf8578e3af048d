#pragma once

#include <filesystem>

#include "work/file_states.h"
#include "work/task_record.h"

namespace wold::work {

/// Writes `out`/manifest.json: every file of an output directory as it is, with its bytes, content
/// hash, stage (the folder it is in) and, for pictures, what they were made from and the seconds it
/// took. Throws FileError.
void write_manifest(const std::filesystem::path& out, const TaskRecords& records,
                    FileStates& states);

}  // namespace wold::work
