#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "snow/snowpack.h"

namespace wold::snow {

/// The packs of many places, one array per value.
struct SnowpackField {
  std::vector<double> water_mm, depth_m, age;

  SnowpackField() = default;
  /// The same pack everywhere.
  SnowpackField(std::size_t places, const Snowpack& pack)
      : water_mm(places, pack.water_mm), depth_m(places, pack.depth_m), age(places, pack.age) {}
};

/// Places of about the same height share what weather does to them: its exponentials are taken
/// once per metre of height, which is 0.0065 K.
class HeightClasses {
 public:
  /// All heights are finite.
  explicit HeightClasses(std::span<const float> heights_m);

  /// pack_step() per class. Throws InputError when `weather` has a value that is no number.
  std::vector<PackStep> steps(const WeatherMoment& weather, double hours,
                              double melt_mm_per_day) const;
  const std::vector<std::uint16_t>& of_place() const { return of_place_; }

 private:
  double low_m_ = 0.0;
  double class_m_ = 1.0;
  std::size_t count_ = 1;
  std::vector<std::uint16_t> of_place_;
};

/// Whether no snow lies anywhere.
bool is_bare(const SnowpackField& packs);

/// Whether it snows at any height.
bool snows(const std::vector<PackStep>& steps);

/// Advances every pack by its class's step; drift[place] multiplies the snowfall.
void advance(SnowpackField& packs, const HeightClasses& classes, const std::vector<PackStep>& steps,
             std::span<const float> drift);

}  // namespace wold::snow
