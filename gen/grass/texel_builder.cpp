#include "grass/texel_builder.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "grass/visible.h"

namespace wold::grass {
namespace {

glm::vec3 times(const std::array<float, 6>& d, const glm::vec3& v) {
  return {d[0] * v.x + d[3] * v.y + d[4] * v.z, d[3] * v.x + d[1] * v.y + d[5] * v.z,
          d[4] * v.x + d[5] * v.y + d[2] * v.z};
}

/// The dyad's longest column: never orthogonal to the main axis.
glm::vec3 longest_column(const std::array<float, 6>& d) {
  if (d[0] >= d[1] && d[0] >= d[2]) return {d[0], d[3], d[4]};
  if (d[1] >= d[2]) return {d[3], d[1], d[5]};
  return {d[4], d[5], d[2]};
}

glm::vec3 unit_or(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0F ? v / length : otherwise;
}

/// Normals, averaged, are shorter than this where they come from both sides of a vein: the vein.
constexpr float vein_normal = 0.2F;

/// What is summed up for a voxel, one cache line: area, and by area the dyad of the tangent (xx,
/// yy, zz, xy, xz, yz), the normal, the albedo and the specular coefficient.
class alignas(64) Moments {
 public:
  Moments() = default;
  explicit Moments(const Contribution& what) {
    const float area = what.area_m2;
    const glm::vec3 t = what.tangent;
    const glm::vec3 along = area * t;
    const glm::vec3 normal = area * what.normal;
    const glm::vec3 albedo = area * what.albedo;
    sum_ = {area,          along.x * t.x,
            along.y * t.y, along.z * t.z,
            along.x * t.y, along.x * t.z,
            along.y * t.z, normal.x,
            normal.y,      normal.z,
            albedo.x,      albedo.y,
            albedo.z,      area * what.specular};
  }

  void add(const Moments& other, float share) {
    for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += share * other.sum_[i];
  }

  float area_m2() const { return sum_[0]; }
  /// Means; only where there is area.
  glm::vec3 tangent() const {
    return main_axis({sum_[1], sum_[2], sum_[3], sum_[4], sum_[5], sum_[6]});
  }
  glm::vec3 normal() const {
    const glm::vec3 mean = three(7) / area_m2();
    const float length = glm::length(mean);
    return length > vein_normal ? mean / length : glm::vec3(0.0F);
  }
  glm::vec3 albedo() const { return three(10) / area_m2(); }
  float specular() const { return sum_[13] / area_m2(); }

 private:
  glm::vec3 three(std::size_t at) const { return {sum_[at], sum_[at + 1], sum_[at + 2]}; }

  std::array<float, 16> sum_ = {};
};

/// First pass: the voxels of a slice that are worth keeping.
class SliceAreas {
 public:
  SliceAreas(const TexelShape& shape, const Contributions& contributions, float least_density)
      : contributions_(contributions),
        least_area_m2_(static_cast<float>(least_density * shape.voxel_volume_m3())),
        area_m2_(shape.slice_voxels()) {}

  void append_voxels(int z, std::uint32_t first, std::vector<std::uint32_t>& voxels) {
    std::fill(area_m2_.begin(), area_m2_.end(), 0.0F);
    contributions_.each_in_slice(z, [&](std::size_t which, std::span<const VoxelShare> shares) {
      const float area = contributions_.area_m2(which);
      for (const VoxelShare& to : shares) area_m2_[to.ground] += to.share * area;
    });
    // Most stretches of a slice are empty: a loop without branches finds that out fastest.
    constexpr std::size_t stretch = 16;
    for (std::size_t begin = 0; begin < area_m2_.size(); begin += stretch) {
      const std::size_t end = std::min(begin + stretch, area_m2_.size());
      int kept = 0;
      for (std::size_t ground = begin; ground < end; ++ground) kept += keep(ground);
      if (kept == 0) continue;
      for (std::size_t ground = begin; ground < end; ++ground)
        if (keep(ground)) voxels.push_back(first + static_cast<std::uint32_t>(ground));
    }
  }

 private:
  bool keep(std::size_t ground) const { return area_m2_[ground] > least_area_m2_; }

  const Contributions& contributions_;
  float least_area_m2_;
  std::vector<float> area_m2_;
};

/// Second pass: everything else, for those voxels.
class SliceMoments {
 public:
  SliceMoments(const TexelShape& shape, const Contributions& contributions)
      : contributions_(contributions), place_(shape.slice_voxels()) {}

