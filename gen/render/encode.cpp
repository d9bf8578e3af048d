#include "render/encode.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/files.h"
#include "core/number_text.h"
#include "render/log.h"
#include "render/process.h"
#include "render/program.h"

namespace wold::render {
namespace fs = std::filesystem;
namespace {

using Arguments = std::vector<std::string>;

constexpr ExternalProgram ffmpeg = {"FFmpeg", "ffmpeg", "WOLD_FFMPEG", ""};
constexpr int widest_webp_px = 640;

/// Fills up odd sizes, which yuv420p does not have, by the last column and row.
std::string even_sized(glm::ivec2 size_px) {
  const glm::ivec2 more = size_px % 2;
  if (more == glm::ivec2(0)) return "null";
  return fmt::format("pad={}:{},fillborders=right={}:bottom={}:mode=smear", size_px.x + more.x,
                     size_px.y + more.y, more.x, more.y);
}

Arguments mp4_arguments(const Encoding& encoding) {
  const std::string filter =
      even_sized(encoding.size_px) +
      ",scale=out_color_matrix=bt709:out_range=tv:flags=lanczos+accurate_rnd+full_chroma_int,"
      "format=yuv420p";
  return {"-vf", filter, "-c:v", "libx264", "-preset", "medium", "-crf", "20", "-colorspace",
          "bt709", "-color_primaries", "bt709", "-color_trc", "iec61966-2-1", "-color_range", "tv",
          // Another number of threads gives other bytes.
          "-threads", "4", "-movflags", "+faststart", "-f", "mp4"};
}

Arguments webp_arguments(const Encoding& encoding) {
  const double scale = std::min(1.0, double{widest_webp_px} / encoding.size_px.x);
  const glm::ivec2 size_px =
      glm::max(glm::ivec2(glm::round(scale * glm::dvec2(encoding.size_px))), 1);
  const std::string filter =
      fmt::format("scale={}:{}:flags=lanczos+accurate_rnd", size_px.x, size_px.y);
  return {"-vf", filter, "-c:v", "libwebp_anim", "-quality", "75", "-loop", "0", "-f", "webp"};
}

Arguments command_line(const Encoding& encoding, const fs::path& output) {
  Arguments arguments = {find_ffmpeg().path.string(), "-hide_banner", "-nostdin", "-y", "-loglevel",
                         "warning", "-nostats", "-progress", "pipe:1",
                         // A damaged picture is an error, not a gap.
                         "-xerror", "-err_detect", "explode", "-framerate",
                         fmt::format("{:.9g}", encoding.frames_per_second), "-start_number",
                         std::to_string(encoding.first), "-i", "%04d.png"};
  const std::string count = std::to_string(encoding.count);
  // FFmpeg counts what it writes to the first output: pictures there, while newer ones count an
  // animated WebP as one.
  for (const char* argument : {"-map", "0:v", "-frames:v", count.c_str(), "-f", "null", "-"})
    arguments.emplace_back(argument);
  for (const char* argument : {"-map", "0:v", "-frames:v", count.c_str()})
    arguments.emplace_back(argument);
  const bool is_webp = encoding.film.extension() == ".webp";
  for (std::string& argument : is_webp ? webp_arguments(encoding) : mp4_arguments(encoding))
    arguments.push_back(std::move(argument));
  // No names, versions or times in the file.
  for (const char* argument :
       {"-map_metadata", "-1", "-fflags", "+bitexact", "-flags:v", "+bitexact"})
    arguments.emplace_back(argument);
  arguments.push_back(fmt::format("file:{}", output.string()));
  return arguments;
}

/// Reads what FFmpeg says: blocks of key=value about its progress, and everything else.
class Listener {
 public:
  Listener(Progress& progress, Log& log) : progress_(progress), log_(log) {}
  void hear(std::string_view bytes, bool at_end = false) {
    lines_.add(bytes);
    for (std::string line; lines_.next(line, at_end);)
      if (!is_progress(line)) log_.add(line);
  }
  int frames() const { return frames_; }

 private:
  bool is_progress(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (equals == 0 || equals == std::string_view::npos) return false;
    const std::string_view key = line.substr(0, equals);
    if (key.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string_view::npos)
      return false;
    if (key == "frame") reach(line.substr(equals + 1));
    return true;
  }
  void reach(std::string_view number) {
    number.remove_prefix(std::min(number.find_first_not_of(' '), number.size()));
    const auto frames = leading_number<int>(number);
    if (!frames || frames->value <= frames_) return;
    progress_.advance(static_cast<std::size_t>(frames->value - frames_), {});
    frames_ = frames->value;
  }

  Progress& progress_;
  Log& log_;
  LineSplitter lines_;
  int frames_ = 0;
};

RendererError failure(const Encoding& encoding, const Log& log, std::string_view reason) {
  return RendererError(fmt::format("FFmpeg failed on {}: {}; its log is {}{}",
                                   encoding.film.string(), reason, log.path().string(),
                                   log.last_lines()));
}

void encode_to(const fs::path& output, const Encoding& encoding, Progress& progress,
               const std::function<bool()>& interrupted) {
  Log log(encoding.log);
  const Arguments command = command_line(encoding, output);
  log.add(fmt::format("{}", fmt::join(command, " ")));
  Listener listener(progress, log);
  const auto hear = [&](std::string_view bytes) { listener.hear(bytes); };
  const auto end =
      run_to_end(command, fs::absolute(encoding.pictures), {encoding.timeout}, hear, interrupted);
  if (!end)
    throw failure(encoding, log, fmt::format("no film after {} s", encoding.timeout.count()));
  listener.hear({}, /*at_end=*/true);
  if (end->code != 0 || end->signal != 0) throw failure(encoding, log, to_string(*end));
  if (listener.frames() != encoding.count)
    throw failure(
        encoding, log,
        fmt::format("found {} frames in the film, expected {}", listener.frames(), encoding.count));
}

}  // namespace

FoundProgram find_ffmpeg() { return find_program(ffmpeg); }

void encode(const Encoding& encoding, Progress& progress,
            const std::function<bool()>& interrupted) {
  const fs::path film = fs::absolute(encoding.film);
  if (film.has_parent_path()) make_folder(film.parent_path());
  progress.begin(encoding.film.filename().string(), static_cast<std::size_t>(encoding.count));
  write_file_by_path(
      film, [&](const fs::path& output) { encode_to(output, encoding, progress, interrupted); });
  progress.end();
}

}  // namespace wold::render
