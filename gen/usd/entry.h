#pragma once

#include "exporter/exporter.h"

namespace wold::usd {

/// USD in the table of exporters: Wold writes its files and starts no host.
const exporter::Exporter& entry();

}  // namespace wold::usd
