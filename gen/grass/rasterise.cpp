#include "grass/rasterise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "core/parallel.h"
#include "grass/texel_builder.h"

namespace wold::grass {
namespace {

constexpr float sigma_voxels = 0.6F;

/// e^x for |x| < 1.5, to three in ten million: the series for x / 4, which takes x, y and z at
/// once. Calls of std::exp would take a tenth of all the time.
template <class Value>
constexpr Value short_exp(Value x) {
  const Value q = 0.25F * x;
  Value sum = q * (1.0F / 5040.0F) + 1.0F / 720.0F;
  for (float next : {1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F})
    sum = q * sum + next;
  return (sum * sum) * (sum * sum);
}

/// The voxels before, at and after i, brought back into the tile.
std::array<std::uint32_t, 3> neighbours(int i, const TexelShape& shape) {
  const int middle = shape.wrapped(i);
  return {static_cast<std::uint32_t>(middle == 0 ? shape.side - 1 : middle - 1),
          static_cast<std::uint32_t>(middle),
          static_cast<std::uint32_t>(middle + 1 == shape.side ? 0 : middle + 1)};
}

/// std::floor, which is a function call where the build must run on any x86-64.
int floored(float value) {
  const auto towards_zero = static_cast<int>(value);
  return towards_zero - (value < static_cast<float>(towards_zero) ? 1 : 0);
}

/// The 3^3 voxels around a point but for the eight corners: a Gaussian in space is the product of
/// one for each axis.
class Footprint {
 public:
  Footprint() = default;
  Footprint(const glm::vec3& position_m, float area_m2, const TexelShape& shape) {
    const glm::vec3 place = position_m * static_cast<float>(1.0 / shape.voxel_m);
    const glm::ivec2 middle(floored(place.x), floored(place.y));
    const int slice = shape.slice(place.z);
    column_ = neighbours(middle.x, shape);
    line_ = neighbours(middle.y, shape);
    for (std::uint32_t& line : line_) line *= static_cast<std::uint32_t>(shape.side);
    const float height = std::clamp(place.z, 0.0F, static_cast<float>(shape.height));
    weigh(Four{place.x - static_cast<float>(middle.x), place.y - static_cast<float>(middle.y),
               height - static_cast<float>(slice)});
    if (slice == 0) below_[2] = 0.0F;
    if (slice + 1 == shape.height) above_[2] = 0.0F;
    const Four outer = below_ + above_;
    middle_m2_ = area_m2 / ((1.0F + outer[0]) * (1.0F + outer[1]) * (1.0F + outer[2]) -
                            outer[0] * outer[1] * outer[2]);
  }

  /// What the point's own slice gets.
  std::array<VoxelShare, 9> own() const {
    const float before = middle_m2_ * below_[1];
    const float after = middle_m2_ * above_[1];
    return {{{line_[0] + column_[0], before * below_[0]},
             {line_[0] + column_[1], before},
             {line_[0] + column_[2], before * above_[0]},
             {line_[1] + column_[0], middle_m2_ * below_[0]},
             {line_[1] + column_[1], middle_m2_},
             {line_[1] + column_[2], middle_m2_ * above_[0]},
             {line_[2] + column_[0], after * below_[0]},
             {line_[2] + column_[1], after},
             {line_[2] + column_[2], after * above_[0]}}};
  }
  std::array<VoxelShare, 5> below() const { return beside(middle_m2_ * below_[2]); }
  std::array<VoxelShare, 5> above() const { return beside(middle_m2_ * above_[2]); }

 private:
  /// Weights of the neighbours in units of the middle one's, for a point `inside` its voxel:
  /// exp(-((d +- 1)^2 - d^2) / (2 sigma^2)), d off the middle.
  void weigh(const Four& inside) {
    constexpr float k = 1.0F / (2.0F * sigma_voxels * sigma_voxels);
    const Four upwards = short_exp<Four>(2.0F * k * (inside - 0.5F));
    above_ = short_exp(-k) * upwards;
    below_ = short_exp(-k) / upwards;
  }
  std::array<VoxelShare, 5> beside(float m2) const {
    return {{{line_[0] + column_[1], m2 * below_[1]},
             {line_[1] + column_[0], m2 * below_[0]},
             {line_[1] + column_[1], m2},
             {line_[1] + column_[2], m2 * above_[0]},
             {line_[2] + column_[1], m2 * above_[1]}}};
  }

