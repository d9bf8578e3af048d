#pragma once

#include "exporter/exporter.h"

namespace wold::blender {

/// Blender in the table of exporters.
const exporter::Exporter& entry();

}  // namespace wold::blender
