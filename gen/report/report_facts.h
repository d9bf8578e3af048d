#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "work/frame_pictures.h"

namespace wold::report {

/// What the tasks of a stage took that have been done.
struct StageTime {
  std::string stage;
  int done = 0;
  int tasks = 0;
  double seconds = 0.0;  ///< of all that are done together
};

/// What an output folder says of itself.
struct ReportFacts {
  std::string name;                                      ///< the scene's, or else the folder's
  std::optional<scene::Scene> scene;                     ///< DIR/scene.toml's, when it can be read
  std::vector<int> frames;                               ///< that there should be, from 1
  std::vector<work::FramePictures> pictures;             ///< that there are
  std::map<int, std::filesystem::path> passes;           ///< files of ground truth, by frame
  std::vector<StageTime> stages;                         ///< in the order they are done
  std::map<std::string, std::map<int, double>> seconds;  ///< by renderer and frame
  /// What will look wrong, what is missing, what the renderers warned of.
  std::vector<std::string> warnings;
};

/// Looks at the folder; changes nothing. Throws FileError when it is none, or has neither a scene
/// nor pictures, and InputError when it is of another format (work/folder_format.h).
ReportFacts report_facts(const std::filesystem::path& out);

}  // namespace wold::report
