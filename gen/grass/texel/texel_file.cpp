#include "grass/texel/texel_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/vdb_file.h"

namespace wold::grass {
namespace fs = std::filesystem;
namespace {

constexpr int border = 1;

openvdb::math::Transform::Ptr texel_transform(const TexelShape& shape) {
  auto transform = openvdb::math::Transform::createLinearTransform(shape.voxel_m);
  transform->postTranslate(openvdb::Vec3d((0.5 - border) * shape.voxel_m));
  return transform;
}

float stored(float value) { return value; }
openvdb::Vec3s stored(const glm::vec3& value) { return {value.x, value.y, value.z}; }
void restore(float from, float& to) { to = from; }
void restore(const openvdb::Vec3s& from, glm::vec3& to) { to = {from.x(), from.y(), from.z()}; }

openvdb::Coord coord_of(const TexelShape& shape, std::uint32_t voxel) {
  const glm::ivec3 at = shape.coordinates(voxel) + border;
  return {at.x, at.y, at.z};
}

/// What the grids of a file have in common: their leaves, and for every voxel in the order of the
/// leaves its place in the lists.
struct Topology {
  using Places = openvdb::Int32Tree::LeafNodeType;
  struct Leaf {
    openvdb::Coord origin;
    Places::NodeMaskType active;
  };
  std::vector<Leaf> leaves;
  std::vector<std::uint32_t> places;
};

/// One layer of leaves after the other: voxels arrive slice by slice, so no more than a layer is
/// open at a time.
Topology topology(const TexelShape& shape, const std::vector<std::uint32_t>& voxel) {
  constexpr int leaf_side = Topology::Places::DIM;
  const int leaves_across = (shape.side + border) / leaf_side + 1;
  std::vector<std::array<std::uint32_t, Topology::Places::SIZE>> places(
      static_cast<std::size_t>(leaves_across * leaves_across));
  std::vector<Topology::Leaf> layer(places.size());
  Topology result;
  result.places.reserve(voxel.size());
  const auto close_layer = [&] {
    for (std::size_t leaf = 0; leaf < layer.size(); ++leaf) {
      if (layer[leaf].active.isOff()) continue;
      for (auto on = layer[leaf].active.beginOn(); on; ++on)
        result.places.push_back(places[leaf][on.pos()]);
      result.leaves.push_back(layer[leaf]);
      layer[leaf].active.setOff();
    }
  };
  int open = 0;
  for (std::uint32_t i = 0; i < voxel.size(); ++i) {
    const openvdb::Coord at = coord_of(shape, voxel[i]);
    if (at.z() / leaf_side != open) close_layer();
    open = at.z() / leaf_side;
    const auto leaf =
        static_cast<std::size_t>(at.y() / leaf_side) * leaves_across + at.x() / leaf_side;
    const openvdb::Index within = Topology::Places::coordToOffset(at);
    layer[leaf].origin = at & ~(leaf_side - 1);
    layer[leaf].active.setOn(within);
    places[leaf][within] = i;
  }
  close_layer();
  return result;
}

template <class Grid, class Value>
openvdb::GridBase::Ptr make_grid(const std::string& name, const TexelShape& shape,
                                 const Topology& topology, const std::vector<Value>& values) {
  using Tree = typename Grid::TreeType;
  auto tree = std::make_shared<Tree>();
  auto place = topology.places.begin();
  for (const Topology::Leaf& shared : topology.leaves) {
    auto leaf = std::make_unique<typename Tree::LeafNodeType>(shared.origin);
    leaf->setValueMask(shared.active);
    auto* buffer = leaf->buffer().data();
    for (auto on = shared.active.beginOn(); on; ++on) buffer[on.pos()] = stored(values[*place++]);
    tree->addLeaf(leaf.release());
  }
  auto grid = Grid::create(tree);
  grid->setName(name);
  grid->setTransform(texel_transform(shape));
  grid->setSaveFloatAsHalf(true);
  return grid;
}

openvdb::GridBase::Ptr density_grid(const TexelShape& shape, const Topology& topology,
                                    const std::vector<float>& density) {
  auto grid = make_grid<openvdb::FloatGrid>("density", shape, topology, density);
  grid->setGridClass(openvdb::GRID_FOG_VOLUME);
  return grid;
}

openvdb::MetaMap file_metadata(const TexelShape& shape, const std::string& content) {
  openvdb::MetaMap metadata;
  metadata.insertMeta("content", openvdb::StringMetadata(content));
  metadata.insertMeta("side", openvdb::Int32Metadata(shape.side));
  metadata.insertMeta("height", openvdb::Int32Metadata(shape.height));
  metadata.insertMeta("voxel_m", openvdb::DoubleMetadata(shape.voxel_m));
  return metadata;
}

template <class Grid, class Value>
void read_values(const openvdb::GridPtrVec& grids, const std::string& name, const Texel& texel,
                 std::vector<Value>& values, const fs::path& path) {
  const auto grid = openvdb::gridPtrCast<Grid>(openvdb::findGridByName(grids, name));
  if (!grid) throw FileError(fmt::format("{} has no grid \"{}\" of a texel", path.string(), name));
  auto accessor = grid->getConstAccessor();
  values.resize(texel.size());
  for (std::size_t i = 0; i < texel.size(); ++i)
    restore(accessor.getValue(coord_of(texel.shape, texel.voxel[i])), values[i]);
}

/// Positions of the active voxels, ascending.
std::vector<std::uint32_t> active_voxels(const openvdb::FloatGrid& grid, const TexelShape& shape) {
  std::vector<std::uint32_t> voxels;
  for (auto it = grid.cbeginValueOn(); it; ++it) {
    const openvdb::Coord at = it.getCoord();
    voxels.push_back(shape.linear(at.x() - border, at.y() - border, at.z() - border));
  }
  std::sort(voxels.begin(), voxels.end());
  return voxels;
}

}  // namespace

void write_texel(const fs::path& path, const Texel& texel, const std::string& content) {
  using openvdb::FloatGrid;
  using openvdb::Vec3SGrid;
  const TexelShape& shape = texel.shape;
  const Topology shared = topology(shape, texel.voxel);
  write_vdb(path,
            {density_grid(shape, shared, texel.density),
             make_grid<Vec3SGrid>("tangent", shape, shared, texel.tangent),
             make_grid<Vec3SGrid>("normal", shape, shared, texel.normal),
             make_grid<Vec3SGrid>("albedo", shape, shared, texel.albedo),
             make_grid<Vec3SGrid>("transmittance", shape, shared, texel.transmittance),
             make_grid<FloatGrid>("specular", shape, shared, texel.specular)},
            file_metadata(shape, content));
}

Texel read_texel(const fs::path& path) {
  Texel texel;
  texel.shape = file_shape(path);
  const openvdb::GridPtrVecPtr grids = read_vdb(path);
  const auto density =
      openvdb::gridPtrCast<openvdb::FloatGrid>(openvdb::findGridByName(*grids, "density"));
  if (!density) throw FileError(fmt::format("{} has no grid \"density\"", path.string()));
  texel.voxel = active_voxels(*density, texel.shape);
  read_values<openvdb::FloatGrid>(*grids, "density", texel, texel.density, path);
  read_values<openvdb::Vec3SGrid>(*grids, "tangent", texel, texel.tangent, path);
  read_values<openvdb::Vec3SGrid>(*grids, "normal", texel, texel.normal, path);
  read_values<openvdb::Vec3SGrid>(*grids, "albedo", texel, texel.albedo, path);
  read_values<openvdb::Vec3SGrid>(*grids, "transmittance", texel, texel.transmittance, path);
  read_values<openvdb::FloatGrid>(*grids, "specular", texel, texel.specular, path);
  return texel;
}

void write_volume(const fs::path& path, const VolumeData& volume, const std::set<int>& turns,
                  const std::string& content) {
  const Topology shared = topology(volume.shape, volume.voxel);
  openvdb::GridPtrVec grids = {density_grid(volume.shape, shared, volume.density)};
  for (std::size_t i = 0; i < volume.turns.size(); ++i) {
    if (!turns.contains(volume.turns[i])) continue;
    grids.push_back(make_grid<openvdb::Vec3SGrid>(fmt::format("emission_q{}", volume.turns[i]),
                                                  volume.shape, shared, volume.emission[i]));
  }
  write_vdb(path, grids, file_metadata(volume.shape, content));
}

std::string file_content(const fs::path& path) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return {};
  try {
    return read_vdb_metadata(path)->metaValue<std::string>("content");
  } catch (const std::exception&) {
    return {};
  }
}

TexelShape file_shape(const fs::path& path) {
  const openvdb::MetaMap::Ptr metadata = read_vdb_metadata(path);
  try {
    return {metadata->metaValue<std::int32_t>("side"), metadata->metaValue<std::int32_t>("height"),
            metadata->metaValue<double>("voxel_m")};
  } catch (const openvdb::Exception& error) {
    throw FileError(fmt::format("{} is no texel: {}", path.string(), error.what()));
  }
}

}  // namespace wold::grass
