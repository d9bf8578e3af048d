#pragma once

#include "exporter/exporter.h"

namespace wold::povray {

/// POV-Ray in the table of exporters.
const exporter::Exporter& entry();

}  // namespace wold::povray
