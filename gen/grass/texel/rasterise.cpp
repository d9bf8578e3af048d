#include "grass/texel/rasterise.h"

#include <array>
#include <memory>

#include "core/parallel.h"
#include "grass/texel/footprint.h"
#include "grass/texel/texel_builder.h"

namespace wold::grass {
namespace {

/// The points of a texel in the order of the slices they lie in, and by their number within a
/// slice. They are counted and sorted part by part, each of them points that follow one another.
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
    if (z > 0) each(slice - 1, [&](std::size_t i) { weigh(i, footprints_[i].above(), visit); });
    each(slice, [&](std::size_t i) { weigh(i, footprints_[i].own(), visit); });
    if (slice + 2 < begin_.size())
      each(slice + 1, [&](std::size_t i) { weigh(i, footprints_[i].below(), visit); });
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
                      points_.transmittance[p], points_.specular[p]);
  }

  template <class Body>
  void each(std::size_t slice, const Body& body) const {
    for (std::size_t i = begin_[slice]; i < begin_[slice + 1]; ++i) body(i);
  }
  template <std::size_t Count, class Visit>
  static void weigh(std::size_t which, const std::array<VoxelWeight, Count>& weights,
                    const Visit& visit) {
    visit(which, std::span<const VoxelWeight, Count>(weights));
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
