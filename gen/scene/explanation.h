#pragma once

#include <string>
#include <string_view>

namespace wold::scene {

/// What a key means, what it accepts and its default, as TOML that a scene can take:
/// "sun.elevation", "clouds.kind", or all keys of a table: "sun", "clouds". An old name is taken
/// for the present one. Throws InputError, with the name that may have been meant, when there is no
/// such key or table.
std::string explanation(std::string_view name);

}  // namespace wold::scene
