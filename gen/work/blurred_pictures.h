#pragma once

#include <filesystem>
#include <vector>

#include "core/progress.h"
#include "film/scratch_folder.h"
#include "work/frame_pictures.h"

namespace wold::work {

/// The pictures of a film as an open shutter takes them, in a folder of their own under an output
/// folder, which goes with this object.
class BlurredPictures {
 public:
  /// Blurs `frames` of the pictures by their passes "motion" and "depth" in out/passes. `shutter`:
  /// how much of the time from a frame to the next it is open, more than 0. Throws FileError where
  /// passes are missing, have another size than their picture, or cannot be read, and
  /// InterruptedError.
  BlurredPictures(const std::filesystem::path& out, const FramePictures& pictures,
                  const std::vector<int>& frames, double shutter, Progress& progress);

  /// Has 0001.png and so on, with the frames' own numbers.
  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  film::ScratchFolder folder_;
};

}  // namespace wold::work
