#include "exporter/exporter.h"

#include <algorithm>

namespace wold::exporter {

bool writes(const Exporter& exporter, std::string_view name) {
  return name == exporter.name || std::ranges::count(exporter.files_for_output_folder, name) > 0;
}

const Exporter* find_exporter(Exporters exporters, std::string_view name) {
  const auto found = std::ranges::find(exporters, name, &Exporter::name);
  return found == exporters.end() ? nullptr : *found;
}

landscape::Needs needs_of_all(Exporters exporters) {
  landscape::Needs all;
  for (const Exporter* one : exporters) {
    all.max_flakes_on_a_ray = std::min(all.max_flakes_on_a_ray, one->needs.max_flakes_on_a_ray);
    all.materials = all.materials || one->needs.materials;
  }
  return all;
}

}  // namespace wold::exporter
