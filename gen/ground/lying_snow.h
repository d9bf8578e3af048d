#pragma once

#include <vector>

#include "core/ground_map.h"
#include "snow/large_cover.h"

namespace wold::ground {

/// The snow of a large terrain about a camera, by place: fine near it, coarse far away.
class LyingSnow {
 public:
  /// `levels`: LargeCover::view()'s.
  explicit LyingSnow(std::vector<snow::CoverLevel> levels);

  float depth_m(const glm::dvec2& at_m) const { return sample(at_m, &Level::depth_m); }
  /// Fraction of the ground that is white.
  float fraction(const glm::dvec2& at_m) const { return sample(at_m, &Level::fraction); }

  bool is_none() const { return none_; }
  /// Mean albedo of the snow, weighted by its fraction.
  float albedo() const { return albedo_; }

 private:
  struct Level {
    FactorMap depth_m;
    FactorMap fraction;
  };
  float sample(const glm::dvec2& at_m, FactorMap Level::*map) const;

  std::vector<Level> levels_;
  bool none_ = true;
  float albedo_ = 0.9F;
};

}  // namespace wold::ground
