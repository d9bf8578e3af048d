#include "usd/layer.h"

#include <fmt/format.h>

#include "usd/text.h"

namespace wold::usd {

std::string layer_header(const TimeRange& time, std::string_view doc, std::string_view facts) {
  constexpr int frames_per_second = 24;
  return fmt::format(
      "#usda 1.0\n"
      "(\n"
      "    customLayerData = {{\n"
      "        string axes = \"x east, y north, z up; right-handed; metres\"\n"
      "        string colours = \"linear sRGB; radiances and lights times the scene's exposure: "
      "shown as they are, encoded as sRGB, without a tone curve\"\n"
      "        string timeCodes = \"numbers of frames\"\n"
      "{4}"
      "    }}\n"
      "    defaultPrim = \"Landscape\"\n"
      "    doc = \"{0}\"\n"
      "    endTimeCode = {1}\n"
      "    framesPerSecond = {3}\n"
      "    metersPerUnit = 1\n"
      "    startTimeCode = {2}\n"
      "    timeCodesPerSecond = {3}\n"
      "    upAxis = \"Z\"\n"
      ")\n"
      "\n",
      doc, time.last, time.first, frames_per_second, indented(facts, 2));
}

std::string landscape_begin() {
  return "def Xform \"Landscape\" (\n"
         "    variants = {\n"
         "        string light = \"baked\"\n"
         "    }\n"
         "    prepend variantSets = \"light\"\n"
         ")\n"
         "{\n";
}

}  // namespace wold::usd
