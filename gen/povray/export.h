#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "landscape/landscape.h"
#include "povray/frame_index.h"

namespace wold::povray {

/// Writes everything POV-Ray needs for one frame below `folder`:
///
///     povray.ini                    see export_settings()
///     data/frame_0001.ini           the same with frame, input and output
///     data/frame_0001/frame.inc     camera, exposure, scales of the maps
///     data/frame_0001/volumes.inc   the volumes and meshes this frame uses
///     data/frame_0001/cells.txt     where each cell, or part of one, stands: numbers alone
///     data/frame_0001/clouds.inc    one macro call per cloud that is a volume
///     data/frame_0001/expected.json what the picture should show (core/expected_picture.h)
///     data/frame_0001/flakes.inc    the flakes as one mesh; none, no file
///     data/frame_0001/*.df3, *.exr  light on the grass, clouds; ground and its details,
///                                   sky, backdrop
///     data/terrain_<hash>.inc       the ground's triangles, shared by frames with the same ground
///     data/blades/<name>*           meshes, shared by all frames
///     data/flakes/<name>.png        pictures of flakes, shared by all frames
///     data/volumes/<name>*          shared by all frames
///
/// Only volumes that a cell uses are written, and only when they are not there already. Equal
/// landscapes give equal bytes, so that frames may be written by several processes at a time.
/// Returns the files that the frame is made of. `df3_bits` is the depth of density files, 8 or 16.
/// Throws FileError.
std::vector<std::filesystem::path> export_frame(const landscape::Landscape& scene,
                                                const std::filesystem::path& folder,
                                                int df3_bits = 8);

/// Writes `folder`/povray.ini, which POV-Ray reads where it is started: size and quality of a bare
/// `povray scene.pov`. Throws FileError.
void export_settings(glm::ivec2 size_px, int samples, const std::filesystem::path& folder);

/// Copies the scene program (templates/povray/*.pov, *.inc) to `folder` and writes which frames the
/// film has: data/frames.inc (frame_index.h). Throws FileError.
void export_scene(std::span<const FrameMoment> film, const std::filesystem::path& folder);

}  // namespace wold::povray
