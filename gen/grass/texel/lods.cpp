#include "grass/texel/lods.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/angle.h"
#include "core/elementary.h"
#include "grass/texel/columns.h"
#include "grass/texel/visible.h"

namespace wold::grass {
namespace {

constexpr int azimuths = 2;
/// Optical depth along a voxel's side that no one tells from more: 1/3000 comes through.
constexpr double solid_depth = 8.0;

/// Rows of rays that are enough for a mean over a fine texel.
int row_stride(const TexelShape& shape) { return std::max(1, shape.side / 24); }

/// From 0 (nothing) to 1 (solid).
float filled(float depth) { return depth / (1.0F + depth); }

/// Three ways to weigh a voxel's density; the fitted density is a mix of them: as it is; by how
/// filled the voxel is; by how filled the column of voxels over its ground is, squared, because
/// seen from above a coarse level has lost most of its gaps. The last two set gaps against clumps,
/// in all directions and from above.
class Weighting {
 public:
  Weighting(const TexelShape& shape, const std::vector<std::uint32_t>& voxel,
            const std::vector<float>& density)
      : shape_(shape),
        voxel_(voxel),
        density_(density),
        column_(static_cast<std::size_t>(shape.side) * static_cast<std::size_t>(shape.side), 0.0F) {
    for (std::size_t i = 0; i < voxel.size(); ++i) column_[ground(i)] += depth(i);
    for (float depth : column_) fullest_ = std::max(fullest_, depth);
  }
  glm::vec3 basis(std::size_t i) const {
    const float column = column_[ground(i)] / fullest_;
    return density_[i] * glm::vec3(1.0F, filled(depth(i)), column * column);
  }
  std::vector<glm::vec3> bases() const {
    std::vector<glm::vec3> all(voxel_.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = basis(i);
    return all;
  }

 private:
  float depth(std::size_t i) const { return density_[i] * static_cast<float>(shape_.voxel_m); }
  std::size_t ground(std::size_t i) const { return voxel_[i] % column_.size(); }

  const TexelShape& shape_;
  const std::vector<std::uint32_t>& voxel_;
  const std::vector<float>& density_;
  std::vector<float> column_;
  float fullest_ = 1e-6F;
};

/// Optical depths of rays from the three elevations, one component per basis of Weighting.
using RayDepths = std::array<std::vector<glm::vec3>, 3>;

RayDepths ray_depths(const VoxelRows& voxels, const std::vector<glm::vec3>& bases) {
  RayDepths depths;
  for (std::size_t i = 0; i < depths.size(); ++i)
    for (const auto& direction : transmittance_directions(Transmittances::elevations_deg[i])) {
      const auto rays = optical_depths(voxels, bases, direction, row_stride(voxels.shape()));
      depths[i].insert(depths[i].end(), rays.begin(), rays.end());
    }
  return depths;
}

/// Mean transmittances for the weights of a mix, and how they change with them.
struct Response {
  glm::dvec3 seen{0.0};   ///< per elevation
  glm::dmat3 slope{0.0};  ///< slope[elevation][weight]
};

Response response(const RayDepths& depths, const glm::dvec3& weights) {
  Response result;
  const glm::vec3 w(weights);
  for (int i = 0; i < 3; ++i) {
    const auto& rays = depths[static_cast<std::size_t>(i)];
    double sum = 0.0;
    glm::dvec3 slope(0.0);
    for (const glm::vec3& depth : rays) {
      const float through = math::exp(-glm::dot(w, depth));
      sum += double{through};
      slope -= glm::dvec3(through * depth);
    }
    result.seen[i] = sum / static_cast<double>(rays.size());
    result.slope[i] = slope / static_cast<double>(rays.size());
  }
  return result;
}

/// The step of Levenberg and Marquardt towards `miss` per elevation.
glm::dvec3 damped_step(const Response& now, const glm::dvec3& miss, double damping) {
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (int i = 0; i < 3; ++i) {
    normal += glm::outerProduct(now.slope[i], now.slope[i]);
    right += now.slope[i] * miss[i];
  }
  for (int i = 0; i < 3; ++i) normal[i][i] = normal[i][i] * (1.0 + damping) + 1e-12;
  return glm::inverse(normal) * right;
}

/// Keeps the mix positive for every voxel: its two fillings lie in [0, 1].
glm::dvec3 positive(glm::dvec3 weights) {
  constexpr double min = 0.02;
  weights.x = std::max(weights.x, min);
  const double spare = weights.x - min;
  const double taken = std::max(0.0, -weights.y) + std::max(0.0, -weights.z);
  const double keep = taken > spare ? spare / taken : 1.0;
  if (weights.y < 0.0) weights.y *= keep;
  if (weights.z < 0.0) weights.z *= keep;
  return weights;
}

glm::dvec3 fitted_weights(const RayDepths& depths, const glm::dvec3& wanted) {
  constexpr int steps = 40;
  constexpr double good = 5e-4;
  constexpr double hopeless = 1e6;  // damped to a standstill: at the edge of what a mix can do
  glm::dvec3 weights(1.0, 0.0, 0.0);
  Response now = response(depths, weights);
  double damping = 1e-2;
  for (int step = 0; step < steps && glm::length(now.seen - wanted) > good && damping < hopeless;
       ++step) {
    const glm::dvec3 next = positive(weights + damped_step(now, wanted - now.seen, damping));
    const Response then = response(depths, next);
    const bool better = glm::length(then.seen - wanted) < glm::length(now.seen - wanted);
    damping *= better ? 0.2 : 8.0;
    if (!better) continue;
    weights = next;
    now = then;
  }
  return weights;
}

/// How one axis of a fine voxel is split over the coarse ones: the first, its fraction, and the
/// rest goes to the next.
struct Split {
  int first;
  float fraction;
};

/// The splits of a fine axis with `count` voxels.
std::vector<Split> splits(int count, int fine_side, int coarse_side) {
  const double scale = static_cast<double>(coarse_side) / fine_side;
  std::vector<Split> result;
  for (int fine = 0; fine < count; ++fine) {
    const double begin = fine * scale;
    const int first = static_cast<int>(std::floor(begin));
    const double fraction = (std::min(begin + scale, first + 1.0) - begin) / scale;
    result.push_back({first, fraction > 1.0 - 1e-6 ? 1.0F : static_cast<float>(fraction)});
  }
  return result;
}

/// Which coarse voxels every fine one overlaps, and by how much.
class Overlap {
 public:
  Overlap(const TexelShape& fine, const TexelShape& coarse)
      : fine_(fine),
        coarse_(coarse),
        across_(splits(fine.side, fine.side, coarse.side)),
        up_(splits(fine.height, fine.side, coarse.side)) {}

