#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/image.h"
#include "snow/fall_speed.h"

namespace wold::snow {

/// A flake's picture: 1 channel of opacity in [0, 1], square, transparent along its border. Its
/// name is unique among the pictures of a scene and safe as a file name.
struct CrystalPicture {
  std::string name;
  Image opacity;
};

/// The pictures that a scene's flakes share: of each crystal several keyed individuals, each at
/// four levels of detail that are averages of the first; a disc; a streak for what moves while it
/// is exposed, whose length is along the picture's height.
class FlakePictures {
 public:
  static constexpr int individuals = 4;
  static constexpr int levels = 4;
  static constexpr int finest_px = 128;  ///< then half of that, ...

  explicit FlakePictures(std::uint64_t seed);

  const std::vector<CrystalPicture>& all() const { return pictures_; }
  /// Indices into all(). `individual` in [0, individuals), `level` in [0, levels).
  int crystal(Crystal crystal, int individual, int level) const;
  int disc() const { return static_cast<int>(pictures_.size()) - 2; }
  int streak() const { return static_cast<int>(pictures_.size()) - 1; }
  /// Of a picture, over its square; above 0.
  float mean_opacity(int picture) const { return means_[static_cast<std::size_t>(picture)]; }

 private:
  void add(std::string name, Image opacity);
  std::vector<CrystalPicture> pictures_;
  std::vector<float> means_;
};

}  // namespace wold::snow
