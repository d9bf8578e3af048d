#include "grass/geometry/blade_tubes.h"

#include <gtest/gtest.h>

#include "grass/geometry/point_tubes.h"
#include "grass/optics/blade_picture.h"
#include "grass/texel/coverage.h"
#include "grass/texel/voxelise.h"
#include "small_meadow.h"

namespace wold::grass {
namespace {

const MeadowModel& meadow() {
  static const MeadowModel shared(test::small_scene());
  return shared;
}

const AgeingModel& model() { return meadow().of_species(0); }

BladePatch patch_of(std::vector<Blade> blades, double weathering = 0.0) {
  BladePatch patch{test::small_scene().grass.patch_m, std::move(blades), {}, {}};
  for (const Blade& blade : patch.blades) {
    patch.ages.push_back(AgeingModel::blade_age(blade, weathering));
    patch.poses.push_back(model().pose(blade, patch.ages.back()));
  }
  return patch;
}

double surface_m2(const Tubes& tubes) {
  const std::vector<std::uint32_t> quads = quad_corners(tubes);
  double sum = 0.0;
  for (std::size_t face = 0; face < quads.size(); face += 4)
    sum += double{glm::length(
               glm::cross(tubes.vertices_m[quads[face + 2]] - tubes.vertices_m[quads[face]],
                          tubes.vertices_m[quads[face + 3]] - tubes.vertices_m[quads[face + 1]]))} /
           2.0;
  return sum;
}

// A convex body shows a quarter of its surface on average (Cauchy): the tubes' is the cones' of the
// texel.
TEST(BladeTubes, ShowAsMuchAsTheCones) {
  const BladePatch patch = patch_of(test::small_blades());
  double cones = 0.0;
  for (const Blade& blade : patch.blades) cones += cone_area_m2(blade);
  const Tubes tubes = blade_tubes(patch, meadow(), test::slanting_light(), {24.0F, 0.006});
  EXPECT_EQ(tubes.count(), patch.blades.size());
  EXPECT_NEAR(surface_m2(tubes) / 4.0 / cones, 1.0, 0.01);
}

// Nothing hides a blade that stands alone: its radiance is the full light's, and a little of what
// it scatters itself.
TEST(BladeTubes, ABladeAloneIsInFullLight) {
  const BladePatch patch = patch_of({test::straight_blade()});
  const Lighting lighting = test::slanting_light();
  const Tubes tubes = blade_tubes(patch, meadow(), lighting, {24.0F, 0.006});
  const glm::vec3 tangent(patch.blades[0].heading * std::sin(patch.blades[0].lean),
                          std::cos(patch.blades[0].lean));
  DiffuseLight sky;
  for (const SkyDirection& part : sky_directions(lighting))
    sky.add(glm::vec3(part.direction), part.irradiance());
  const LeafShade shade = model().shade(patch.blades[0], patch.ages[0], 0.0);
  const Fibre root{tangent, shade.albedo, shade.transmittance,
                   model().specular(patch.blades[0], patch.ages[0])};
  const glm::vec3 wanted = source_radiance(root, TurnedLight(lighting, 0), 1.0F, sky, 24.0F);
  EXPECT_LT(glm::distance(tubes.radiance.front(), wanted), 0.02F * glm::length(wanted));
}

// Two walls of blades, one behind the other as the sun sees them: the one behind has next to
// nothing but what the one in front scatters up to the height that the shadow's edge reaches, and
// lit above.
TEST(BladeTubes, TheFrontOneShadowsTheOneBehind) {
  Blade front = test::straight_blade();
  front.lean = 0.0F;
  front.root_m = {0.15F, 0.125F};
  front.radius_m = 0.02F;
  Blade behind = front;
  behind.root_m = {0.10F, 0.125F};
  behind.radius_m = 0.001F;
  Lighting lighting = test::slanting_light();
  lighting.sun_direction = direction_at(45.0 * test::degree, 0.0);
  for (glm::vec3& radiance : lighting.sky_radiance) radiance = glm::vec3(0.0F);
  const Tubes tubes = blade_tubes(patch_of({front, behind}), meadow(), lighting, {24.0F, 0.006});
  // The sun comes down at 45 degrees from 5 cm away: the front's tip at 18 cm shades up to 13 cm,
  // less where the tip is narrow.
  for (int ring = 0; ring < tubes.rings; ++ring) {
    const double height_m = 0.18 * ring / (tubes.rings - 1);
    const auto at = static_cast<std::size_t>(tubes.rings + ring);
    if (height_m < 0.11) {
      EXPECT_LT(tubes.radiance[at].g, 3e-4F) << height_m;
    }
    if (height_m > 0.14 && ring + 1 < tubes.rings) {
      EXPECT_GT(tubes.radiance[at].g, 1e-3F) << height_m;
    }
  }
  EXPECT_GT(tubes.radiance[0].g, 1e-3F);
}

TEST(BladePicture, CoversWhatTheTransmittanceLeavesOut) {
  const BladePatch patch = patch_of(test::small_blades(), 0.5);
  for (const double elevation : {15.0, 45.0, 90.0}) {
    const glm::dvec3 direction = direction_at(elevation * test::degree, 0.3);
    EXPECT_NEAR(BladePicture(patch, direction, 512).coverage(),
                1.0 - blade_transmittance(patch.blades, patch.poses, patch.patch_m, {direction}),
                0.01);
  }
}

// The points show the area they stand for, whatever was merged, and lie on their blades.
TEST(PointTubes, ShowTheAreaOfTheirPoints) {
  const std::vector<Blade> blades = test::small_blades();
  std::vector<PointDynamics> samples;
  samples.emplace_back(model(), blades, sample_points(blades, test::small_shape(), 4.0, 1), 1e-4);
  samples.front().advance_to(0.4);
  double area_m2 = 0.0;
  for (const float area : samples.front().points().area_m2) area_m2 += double{area};
  const Tubes tubes =
      point_tubes(patch_of(blades, 0.4), samples, test::slanting_light(), {24.0F, 0.006}, 0.004);
  EXPECT_NEAR(surface_m2(tubes) / 4.0 / area_m2, 1.0, 1e-4);
  EXPECT_GT(tubes.count(), 10 * blades.size());
}

}  // namespace
}  // namespace wold::grass
