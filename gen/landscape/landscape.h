#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/ground_map.h"
#include "core/image.h"
#include "core/tubes.h"

/// One frame's complete state, independent of any renderer; the only thing the exporters read.
/// World space: metres, z up, x east, y north, right-handed. Colours and radiances are linear sRGB
/// relative to the scene's sun; the renderer multiplies by `exposure_gain` and encodes sRGB.
namespace wold::landscape {

/// One baked texel: emission and extinction of a patch of grass under the scene's sun, on disk.
///
/// The .vdb holds `density` (FloatGrid, extinction in 1/m) and `emission_grid` (Vec3SGrid, source
/// radiance; a ray's radiance gains density * emission * ds). Index (1, 1, 1) is the first voxel;
/// its centre lies at half a voxel in cell space. x and y wrap.
struct Volume {
  std::string name;           ///< unique, safe as a file name: "v1_k03_q2_126"
  std::filesystem::path vdb;  ///< many volumes share a file
  std::string emission_grid;  ///< "emission_q0" ... one per quarter-turn of the sun
  std::string content;        ///< hash: same content, same bytes
  glm::ivec3 voxels{0};       ///< active box (N, N, height)
  double voxel_m = 0.0;       ///< side; N * voxel_m is the patch
  /// The same patch without light, the .vdb of the finest volume: `density` (1/m) and `albedo`
  /// (Vec3SGrid, of single scattering), placed as `density` of `vdb` is.
  std::filesystem::path texel = {};
};

/// A rectangle of a patch, in fractions of its side along the cell's x and y.
struct Part {
  glm::dvec2 low{0.0};
  glm::dvec2 high{1.0};

