#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace wold::work {

/// The pictures of one renderer in an output folder: DIR/frames/<renderer>/0001.png and so on.
struct FramePictures {
  std::string renderer;          ///< its exporter's name, as its folder is called
  std::filesystem::path folder;  ///< where they are
  std::map<int, std::filesystem::path> by_frame;
};

/// What there is, in the order of the table of exporters; renderers without pictures are left out.
/// Throws FileError when `out` is no folder.
std::vector<FramePictures> frame_pictures(const std::filesystem::path& out);

/// "Blender" or "POV-Ray", for people.
std::string display_name(const FramePictures& pictures);

/// DIR/passes/0001.exr, whether it is there or not.
std::filesystem::path passes_path(const std::filesystem::path& out, int frame);

/// Those of `frames` that there is no picture of.
std::vector<int> missing_frames(const FramePictures& pictures, const std::vector<int>& frames);

/// The frames that an output folder should have in the end: the scene's, from DIR/scene.toml; where
/// that is missing or cannot be read, all from 1 to the last of which there is a picture.
std::vector<int> expected_frames(const std::filesystem::path& out,
                                 const std::vector<FramePictures>& pictures);

/// Those of the shots of that scene. Throws InputError where it cannot be read or does not have
/// them.
std::vector<int> frames_of_shots(const std::filesystem::path& out,
                                 const std::vector<std::string>& shots);

/// What an output folder's scene, DIR/scene.toml, says of the film's time; the defaults where it
/// cannot be read.
scene::FilmTiming film_timing(const std::filesystem::path& out);

}  // namespace wold::work
