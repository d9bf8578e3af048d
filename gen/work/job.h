#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "film/request.h"
#include "passes/pass.h"
#include "scene/rule.h"
#include "work/frame_choice.h"

namespace wold::work {

/// The renderers' programs that options such as --blender name, by name or path, by exporter. Of
/// one that is missing or empty it is the environment's, or the PATH's.
using ChosenPrograms = std::map<std::string, std::string, std::less<>>;

/// What of an output folder stays when all is done: everything; scene files and pictures without
/// the texels that scene files are made from; or pictures without scene files and texels.
enum class Keep { all, scenes, pictures };

/// "all", "scenes", "pictures", in the order of Keep.
inline constexpr std::array<std::string_view, 3> keep_words = {"all", "scenes", "pictures"};

inline std::string_view word_of(Keep keep) { return keep_words[static_cast<std::size_t>(keep)]; }

/// What `render`, `generate`, `plan` and `task` are asked for.
struct RenderOptions {
  std::filesystem::path scene;
  std::vector<std::string> overrides;  ///< key=value, applied after the scene file
  FrameChoice frames;
  std::filesystem::path out;  ///< empty: out/<scene name>
  std::string passes;         ///< "depth,normal"; empty: those that film.shutter needs
  ChosenPrograms programs;
  int threads = 0;                 ///< 0: the scene's render.threads
  std::uint64_t memory_bytes = 0;  ///< 0: the machine's
  Keep keep = Keep::all;  ///< of `render` and `generate`, and of the last step of a farm's job;
                          ///< `pictures` of those that make some
  bool dry_run = false;
  bool json = false;  ///< whether what is printed is JSON
  bool quiet = false;
};

/// What `render` and `generate` agree on before they work: what to make, and with what.
struct Job : film::Request {
  scene::Places places;       ///< where the scene file says what, for later checks that blame it
  ChosenPrograms programs;    ///< that options name
  int threads = 0;            ///< 0: all processors
  double memory_bytes = 0.0;  ///< that all may take together; 0: the machine's, and no limit is set
  Keep keep = Keep::all;
  bool has_pictures = true;    ///< whether pictures are what is wanted of scene files
  bool is_blur_alone = false;  ///< whether passes are for film.shutter alone: files of all do, too
  std::vector<Problem> text_warnings;  ///< of scene::read_located_scene()
};

/// Threads that the job may use: all processors' where it does not say.
int threads_of(const Job& job);

/// Memory that the job may use: the machine's where it does not say.
double memory_of(const Job& job);

/// Reads the scene and resolves the options against it. Throws InputError, also for frames that
/// the scene does not have, for files that it names and that are not there, and where pictures
/// alone are to stay of scene files that Wold makes no pictures of.
Job plan_job(const RenderOptions& options);

/// One line about the job, above what there is to do, and one about its shots if it has some.
std::string summary(const Job& job);

}  // namespace wold::work
