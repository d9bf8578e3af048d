#include "povray/frame_index.h"

#include <fmt/format.h>

#include <string>

#include "core/files.h"
#include "povray/text.h"

namespace wold::povray {

void write_frame_index(std::span<const FrameMoment> film, const std::filesystem::path& folder) {
  std::string text = fmt::format(
      "// The film's frames, made or not: number, weathering degree, seconds since the first.\n"
      "#declare Wold_frames = array[{}][3] {{\n",
      film.size());
  for (const FrameMoment& moment : film)
    text += fmt::format("  {{ {}, {}, {} }},\n", moment.frame, number(moment.weathering),
                        number(moment.time_s));
  make_folder(folder / "data");
  update_file(folder / "data" / "frames.inc", include_file(text + "}\n"));
}

}  // namespace wold::povray