  /// For the coarse voxels of one slice: calls visit(place of the fine voxel, place of the coarse
  /// one within its slice, fraction of the fine one that lies in it).
  template <class Visit>
  void each_in_slice(int coarse_z, const VoxelRows& voxels, const Visit& visit) const {
    for (int z = 0; z < fine_.height; ++z) {
      const Split& slice = up_[static_cast<std::size_t>(z)];
      const int k = coarse_z - slice.first;
      if (k < 0 || k >= parts(slice)) continue;
      for (int y = 0; y < fine_.side; ++y) each_of_row(voxels, y, z, part(slice, k), visit);
    }
  }

 private:
  template <class Visit>
  void each_of_row(const VoxelRows& voxels, int y, int z, float slice_fraction,
                   const Visit& visit) const {
    const Split& row = across_[static_cast<std::size_t>(y)];
    voxels.each(y, z, [&](int x, std::size_t place) {
      const Split& column = across_[static_cast<std::size_t>(x)];
      for (int j = 0; j < parts(row); ++j)
        for (int i = 0; i < parts(column); ++i)
          visit(place, std::size_t{coarse_.linear(column.first + i, row.first + j, 0)},
                part(column, i) * part(row, j) * slice_fraction);
    });
  }
  static int parts(const Split& split) { return split.fraction < 1.0F ? 2 : 1; }
  static float part(const Split& split, int i) {
    return i == 0 ? split.fraction : 1.0F - split.fraction;
  }

  const TexelShape& fine_;
  const TexelShape& coarse_;
  std::vector<Split> across_;
  std::vector<Split> up_;
};

/// Sums over one slice of a coarse level: per voxel its density, then density times emission for
/// each turn, side by side.
class SliceSums {
 public:
  SliceSums(const TexelShape& shape, std::size_t turns)
      : width_(1 + 3 * turns),
        sums_(width_ * static_cast<std::size_t>(shape.side) *
              static_cast<std::size_t>(shape.side)) {}
  void clear() { std::fill(sums_.begin(), sums_.end(), 0.0F); }

  void add(std::size_t to, float fraction, const VolumeData& fine, std::size_t from) {
    float* sum = &sums_[width_ * to];
    const float density = fraction * fine.density[from];
    *sum++ += density;
    for (const auto& emission : fine.emission)
      for (int channel = 0; channel < 3; ++channel) *sum++ += density * emission[from][channel];
  }

  /// Appends the voxels that hold anything.
  void append_to(VolumeData& coarse, int z) const {
    const std::uint32_t first = coarse.shape.linear(0, 0, z);
    for (std::uint32_t i = 0; i < sums_.size() / width_; ++i) {
      const float* sum = &sums_[width_ * i];
      if (!(sum[0] > 0.0F)) continue;
      coarse.voxel.push_back(first + i);
      coarse.density.push_back(sum[0]);
      for (std::size_t turn = 0; turn < coarse.emission.size(); ++turn) {
        const float* weighted = sum + 1 + 3 * turn;
        coarse.emission[turn].push_back(glm::vec3(weighted[0], weighted[1], weighted[2]) / sum[0]);
      }
    }
  }

