#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "core/ground_map.h"
#include "snow/snowpack.h"
#include "snowpack/snow_layer.h"

namespace wold::snow {

/// The packs of many places, one array per value.
struct SnowpackField {
  std::vector<double> water_mm, depth_m, age;
  std::vector<double> liquid_mm, lacking_mm;  ///< as snowpack::SnowState; empty but in a season

  SnowpackField() = default;
  /// The same pack everywhere.
  SnowpackField(std::size_t places, const Snowpack& pack)
      : water_mm(places, pack.water_mm), depth_m(places, pack.depth_m), age(places, pack.age) {}
};

/// A step of weather under a season's sky, in hours.
struct SeasonStep {
  WeatherMoment weather;  ///< has a sky
  double hours = 0.0;

  /// What it does to all snow at a height above the terrain's zero.
  snowpack::SnowStep at(double height_m) const;
};

/// A step of weather: by degree-days, per height class, or by the heat that a season's sky brings.
using FieldStep = std::variant<std::vector<PackStep>, SeasonStep>;

/// How much the ground rises per metre to the east and to the north, place by place.
struct GroundRise {
  std::vector<float> east, north;

  GroundRise() = default;  ///< of no places
  explicit GroundRise(const Heightfield& terrain);
};

/// Places of about the same height, a metre, which is 0.0065 K, share what weather does to them:
/// the exponentials of degree-day steps are taken once per class.
class HeightClasses {
 public:
  /// All heights are finite.
  explicit HeightClasses(std::span<const float> heights_m);

  /// pack_step() per class; where `weather` has a sky, a SeasonStep. Throws InputError when
  /// `weather` has a value that is no number.
  FieldStep step(const WeatherMoment& weather, double hours, double melt_mm_per_day) const;
  const std::vector<std::uint16_t>& of_place() const { return of_place_; }
  double height_m(std::size_t of_class) const {
    return low_m_ + static_cast<double>(of_class) * class_m_;
  }
  double highest_m() const { return height_m(count_ - 1); }

 private:
  double low_m_ = 0.0;
  double class_m_ = 1.0;
  std::size_t count_ = 1;
  std::vector<std::uint16_t> of_place_;
};

/// Whether no snow lies anywhere.
bool is_bare(const SnowpackField& packs);

/// Whether it snows at any height.
bool snows(const FieldStep& step, const HeightClasses& classes);

/// Advances every pack by the step at its class's height; drift[place] multiplies the snowfall.
/// Only a SeasonStep, whose sun shines on packs as the ground rises, asks for `rise`.
void advance(SnowpackField& packs, const HeightClasses& classes, const FieldStep& step,
             std::span<const float> drift, const GroundRise& rise);

}  // namespace wold::snow
