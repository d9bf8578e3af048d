#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/curve.h"
#include "grass/geometry/axis.h"
#include "grass/geometry/blade.h"
#include "grass/mechanics/blade_motion.h"
#include "grass/mechanics/flower_model.h"
#include "grass/mechanics/frames.h"
#include "grass/mechanics/mechanics.h"
#include "grass/optics/leaf_colour.h"
#include "grass/texel/points.h"
#include "scene/scene.h"

namespace wold::grass {

/// The physical-biological model of section 3 that drives the points: curves and colours of one
/// scene.
class AgeingModel {
 public:
  /// Loads the curves and pigments the scene names. Throws FileError or InputError. `flower` is
  /// what its blades bear, if they are stalks of flowers.
  AgeingModel(const scene::Physiology& ageing, double fresh_specular,
              const scene::Flower& flower = {});

  /// The blade's own weathering degree when the meadow's is `weathering`: from its head start to 1,
  /// monotone, ahead or behind by its onset in between.
  static double blade_age(const Blade& blade, double weathering);
  /// `snow`: fraction of the snow it can carry that lies on it, 0 to 1. Where Algorithm 1 moves
  /// blades it steps there from the first age on: 0.2 ms.
  BladePose pose(const Blade& blade, double age, double snow = 0.0) const;
  /// The same where Algorithm 1 has moved the blade to that state of this age.
  BladePose pose(const Blade& blade, const VeinState& state, double age, double snow) const;
  /// Whether Algorithm 1 moves blades (ageing.motion), not a closed form.
  bool moves_points() const { return ageing_.motion == scene::AgeingMotion::points; }
  BladeMotion motion(const Blade& blade) const { return {blade, ageing_, water_}; }
  BladeHistory history(const Blade& blade) const { return {blade, ageing_, water_}; }
  /// What a blade of that age lacks of its water, and the most that it has lacked until then.
  WaterLoss water_loss(double age) const;
  /// Leaves die from the tip down: age at `along`, 0 at the root to 1 at the tip.
  static double local_age(double age, double along);
  /// Albedo of a blade of that age at `along`.
  glm::vec3 albedo(const Blade& blade, double age, double along) const;
  /// That albedo as light sent back and let through, in the proportion that the leaf's own spectrum
  /// has there.
  LeafShade shade(const Blade& blade, double age, double along) const;
  /// Specular coefficient. Wax and water make leaves shine; half of it goes with the water. Petals
  /// are dull.
  float specular(const Blade& blade, double age) const;

 private:
  /// Of a place that is not brighter or darker than its like.
  LeafShade usual_shade(const Blade& blade, double age, double along) const;

  scene::Physiology ageing_;
  double fresh_specular_;
  Curve water_;
  Curve heaviest_load_;  ///< over the blade's age
  LeafColour colour_;
  std::optional<FlowerModel> flower_;
};

/// Algorithm 1, point dynamics: moves the points of a patch through the weathering degrees.
class PointDynamics {
 public:
  /// Points nearer than `merge_distance_m` to a neighbour on their blade become one; the other one
  /// stays in its place without area.
  PointDynamics(const AgeingModel& model, std::vector<Blade> blades, Points points,
                double merge_distance_m);

  /// One step: forces, motion, frame, material, merging. `weathering` in [0, 1], not before the
  /// last one. The state depends on `weathering` alone, not on the steps that led there, but for
  /// merged points, which stay merged, and, where Algorithm 1 moves blades, for the points' frames,
  /// which follow their ways (frames.h). Blades are free of snow afterwards.
  void advance_to(double weathering);

  /// The blades as they stand at the last step's weathering under snow: `snow` in [0, 1] is the
  /// fraction of what they can carry. It leaves no trace: under 0 all is what advance_to() left but
  /// for points it merged, whose places are those of one of the two.
  void support_load(double snow);

  const Points& points() const { return points_; }
  const std::vector<Blade>& blades() const { return blades_; }
  /// Poses of the blades at the last step.
  const std::vector<BladePose>& poses() const { return poses_; }

 private:
  /// A blade at this step, sampled at equal distances from root to tip: its thousand points are
  /// looked up on it. 64 steps keep the axis to a ten-thousandth of its length.
  struct WitheredBlade {
    static constexpr int steps = 64;
    std::array<AxisPoint, steps + 1> axis;
    std::array<glm::vec3, steps + 1> albedo;
    std::array<glm::vec3, steps + 1> transmittance;
    float specular = 0.0F;
  };
  struct Between;

  /// All of a step but the merging.
  void stand(std::size_t blade, double weathering, double snow);
  WitheredBlade apply_forces(std::size_t blade, double weathering, double snow);
  void move(std::size_t blade, const WitheredBlade& now);
  /// Frames from the axis.
  void update_frames(std::size_t blade);
  /// Frames by figure 6a: from those of the step before, at first those at rest.
  void rest_frames(std::size_t blade);
  void follow_frames(std::size_t blade);
  void keep_frames(std::size_t blade);
  BladePose pose(std::size_t blade, double age, double snow);
  void update_material(std::size_t blade, const WitheredBlade& now);

  const AgeingModel& model_;
  std::vector<Blade> blades_;
  Points points_;
  float merge_distance_m_;
  double weathering_ = 0.0;
  std::vector<BladePose> poses_;
  // Where Algorithm 1 moves blades, else empty.
  std::vector<BladeMotion> motions_;
  std::vector<PointFrame> frames_before_;  ///< of the points at the step before
  std::vector<PointFrame> frames_;         ///< at this step, without snow
};

}  // namespace wold::grass
