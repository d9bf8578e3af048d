#include "grass/ageing/withering_curves.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/angle.h"
#include "core/colour.h"
#include "core/curve.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "grass/ageing/ageing_curves.h"
#include "grass/geometry/axis.h"
#include "grass/geometry/blade.h"
#include "grass/mechanics/dynamics.h"
#include "grass/optics/leaf_colour.h"
#include "grass/optics/leaf_optics.h"
#include "grass/optics/pigments.h"

namespace wold::grass {
namespace {

constexpr std::size_t steps = 100;

double degree_of(std::size_t step) { return static_cast<double>(step) / steps; }

std::vector<ShippedCurve> shipped_curves(CurveKind kind, const scene::CurveChoice& own) {
  std::vector<ShippedCurve> curves;
  for (const std::string& name : curve_names(kind)) {
    const Curve curve = load_curve(kind, {name, {}});
    ShippedCurve shipped{name, own.points.empty() && own.name == name, {}};
    for (std::size_t i = 0; i <= steps; ++i) shipped.values.push_back(curve(degree_of(i)));
    curves.push_back(std::move(shipped));
  }
  return curves;
}

/// Fraction of the fresh leaf's carotenoids; [TVT]'s model keeps them all (section 3.2).
double carotenoid_fraction(const scene::Physiology& ageing, double water) {
  if (ageing.colour == scene::ColourModel::paper) return 1.0;
  scene::Physiology unit = ageing;
  unit.carotenoid_ug_cm2 = 1.0;
  return withered_leaf(unit, 0.0, water).carotenoid_ug_cm2;
}

/// Seen from the root, as in [TVT]'s turning of the points about it.
double tip_angle_deg(const Blade& blade, const BladePose& pose) {
  const glm::vec2 tip = BladeAxis(blade, pose).at(blade.length_m * pose.length_scale).position_m;
  return degrees(math::atan2(double{tip.x}, double{tip.y}));
}

glm::dvec3 encoded(const glm::vec3& linear) {
  return {srgb_encoded(linear.r), srgb_encoded(linear.g), srgb_encoded(linear.b)};
}

/// The scene's models, each loaded once.
class Withering {
 public:
  explicit Withering(const scene::MeadowPart& meadow)
      : ageing_(meadow.ageing),
        blade_(mean_blade(meadow.grass, meadow.ageing)),
        chlorophyll_(load_curve(CurveKind::chlorophyll, ageing_.chlorophyll)),
        water_(load_curve(CurveKind::water, ageing_.water)),
        model_(ageing_, meadow.grass.specular),
        optics_(load_leaf_spectra()),
        colour_(ageing_) {}

  WitheredState state(double weathering) const {
    WitheredState state;
    state.weathering = weathering;
    state.chlorophyll = chlorophyll_(weathering);
    state.water = water_(weathering);
    state.carotenoid = carotenoid_fraction(ageing_, state.water);
    state.tissue = tissue_state(ageing_, 1.0 - state.water);
    state.tip_angle_deg = tip_angle_deg(blade_, model_.pose(blade_, weathering));
    state.srgb = encoded(colour_(weathering).reflectance);
    state.reflectance =
        withered_spectrum(ageing_, optics_, state.chlorophyll, state.water).reflectance;
    return state;
  }

  const std::vector<double>& wavelength_nm() const { return optics_.spectra().wavelength_nm; }

 private:
  const scene::Physiology& ageing_;
  Blade blade_;
  Curve chlorophyll_;
  Curve water_;
  AgeingModel model_;
  LeafOptics optics_;
  LeafColour colour_;
};

}  // namespace

WitheringCurves withering_curves(const scene::MeadowPart& meadow) {
  const Withering withering(meadow);
  WitheringCurves curves;
  curves.wavelength_nm = withering.wavelength_nm();
  curves.chlorophyll = shipped_curves(CurveKind::chlorophyll, meadow.ageing.chlorophyll);
  curves.water = shipped_curves(CurveKind::water, meadow.ageing.water);
  curves.states.resize(steps + 1);
  parallel_for(curves.states.size(),
               [&](std::size_t i) { curves.states[i] = withering.state(degree_of(i)); });
  return curves;
}

}  // namespace wold::grass
