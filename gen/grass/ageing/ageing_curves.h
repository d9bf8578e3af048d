#pragma once

#include <set>
#include <string>

#include "core/curve.h"
#include "scene/scene.h"

namespace wold::grass {

/// What a curve gives: the relative content of what withers (1 = fresh leaf), or the ageing rate of
/// a sample, its own weathering degree.
enum class CurveKind { water, chlorophyll, rate };

/// Names of the curves of a kind that ship with the program, in alphabetical order. Throws
/// FileError when models/ageing is missing.
std::set<std::string> curve_names(CurveKind kind);

/// The curve over the meadow's weathering degree: the user's own points, or
/// models/ageing/<kind>_<name>.toml. Throws InputError when the points are wrong or no such model
/// exists, naming those that do.
Curve load_curve(CurveKind kind, const scene::CurveChoice& choice);

}  // namespace wold::grass
