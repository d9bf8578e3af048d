#pragma once

#include <filesystem>
#include <memory>

#include "core/image.h"
#include "core/progress.h"
#include "phenology/film_season.h"
#include "scene/scene.h"

namespace wold::sketch {

/// Whether contact sheets have texts: the font of labels, DejaVu Sans, is installed.
bool has_labels();

/// A picture of a film without any renderer, in encoded sRGB: three of its frames, what is around
/// the camera, and grass as it withers. `season`: phenology::film_season() of the scene. `scratch`
/// is a folder for this call alone. Throws what PreviewFilm does, FileError and InterruptedError.
Image contact_sheet(const scene::Scene& scene, std::shared_ptr<const phenology::FilmSeason> season,
                    const std::filesystem::path& scratch, Progress& progress);

}  // namespace wold::sketch
