#include "scene/old_names.h"

#include <algorithm>
#include <array>

namespace wold::scene {
namespace {

constexpr std::array renamed = {
    OldName{"ageing.variation", "ageing.age_spread"},
    OldName{"ageing.variation_feature", "ageing.age_spread_feature"},
    OldName{"ageing.variety", "ageing.pigment_spread"},
    OldName{"ageing.variety_feature", "ageing.pigment_spread_feature"},
    OldName{"cloud_events.by", "cloud_events.fraction"},
    OldName{"grass.far_pixels", "grass.far_field_below_pixels"},
    OldName{"grass.gloss", "grass.specular_exponent"},
    OldName{"grass.proportion", "grass.points_per_voxel_face"},
    OldName{"growth.share", "growth.cover"},
};

/// Where the number of an item stands in a key's name, "[1]" of "clouds[1].kind"; else empty.
std::string_view number_in(std::string_view name) {
  const std::size_t begin = name.find('['), end = name.find(']');
  if (begin == std::string_view::npos || end == std::string_view::npos || end < begin) return {};
  return name.substr(begin, end + 1 - begin);
}

}  // namespace

std::span<const OldName> old_names() { return renamed; }

std::string present_name(std::string_view name) {
  const std::string_view number = number_in(name);
  std::string key(name);
  if (!number.empty()) key.erase(name.find('['), number.size());
  const auto found = std::ranges::find(renamed, key, &OldName::old_name);
  if (found == renamed.end()) return std::string(name);
  std::string present(found->name);
  if (!number.empty()) present.insert(present.find('.'), number);
  return present;
}

}  // namespace wold::scene
