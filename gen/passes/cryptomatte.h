#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/layered_image.h"

/// Which names cover each pixel, and how much of it, as compositors pick them: the specification of
/// Cryptomatte, version 1.2.0 [Friedman2015].
namespace wold::passes {

/// MurmurHash3 (Appleby 2011), the variant of 32 bits, seed 0.
std::uint32_t murmur_hash(std::string_view text);

/// The number that stands for a name in the files' channels: its hash's bits, of which one is
/// turned over where they are that of no common number.
float id_of(std::string_view name);

/// Fractions of every pixel that each name covers.
class Cryptomatte {
 public:
  /// `layer` names the channels, `names` what there is.
  Cryptomatte(std::string layer, std::vector<std::string> names, std::size_t pixels);

  /// How many channels there are for so many names.
  static std::size_t channels_of(std::size_t names);

  /// Sets a pixel's fractions, one for each name. Pixels may be set at the same time.
  void set(std::size_t pixel, std::span<const double> fractions);

  /// Adds the channels <layer>00.R and on: id and fraction of the names that cover most, in falling
  /// order; as many as there are names, six at most. And the header's attributes with the names.
  void add_to(LayeredImage& image) const;

 private:
  std::string layer_;
  std::vector<std::string> names_;
  std::vector<float> ids_;
  std::vector<std::vector<float>> channels_;  ///< id, fraction, id, fraction ...
};

}  // namespace wold::passes
