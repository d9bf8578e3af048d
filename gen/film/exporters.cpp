#include "film/exporters.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "blender/entry.h"
#include "mitsuba/entry.h"
#include "povray/entry.h"
#include "scene/calendar.h"
#include "usd/entry.h"

namespace wold::film {

exporter::Exporters exporters() {
  static const std::array table = {
      &blender::entry(),
      &povray::entry(),
      &mitsuba::entry(),
      &usd::entry(),
  };
  return table;
}

std::vector<const exporter::Exporter*> wanted_exporters(const scene::Scene& scene) {
  std::vector<const exporter::Exporter*> wanted;
  const auto is_wanted = [&](const exporter::Exporter* one) {
    return std::ranges::count(scene.render.renderers, one->name) > 0;
  };
  std::ranges::copy_if(exporters(), std::back_inserter(wanted), is_wanted);
  return wanted;
}

landscape::Needs needs_of(exporter::Exporters wanted) {
  landscape::Needs needs = exporter::needs_of_all(exporters());
  needs.materials = exporter::needs_of_all(wanted).materials;
  return needs;
}

exporter::FilmSettings film_settings(const scene::Scene& scene) {
  exporter::FilmSettings film;
  for (const double weathering : scene.ageing.frames) {
    const int frame = static_cast<int>(film.frames.size()) + 1;
    film.frames.push_back({frame, weathering, scene::time_s(scene, frame)});
  }
  film.size_px = {scene.render.size_px[0], scene.render.size_px[1]};
  film.samples = scene.render.samples;
  film.density_bits = scene.render.df3_bits;
  return film;
}

}  // namespace wold::film
