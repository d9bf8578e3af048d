#include "usd/flakes_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "usd/frame_files.h"
#include "usd/material.h"
#include "usd/mesh_text.h"
#include "usd/text.h"

namespace wold::usd {
namespace {

using landscape::Flake;
using landscape::Landscape;

constexpr int opacity_steps = 8;

/// Number of the picture, and of the opacity's step from 1.
using Look = std::pair<int, int>;

std::map<Look, std::vector<const Flake*>> by_look(const Landscape& landscape) {
  std::map<Look, std::vector<const Flake*>> flakes;
  for (const Flake& flake : landscape.flakes.flakes) {
    const auto step = static_cast<int>(std::lround(opacity_steps * double{flake.opacity}));
    flakes[{flake.picture, std::clamp(step, 1, opacity_steps)}].push_back(&flake);
  }
  return flakes;
}

std::string name_of(const Look& look) {
  return fmt::format("flakes_{:03}_{}", look.first, look.second);
}

std::string mesh_text(const Look& look, const std::vector<const Flake*>& flakes) {
  std::vector<glm::vec3> corners_m;
  std::vector<glm::dvec2> st;
  for (const Flake* flake : flakes) {
    for (const glm::vec3& corner_m : corners_from(glm::dvec3(0.0), *flake))
      corners_m.push_back(corner_m);
    st.insert(st.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  }
  std::size_t next = 0;
  const auto index = [&](const glm::vec3&) { return fmt::format_int(next++).str(); };
  return fmt::format(
      "def Mesh \"{0}\" (\n"
      "    prepend apiSchemas = [\"MaterialBindingAPI\"]\n"
      ")\n"
      "{{\n"
      "    uniform bool doubleSided = 1\n"
      "    float3[] extent = {1}\n"
      "    int[] faceVertexCounts = {2}\n"
      "    int[] faceVertexIndices = {3}\n"
      "    rel material:binding = </Landscape/Materials/{0}>\n"
      "    point3f[] points = {4}\n"
      "    texCoord2f[] primvars:st = {5} (\n"
      "        interpolation = \"vertex\"\n"
      "    )\n"
      "    uniform token subdivisionScheme = \"none\"\n"
      "}}\n",
      name_of(look), extent_text(corners_m), quad_counts(flakes.size()), array(corners_m, index),
      array(corners_m, [](const glm::vec3& at_m) { return rounded(glm::dvec3(at_m), 5); }),
      array(st, [](const glm::dvec2& at) { return pair(at); }));
}

}  // namespace

std::string flakes_text(const Landscape& landscape) {
  if (landscape.flakes.flakes.empty()) return {};
  std::string text;
  for (const auto& [look, flakes] : by_look(landscape)) text += mesh_text(look, flakes);
  return "def Scope \"Flakes\"\n{\n" + indented(text) + "}\n";
}

std::string flake_materials_text(const Landscape& landscape) {
  std::string text;
  for (const auto& [look, flakes] : by_look(landscape)) {
    const auto& picture = landscape.flakes.pictures[static_cast<std::size_t>(look.first)];
    Surface surface;
    surface.even_radiance = landscape.exposure_gain * glm::dvec3(landscape.flakes.radiance);
    surface.opacity = Texture{(flakes_folder / (picture.name + ".png")).generic_string(),
                              glm::dvec3(double{1.0} * look.second / opacity_steps)};
    text += material_text("/Landscape/Materials/" + name_of(look), surface);
  }
  return text;
}

}  // namespace wold::usd