 private:
  std::size_t width_;
  std::vector<float> sums_;
};

}  // namespace

double Transmittances::difference(const Transmittances& a, const Transmittances& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.value.size(); ++i)
    largest = std::max(largest, std::abs(a.value[i] - b.value[i]));
  return largest;
}

std::vector<glm::dvec3> transmittance_directions(double elevation_deg) {
  const int count = elevation_deg > 89.0 ? 1 : azimuths;
  std::vector<glm::dvec3> directions;
  directions.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    directions.push_back(
        direction_at(elevation_deg * radians_per_degree, 0.4 + i * std::numbers::pi / 2.0));
  return directions;
}

Transmittances transmittances(const VoxelRows& voxels, const std::vector<float>& density) {
  Transmittances result;
  for (std::size_t i = 0; i < 3; ++i) {
    double sum = 0.0;
    std::size_t count = 0;
    for (const auto& direction : transmittance_directions(Transmittances::elevations_deg[i])) {
      const auto depths = optical_depths(voxels, density, direction, row_stride(voxels.shape()));
      for (float depth : depths) sum += double{math::exp(-depth)};
      count += depths.size();
    }
    result.value[i] = sum / static_cast<double>(count);
  }
  return result;
}

std::vector<float> fitted_density(const TexelShape& shape, const std::vector<std::uint32_t>& voxel,
                                  const std::vector<float>& density, const Transmittances& wanted) {
  const std::vector<glm::vec3> bases = Weighting(shape, voxel, density).bases();
  const glm::vec3 weights(fitted_weights(ray_depths(VoxelRows(shape, voxel), bases),
                                         {wanted.value[0], wanted.value[1], wanted.value[2]}));
  std::vector<float> result(density.size());
  // Columns that let nothing through, under a shrub, have no say in the fit, which may make them
  // denser without end; 8 bits would hold nothing else of the patch.
  const auto solid = static_cast<float>(solid_depth / shape.voxel_m);
  for (std::size_t i = 0; i < density.size(); ++i)
    result[i] = std::min(glm::dot(weights, bases[i]), solid);
  return result;
}

VolumeData without_faint(const VolumeData& volume) {
  const std::vector<std::uint32_t> kept = visible_voxels(volume.density, volume.shape);
  double shown = 0.0;
  for (std::uint32_t from : kept) shown += double{volume.density[from]};
  double all = 0.0;
  for (float density : volume.density) all += double{density};
  VolumeData result;
  result.shape = volume.shape;
  result.turns = volume.turns;
  for (std::uint32_t from : kept) {
    result.voxel.push_back(volume.voxel[from]);
    result.density.push_back(static_cast<float>(volume.density[from] * (all / shown)));
  }
  for (const auto& emission : volume.emission) {
    auto& to = result.emission.emplace_back();
    for (std::uint32_t from : kept) to.push_back(emission[from]);
  }
  return result;
}

TexelShape coarse_shape(const TexelShape& fine, int side) {
  const double scale = static_cast<double>(side) / fine.side;
  return {side, static_cast<int>(std::ceil(fine.height * scale - 1e-9)), fine.voxel_m / scale};
}

VolumeData coarser(const VolumeData& fine, int side) {
  VolumeData coarse;
  coarse.shape = coarse_shape(fine.shape, side);
  coarse.turns = fine.turns;
  coarse.emission.resize(fine.emission.size());
  const Overlap overlap(fine.shape, coarse.shape);
  const VoxelRows voxels(fine.shape, fine.voxel);
  const auto volume_fraction =
      static_cast<float>(fine.shape.voxel_volume_m3() / coarse.shape.voxel_volume_m3());
  SliceSums sums(coarse.shape, fine.emission.size());
  for (int z = 0; z < coarse.shape.height; ++z) {
    sums.clear();
    overlap.each_in_slice(z, voxels, [&](std::size_t from, std::size_t to, float fraction) {
      sums.add(to, fraction * volume_fraction, fine, from);
    });
    sums.append_to(coarse, z);
  }
  return coarse;
}

std::vector<glm::dvec3> radiances(const VolumeData& volume) {
  constexpr double elevation = 30.0 * radians_per_degree;
  const VoxelRows voxels(volume.shape, volume.voxel);
  std::vector<glm::dvec3> result;
  for (const auto& emission : volume.emission)
    result.push_back(mean_radiance(voxels, volume.density, emission, direction_at(elevation, 0.4),
                                   row_stride(volume.shape)));
  return result;
}

void match_radiances(VolumeData& volume, const std::vector<glm::dvec3>& wanted) {
  const std::vector<glm::dvec3> seen = radiances(volume);
  for (std::size_t turn = 0; turn < volume.emission.size(); ++turn) {
    const glm::vec3 factor(wanted[turn] / glm::max(seen[turn], glm::dvec3(1e-12)));
    for (glm::vec3& value : volume.emission[turn]) value *= factor;
  }
}

}  // namespace wold::grass
