#include "usd/film_stage.h"

#include <fmt/format.h>

#include "core/files.h"
#include "usd/layer.h"
#include "usd/text.h"

namespace wold::usd {
namespace {

using exporter::FrameMoment;

/// Seen at its own time alone: what holds at a time code holds until the next one.
std::string frame_text(const FrameMoment& moment) {
  const int frame = moment.frame;
  return fmt::format(
      "def Xform \"frame_{0:04}\" (\n"
      "    customData = {{\n"
      "        double timeSeconds = {1}\n"
      "        double weatheringDegree = {2}\n"
      "    }}\n"
      "    prepend payload = {3}\n"
      ")\n"
      "{{\n"
      "    token visibility.timeSamples = {{\n"
      "        {4}: \"invisible\",\n"
      "        {0}: \"inherited\",\n"
      "        {5}: \"invisible\",\n"
      "    }}\n"
      "}}\n",
      frame, number(moment.time_s), number(moment.weathering), asset(frame_layer(frame)), frame - 1,
      frame + 1);
}

/// Its values are those of the frames' cameras: clip i is of frame i + 1.
std::string camera_text(std::span<const FrameMoment> film) {
  const auto layer = [](const FrameMoment& moment) { return asset(frame_layer(moment.frame)); };
  const auto begin = [](const FrameMoment& moment) {
    return pair({moment.frame, moment.frame - 1});
  };
  const auto time = [](const FrameMoment& moment) { return pair(glm::dvec2(moment.frame)); };
  return fmt::format(
      "def Camera \"camera\" (\n"
      "    clips = {{\n"
      "        dictionary default = {{\n"
      "            double2[] active = {}\n"
      "            asset[] assetPaths = {}\n"
      "            asset manifestAssetPath = @./camera.usda@\n"
      "            string primPath = \"/Landscape/camera\"\n"
      "            double2[] times = {}\n"
      "        }}\n"
      "    }}\n"
      ")\n"
      "{{\n"
      "    matrix4d xformOp:transform\n"
      "    uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"
      "}}\n",
      array(film, begin), array(film, layer), array(film, time));
}

/// Which of the camera's values the clips have.
constexpr const char* manifest =
    "#usda 1.0\n"
    "(\n"
    "    defaultPrim = \"Landscape\"\n"
    "    metersPerUnit = 1\n"
    "    upAxis = \"Z\"\n"
    ")\n"
    "\n"
    "def Xform \"Landscape\"\n"
    "{\n"
    "    def Camera \"camera\"\n"
    "    {\n"
    "        float2 clippingRange\n"
    "        float focalLength\n"
    "        float horizontalAperture\n"
    "        float verticalAperture\n"
    "        matrix4d xformOp:transform\n"
    "    }\n"
    "}\n";

/// One choice of light for all frames.
std::string light_variant(const char* light, std::span<const FrameMoment> film) {
  std::string text = fmt::format("    \"{}\" {{\n", light);
  for (const FrameMoment& moment : film)
    text += fmt::format(
        "        over \"frame_{:04}\" (variants = {{ string light = \"{}\" }})\n"
        "        {{\n"
        "        }}\n",
        moment.frame, light);
  return text + "    }\n";
}

}  // namespace

void write_film_stage(std::span<const FrameMoment> film, const std::filesystem::path& folder) {
  make_folder(folder);
  std::string text = layer_header({1, static_cast<int>(film.size())},
                                  "A film by Wold: every frame is seen at its own time code. "
                                  "Hosts without animated visibility open frame.0001.usda.");
  text += landscape_begin();
  text += indented(camera_text(film));
  for (const FrameMoment& moment : film) text += indented(frame_text(moment));
  text += "\n    variantSet \"light\" = {\n" + indented(light_variant("baked", film)) +
          indented(light_variant("lit", film)) + "    }\n}\n";
  update_file(folder / "camera.usda", manifest);
  update_file(folder / "scene.usda", text);
}

}  // namespace wold::usd
