#pragma once

#include <string>

#include "core/chart.h"
#include "grass/withering_curves.h"

namespace wold::cli {

/// The curves as a figure of six panels: pigments, water, shrinkage, stiffness, posture, spectra.
chart::Figure withering_figure(const std::string& scene_name, const grass::WitheringCurves& curves);

}  // namespace wold::cli