  Four below_, above_;                   ///< weights of the neighbours along x, y and z
  float middle_m2_;                      ///< what the point's own voxel gets
  std::array<std::uint32_t, 3> column_;  ///< x of the voxels
  std::array<std::uint32_t, 3> line_;    ///< place of their rows in the slice
};

/// The points of a texel in the order of the slices they lie in.
///
/// They are put there part by part, each of them points that follow one another: reading them in
/// turn and writing them all over is faster than the other way round, and parts do not wait for
/// each other.
class PointContributions {
 public:
  PointContributions(const Points& points, const TexelShape& shape)
      : points_(points), shape_(shape), begin_(static_cast<std::size_t>(shape.height) + 1) {
    std::vector<std::vector<std::uint32_t>> place(parts);
    std::array<double, parts> part_m2{};
    parallel_for(parts, [&](std::size_t part) { place[part] = count(part, part_m2[part]); });
    for (double area_m2 : part_m2) area_m2_ += area_m2;
    counts_to_places(place);
    footprints_ = std::make_unique_for_overwrite<Footprint[]>(begin_.back());
    moments_ = std::make_unique_for_overwrite<Moments[]>(begin_.back());
    std::vector<std::uint32_t> order(begin_.back());
    parallel_for(parts, [&](std::size_t part) {
      each_of_part(part,
                   [&](std::uint32_t p, std::size_t slice) { order[place[part][slice]++] = p; });
    });
    parallel_for_blocks(order.size(), [&](std::size_t i) { put(order[i], i); });
  }

  template <class Visit>
  void each_in_slice(int z, const Visit& visit) const {
    const auto slice = static_cast<std::size_t>(z);
    if (z > 0) each(slice - 1, [&](std::size_t i) { share(i, footprints_[i].above(), visit); });
    each(slice, [&](std::size_t i) { share(i, footprints_[i].own(), visit); });
    if (slice + 2 < begin_.size())
      each(slice + 1, [&](std::size_t i) { share(i, footprints_[i].below(), visit); });
  }
  const Moments& moments(std::size_t which) const { return moments_[which]; }
  double area_m2() const { return area_m2_; }

 private:
  static constexpr std::size_t parts = 32;

  /// Calls body(point, its slice) for every point of a part that has area.
  template <class Body>
  void each_of_part(std::size_t part, const Body& body) const {
    const auto voxels_per_m = static_cast<float>(1.0 / shape_.voxel_m);
    const std::size_t end = points_.size() * (part + 1) / parts;
    for (std::size_t p = points_.size() * part / parts; p < end; ++p)
      if (points_.area_m2[p] > 0.0F)
        body(static_cast<std::uint32_t>(p),
             static_cast<std::size_t>(shape_.slice(points_.position_m[p].z * voxels_per_m)));
  }
  /// How many of a part's points lie in each slice; adds up their area.
  std::vector<std::uint32_t> count(std::size_t part, double& area_m2) const {
    std::vector<std::uint32_t> count(static_cast<std::size_t>(shape_.height));
    each_of_part(part, [&](std::uint32_t p, std::size_t slice) {
      ++count[slice];
      area_m2 += double{points_.area_m2[p]};
    });
    return count;
  }
  /// From how many points each part has in each slice to where the first of them goes.
  void counts_to_places(std::vector<std::vector<std::uint32_t>>& place) {
    std::uint32_t next = 0;
    for (std::size_t slice = 0; slice + 1 < begin_.size(); ++slice) {
      for (auto& of_part : place) {
        const std::uint32_t count = of_part[slice];
        of_part[slice] = next;
        next += count;
      }
      begin_[slice + 1] = next;
    }
  }
  /// Made in their place: a copy would wait for what has just been written.
  void put(std::uint32_t p, std::size_t i) {
    std::construct_at(&footprints_[i], points_.position_m[p], points_.area_m2[p], shape_);
    std::construct_at(&moments_[i], points_.tangent[p], points_.normal[p], points_.albedo[p],
                      points_.specular[p]);
  }

  template <class Body>
  void each(std::size_t slice, const Body& body) const {
    for (std::size_t i = begin_[slice]; i < begin_[slice + 1]; ++i) body(i);
  }
  template <std::size_t Count, class Visit>
  static void share(std::size_t which, const std::array<VoxelShare, Count>& shares,
                    const Visit& visit) {
    visit(which, std::span<const VoxelShare, Count>(shares));
  }

  const Points& points_;
  TexelShape shape_;
  double area_m2_ = 0.0;
  std::vector<std::uint32_t> begin_;  ///< first footprint of each slice, and the end
  std::unique_ptr<Footprint[]> footprints_;
  std::unique_ptr<Moments[]> moments_;
};

}  // namespace

Texel rasterise_points(const Points& points, const TexelShape& shape) {
  const PointContributions contributions(points, shape);
  return build_texel(shape, contributions, contributions.area_m2());
}

}  // namespace wold::grass
