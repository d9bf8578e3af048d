#pragma once

#include <string>

#include "grass/ageing/withering_curves.h"
#include "report/chart.h"

namespace wold::report {

/// The curves as a figure of six panels: pigments, water, shrinkage, stiffness, posture, spectra.
chart::Figure withering_figure(const std::string& scene_name, const grass::WitheringCurves& curves);

}  // namespace wold::report
