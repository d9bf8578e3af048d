#pragma once

#include <functional>

#include "core/progress.h"
#include "render/job.h"

namespace wold::render {

/// Renders one picture with an external program and checks it.
///
/// The program runs in its own process group; its output goes to job.log, its progress (in
/// percent) to `progress`. The picture appears under job.picture only when the program succeeded
/// in time and the picture has the right size, is not blank and shows what job.expected says
/// (missing_things.h). An older picture is removed first. A PNG has 8 bits per channel and no
/// notes: same pixels, same bytes. `interrupted` is asked several times a second.
///
/// Returns the most memory, in bytes, that the program was seen to have of its own; see
/// memory_of_process_bytes().
///
/// Throws RendererError (the program cannot be started, failed, killed, out of time, no valid
/// picture; it names the frame, the reason and the log with its last lines), FileError (a folder
/// cannot be written or is full) and InterruptedError. The program and its children have ended in
/// every case.
double run(const Job& job, Progress& progress, const std::function<bool()>& interrupted);

}  // namespace wold::render
