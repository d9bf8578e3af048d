#pragma once

#include <vector>

#include "core/table.h"
#include "grass/ageing/withering_curves.h"

namespace wold::report {

/// The curves as columns, one row per weathering degree. Contents are relative to the fresh leaf,
/// strains are fractions of the volume lost, the colour is encoded sRGB from 0 to 1.
std::vector<Column> withering_table(const grass::WitheringCurves& curves);

}  // namespace wold::report
