#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace wold::scene {

/// The candidate with the fewest edits to `word` (insert, delete, replace, swap neighbours), or ""
/// when even that one differs in more than a third of its letters (two are always forgiven).
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// `; did you mean "x"?`, or "" when there is nothing to suggest.
std::string suggestion(std::string_view near);

}  // namespace wold::scene
