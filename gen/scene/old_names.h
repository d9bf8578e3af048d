#pragma once

#include <span>
#include <string>
#include <string_view>

/// Scene files that were written for an earlier version keep working: a key that was renamed is
/// still read under its old name, with a warning.
namespace wold::scene {

/// A key that was renamed.
struct OldName {
  std::string_view old_name;  ///< dotted, without an item's number: "clouds.kind"
  std::string_view name;      ///< the registry's
};

/// All keys that were renamed.
std::span<const OldName> old_names();

/// The name that a key has today. A key of an item, as "clouds[1].kind", stays in its item. A name
/// that never changed, or that no key ever had, comes back as it is.
std::string present_name(std::string_view name);

}  // namespace wold::scene
