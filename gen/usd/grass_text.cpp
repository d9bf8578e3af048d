#include "usd/grass_text.h"

#include <fmt/format.h>

#include <tuple>

#include "usd/blade_files.h"
#include "usd/frame_files.h"
#include "usd/material.h"
#include "usd/placement.h"
#include "usd/text.h"
#include "usd/volume_file.h"

namespace wold::usd {
namespace {

using landscape::Landscape;

/// Numbers things in their order, each once.
template <class Key>
int number_of(const Key& key, std::map<Key, int>& numbers) {
  return numbers.emplace(key, static_cast<int>(numbers.size())).first->second;
}

std::string blades_prototype(int number) { return fmt::format("blades_{:04}", number); }
std::string texel_prototype(int number) { return fmt::format("texel_{:04}", number); }

/// An instance, in two transforms one inside the other (placement.h).
std::string instance_text(std::size_t number, const std::string& prototype,
                          const glm::dmat4& world_from_cell) {
  const Placement placement = placement_of(world_from_cell);
  return fmt::format(
      "def Xform \"cell_{:06}\"\n"
      "{{\n"
      "    matrix4d xformOp:transform = {}\n"
      "    uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"
      "    def Xform \"grass\" (\n"
      "        instanceable = true\n"
      "        prepend references = </Landscape/Prototypes/{}>\n"
      "    )\n"
      "    {{\n"
      "        matrix4d xformOp:transform = {}\n"
      "        uniform token[] xformOpOrder = [\"xformOp:transform\"]\n"
      "    }}\n"
      "}}\n",
      number, matrix(placement.outer), prototype, matrix(placement.inner));
}

/// A cell of texels as a stage shows it: whole, since USD cuts no volume.
struct WholeCell {
  int volume = 0;
  glm::dmat4 world_from_cell{0.0};
  double share = 0.0;  ///< of the patch that its parts cover
};

/// The cells, of those that lie in parts the mean, by their area, of how the parts lie.
std::vector<WholeCell> whole_cells(const Landscape& landscape) {
  std::vector<WholeCell> cells;
  std::map<std::tuple<int, int, int>, std::size_t> in_parts;
  for (const landscape::Cell& cell : landscape.cells) {
    const std::tuple key(cell.origin.cell.x, cell.origin.cell.y, cell.volume);
    if (cell.part.is_whole() || !in_parts.contains(key)) {
      if (!cell.part.is_whole()) in_parts.emplace(key, cells.size());
      cells.push_back({cell.volume});
    }
    WholeCell& whole = cell.part.is_whole() ? cells.back() : cells[in_parts.at(key)];
    const glm::dvec2 size = cell.part.high - cell.part.low;
    whole.world_from_cell += size.x * size.y * (cell.world_from_cell * cell.reach);
    whole.share += size.x * size.y;
  }
  for (WholeCell& cell : cells) cell.world_from_cell /= cell.share;
  return cells;
}

}  // namespace

std::string volume_text(const std::string& inside, const std::filesystem::path& file,
                        const glm::dvec3& size_m) {
  const auto field = [&](const char* name) {
    return fmt::format(
        "    def OpenVDBAsset \"{0}\"\n"
        "    {{\n"
        "        token fieldName = \"{0}\"\n"
        "        asset filePath = {1}\n"
        "    }}\n",
        name, asset(file));
  };
  return fmt::format(
             "def Volume \"volume\"\n"
             "{{\n"
             "    float3[] extent = [(0, 0, 0), {0}]\n"
             "    rel field:density = <{1}/volume/density>\n"
             "    rel field:emission = <{1}/volume/emission>\n",
             vector(size_m), inside) +
         field("density") + field("emission") + "}\n";
}

Grass::Grass(const Landscape& landscape) : landscape_(landscape), light_(landscape) {
  for (std::size_t i = 0; i < landscape.blade_cells.size(); ++i) {
    const TintedBlades look = {landscape.blade_cells[i].mesh, light_.step_of(i)};
    blades_of_cells_.push_back(number_of(look, blades_));
  }
  for (const landscape::Cell& cell : landscape.cells) {
    const landscape::Volume& volume = landscape.volumes.at(static_cast<std::size_t>(cell.volume));
    volumes_.emplace(number_of(volume_name(volume), texels_), &volume);
  }
}

std::string Grass::prototypes_text() const {
  std::string text;
  for (const auto& [look, number] : blades_) {
    const std::string name = blades_prototype(number);
    const auto& mesh = landscape_.blade_meshes[static_cast<std::size_t>(look.mesh)];
    text += fmt::format(
        "def Xform \"{0}\" (\n"
        "    prepend references = {1}\n"
        ")\n"
        "{{\n"
        "    over \"mesh\" (\n"
        "        prepend apiSchemas = [\"MaterialBindingAPI\"]\n"
        "    )\n"
        "    {{\n"
        "        rel material:binding = </Landscape/Prototypes/{0}/material>\n"
        "    }}\n"
        "}}\n",
        name, asset(blades_folder / blades_layer(mesh.name)));
  }
  for (const auto& [number, volume] : volumes_) {
    const std::string name = texel_prototype(number);
    text += fmt::format("def Xform \"{}\"\n{{\n{}}}\n", name,
                        indented(volume_text("/Landscape/Prototypes/" + name,
                                             volumes_folder / (volume_name(*volume) + ".vdb"),
                                             volume->voxel_m * glm::dvec3(volume->voxels))));
  }
  return text;
}

std::string Grass::cells_text() const {
  std::string text;
  std::size_t number = 0;
  for (const landscape::BladeCell& cell : landscape_.blade_cells) {
    const int prototype = blades_of_cells_[number];
    text += instance_text(number++, blades_prototype(prototype), cell.world_from_cell);
  }
  for (const WholeCell& cell : whole_cells(landscape_)) {
    const auto& volume = landscape_.volumes[static_cast<std::size_t>(cell.volume)];
    text += instance_text(number++, texel_prototype(texels_.at(volume_name(volume))),
                          cell.world_from_cell);
  }
  return text;
}

std::string Grass::text() const {
  if (blades_.empty() && texels_.empty()) return {};
  return "class Scope \"Prototypes\"\n{\n" + indented(prototypes_text()) +
         "}\n\ndef Scope \"Grass\"\n{\n" + indented(cells_text()) + "}\n";
}

std::string Grass::materials_text(Light light) const {
  if (blades_.empty()) return {};
  std::string text;
  for (const auto& [look, number] : blades_) {
    const std::string name = blades_prototype(number);
    const auto& mesh = landscape_.blade_meshes[static_cast<std::size_t>(look.mesh)];
    Surface surface;
    if (light == Light::lit && has_reflectance(mesh))
      surface.reflectance =
          Texture{(blades_folder / blades_reflectance(mesh.name)).generic_string()};
    else
      surface.radiance = Texture{(blades_folder / blades_radiance(mesh.name)).generic_string(),
                                 landscape_.exposure_gain * light_.tint_of(look.step)};
    text += fmt::format(
        "over \"{}\"\n{{\n{}}}\n", name,
        indented(material_text("/Landscape/Prototypes/" + name + "/material", surface)));
  }
  return "over \"Prototypes\"\n{\n" + indented(text) + "}\n";
}

}  // namespace wold::usd