  /// Fills in the voxels [begin, end) of the texel, which are those of slice z.
  void fill(int z, std::size_t begin, std::size_t end, Texel& texel) {
    const std::span<const std::uint32_t> voxels(&texel.voxel[begin], end - begin);
    const std::uint32_t first = texel.shape.linear(0, 0, z);
    for (std::uint32_t i = 0; i < voxels.size(); ++i) place_[voxels[i] - first] = i;
    sums_.assign(voxels.size(), Moments());
    contributions_.each_in_slice(z, [&](std::size_t which, std::span<const VoxelShare> shares) {
      const Moments moments(contributions_.contribution(which));
      for (const VoxelShare& to : shares) {
        // Places of voxels that were not kept are left from other slices and lead elsewhere.
        const std::uint32_t place = place_[to.ground];
        if (place < voxels.size() && voxels[place] == first + to.ground)
          sums_[place].add(moments, to.share);
      }
    });
    for (std::size_t i = 0; i < voxels.size(); ++i) {
      const Moments& sum = sums_[i];
      texel.density[begin + i] = static_cast<float>(sum.area_m2() / texel.shape.voxel_volume_m3());
      texel.tangent[begin + i] = sum.tangent();
      texel.normal[begin + i] = sum.normal();
      texel.albedo[begin + i] = sum.albedo();
      texel.specular[begin + i] = sum.specular();
    }
  }

 private:
  const Contributions& contributions_;
  std::vector<std::uint32_t> place_;  ///< of a slice's voxels among those kept
  std::vector<Moments> sums_;
};

constexpr int slab_slices = 16;  // made by one thread in turn

std::size_t slabs(const TexelShape& shape) {
  return static_cast<std::size_t>((shape.height + slab_slices - 1) / slab_slices);
}

/// Runs body(slab, its first slice, the one after its last).
template <class Body>
void parallel_for_slabs(const TexelShape& shape, const Body& body) {
  parallel_for(slabs(shape), [&](std::size_t slab) {
    const int bottom = static_cast<int>(slab) * slab_slices;
    body(slab, bottom, std::min(bottom + slab_slices, shape.height));
  });
}

/// The voxels denser than `least`, ascending.
std::vector<std::uint32_t> voxels_above(const TexelShape& shape, const Contributions& contributions,
                                        float least) {
  std::vector<std::vector<std::uint32_t>> parts(slabs(shape));
  parallel_for_slabs(shape, [&](std::size_t slab, int bottom, int top) {
    SliceAreas areas(shape, contributions, least);
    for (int z = bottom; z < top; ++z) areas.append_voxels(z, shape.linear(0, 0, z), parts[slab]);
  });
  std::vector<std::uint32_t> voxels;
  for (const auto& part : parts) voxels.insert(voxels.end(), part.begin(), part.end());
  return voxels;
}

}  // namespace

glm::vec3 main_axis(const std::array<float, 6>& dyad) {
  constexpr glm::vec3 up(0.0F, 0.0F, 1.0F);
  glm::vec3 axis = unit_or(longest_column(dyad), up);
  // Power iteration; a blade's own voxels are one fibre, for which the first step is exact.
  for (int step = 0; step < 6; ++step) {
    const glm::vec3 next = unit_or(times(dyad, axis), up);
    const bool settled = glm::dot(next, axis) > 1.0F - 1e-7F;
    axis = next;
    if (settled) break;
  }
  return axis.z < 0.0F ? -axis : axis;
}

Texel build_texel(const TexelShape& shape, const Contributions& contributions, double area_m2) {
  Texel texel;
  texel.shape = shape;
  texel.voxel = voxels_above(shape, contributions, faintest_density(shape));
  if (texel.voxel.empty()) texel.voxel = voxels_above(shape, contributions, 0.0F);
  texel.density.resize(texel.size());
  texel.tangent.resize(texel.size());
  texel.normal.resize(texel.size());
  texel.albedo.resize(texel.size());
  texel.specular.resize(texel.size());
  parallel_for_slabs(shape, [&](std::size_t, int bottom, int top) {
    SliceMoments moments(shape, contributions);
    const auto begin_of = [&](int z) {
      return std::lower_bound(texel.voxel.begin(), texel.voxel.end(), shape.linear(0, 0, z)) -
             texel.voxel.begin();
    };
    for (int z = bottom; z < top; ++z)
      moments.fill(z, static_cast<std::size_t>(begin_of(z)),
                   static_cast<std::size_t>(begin_of(z + 1)), texel);
  });
  const auto whole = static_cast<float>(area_m2 / texel.area_m2());
  for (float& density : texel.density) density *= whole;
  return texel;
}

}  // namespace wold::grass
