#pragma once

#include "exporter/exporter.h"

namespace wold::mitsuba {

/// Mitsuba in the table of exporters: Wold writes its files and does not run it.
const exporter::Exporter& entry();

}  // namespace wold::mitsuba