  bool is_whole() const { return low == glm::dvec2(0.0) && high == glm::dvec2(1.0); }
  auto operator<=>(const Part& other) const {
    return std::tie(low.x, low.y, high.x, high.y) <=>
           std::tie(other.low.x, other.low.y, other.high.x, other.high.y);
  }
  bool operator==(const Part& other) const { return low == other.low && high == other.high; }
};

/// What to append to a patch's name, safe in a file name: nothing to that of a whole one.
std::string suffix_of(const Part& part);

/// Which cell of the terrain an instance stands on, and which patch that is.
struct CellOrigin {
  glm::ivec2 cell{0};  ///< column (east) and row (north), from 0
  int patch = 0;       ///< its number among all that there may be
};

/// An instance of a volume, or of a part of it. Cell space: metres, [0, patch] x [0, patch] x
/// [0, height]; world_from_cell turns it by quarter-turns about the patch's centre, shears it to a
/// parallelogram with two sides to the north (see Footprint), leans it over with the wind, shears z
/// to the terrain and moves it. Shrubs have sizes of their own and may stand over other cells;
/// densities are per metre of the world, whatever the size. The parts of one cell differ in how
/// they lie on the ground, not in what they show of it. Where neighbours lean away from each other
/// there is a gap between them: renderers show the volume, which repeats itself, upright over its
/// footprint, or, if they cannot, stretched in cell space by `reach`.
struct Cell {
  glm::dmat4 world_from_cell;
  int volume = 0;  ///< index into Landscape::volumes
  glm::dmat4 reach{1.0};
  Part part{};  ///< all of the volume that is shown; its borders are voxels' borders
  CellOrigin origin{};
};

/// The blades of a patch, or the points it is made of, as a mesh that glows by itself, in cell
/// space; blades may lean out of the patch.
struct BladeMesh {
  std::string name;  ///< unique, safe as a file name, different for different blades
  std::shared_ptr<const Tubes> tubes;
};

/// An instance of a mesh, placed like a Cell; parts of a cell have meshes of their own.
struct BladeCell {
  glm::dmat4 world_from_cell;
  int mesh = 0;  ///< index into Landscape::blade_meshes
  Part part{};   ///< of the patch, on which the mesh's blades stand
  CellOrigin origin{};
};

struct Camera {
  glm::dvec3 eye_m;
  glm::dvec3 target_m;
  double field_of_view_deg = 0.0;  ///< horizontal; up is +z
};

/// A picture of radiance on a rectangle far behind everything: what the camera sees of a sky that
/// needs more pixels than Landscape::sky has. World space, metres.
struct Backdrop {
  Image picture;        ///< 3 channels, the upper row first
  glm::dvec3 corner_m;  ///< lower left
  glm::dvec3 right_m;   ///< from it to the lower right
  glm::dvec3 up_m;      ///< and to the upper left
};

/// A cloud, or snow that blows over the ground, as a volume that stands in world space, as voxels
/// in memory: x fastest, then y, then z.
struct CloudBox {
  std::string name;  ///< unique in the frame, safe as a file name
  glm::ivec3 voxels{0};
  double voxel_m = 0.0;
  glm::dvec3 corner_m;  ///< lowest, in the south-west
  std::vector<float> extinction_per_m;
  std::vector<glm::vec3> radiance;  ///< source: a ray's gains extinction * radiance * ds
  double asymmetry = 0.86;          ///< of what scatters in it, mean cosine (Henyey and Greenstein)
  bool is_haze = false;  ///< thin in most places: what is small beside the largest number counts
};

/// A snow crystal or aggregate as flakes show it.
struct FlakePicture {
  std::string name;  ///< unique, safe as a file name, different for different pictures
  Image opacity;     ///< 1 channel in [0, 1], square, transparent along its border
};

/// A flake: a rectangle in world space, metres. What moves while the picture is exposed is as much
/// longer and less opaque.
struct Flake {
  glm::vec3 centre_m;
  glm::vec3 right_m;     ///< from its centre to the middle of its right side
  glm::vec3 up_m;        ///< to the middle of its upper side
  int picture = 0;       ///< index into Flakes::pictures
  float opacity = 1.0F;  ///< multiplies the picture's
};

/// The flake's corners as its picture has them: lower left, lower right, upper right, upper left;
/// metres from a place near the flake, where floats are fine enough for it.
inline std::array<glm::vec3, 4> corners_from(const glm::dvec3& place_m, const Flake& flake) {
  const glm::vec3 centre_m(glm::dvec3(flake.centre_m) - place_m);
  return {centre_m - flake.right_m - flake.up_m, centre_m + flake.right_m - flake.up_m,
          centre_m + flake.right_m + flake.up_m, centre_m - flake.right_m + flake.up_m};
}

/// Flakes that are seen singly; all have the same radiance.
struct Flakes {
  std::vector<FlakePicture> pictures;
  std::vector<Flake> flakes;  ///< from the farthest to the nearest
  glm::vec3 radiance{0.0F};
};

/// A homogeneous medium that fills the world: a ray's radiance L over a length s becomes
/// L exp(-extinction s) + radiance (1 - exp(-extinction s)).
struct Fog {
  double extinction_per_m = 0.0;
  glm::vec3 radiance{0.0F};
};

/// A finer picture of a square part of the ground, seen there in place of the coarser one.
struct GroundDetail {
  ColourMap map;  ///< by place from `corner_m`
  glm::dvec2 corner_m{0.0};
};

/// How far inside its edge a finer picture has wholly replaced the coarser: two of its pixels.
inline double soft_border_m(const ColourMap& coarser, const GroundDetail& finer) {
  return std::min(2.0 * coarser.step_m(), 0.25 * finer.map.size_m());
}

/// Triangles that stand out of the terrain and show the ground's pictures; counter-clockwise from
/// above.
struct RaisedGround {
  glm::dvec3 origin_m{0.0};           ///< near them, in world space
  std::vector<glm::vec3> points_m;    ///< from the origin
  std::vector<glm::uvec3> triangles;  ///< indices into `points_m`
};

/// What lights level, open ground: in its light things that others put into the landscape look as
/// if they stood there. The sun's is what falling snow leaves of it, clouds do not stand before it.
struct Daylight {
  glm::dvec3 to_sun{0.0, 0.0, 1.0};  ///< unit vector
  glm::vec3 sun_irradiance{0.0F};    ///< of a plane that faces the sun
  glm::vec3 sky_irradiance{0.0F};    ///< of level ground by all of the sky
};

/// What renderers need that follow the light themselves, from its sources to the eye: lights and
/// materials that no light has been baked into. Blades have theirs in Tubes, texels in
/// Volume::texel.
struct Unlit {
  glm::vec3 sun_irradiance{0.0F};  ///< of a plane that faces the sun, before clouds
  Image sky;  ///< as Landscape::sky, without a sun and without clouds that are volumes
  ColourMap ground_albedo;  ///< bare ground and the snow on it, by world x and y
};

struct Landscape {
  int frame = 1;            ///< from 1
  double weathering = 0.0;  ///< the frame's mean weathering degree
  double time_s = 0.0;      ///< since the film's first frame
  Daylight daylight;
  Heightfield terrain;   ///< heights in metres, over [0, size]^2
  double patch_m = 0.0;  ///< side of a cell
  std::vector<Volume> volumes;
  std::vector<Cell> cells;
  std::vector<BladeMesh> blade_meshes;
  std::vector<BladeCell> blade_cells;        ///< where no volume stands
  ColourMap light;                           ///< multiplies the radiance of grass, by world x and y
  std::vector<ColourMap> light_details;      ///< the same near the eye, coarse to fine: see
                                             ///< light_on_grass.h
  FactorMap extinction_factor;               ///< multiplies volumes' extinction, by world x and y
  ColourMap ground;                          ///< radiance of the bare ground, by world x and y
  std::vector<GroundDetail> ground_details;  ///< coarse to fine, each inside the one before
  RaisedGround boulders;                     ///< that the camera may see
  Image sky;                     ///< radiance by direction, 3 channels: column c looks to azimuth
                                 ///< 360 (c + 0.5) / width degrees clockwise from north, row r to
                                 ///< elevation 90 - 180 (r + 0.5) / height degrees
  std::vector<CloudBox> clouds;  ///< from the highest to the lowest
  std::optional<Backdrop> backdrop;  ///< before the sky; none under a clear one
  Flakes flakes;
  std::optional<Fog> fog;
  std::optional<Unlit> unlit;  ///< where an exporter asks for it
  Camera camera;
  int width_px = 0;
  int height_px = 0;
  int samples = 8;             ///< per pixel
  double exposure_gain = 1.0;  ///< factor on every radiance before sRGB encoding
};

}  // namespace wold::landscape
