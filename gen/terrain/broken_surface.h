#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

namespace wold::terrain {

/// One of the blocks that fill the plane or space: of each place the nearest point of those that
/// lie one in each unit cell (cellular noise, Worley 1996). Lengths are in cells.
template <int dims>
struct Block {
  std::uint64_t bits = 0;                ///< keyed random bits of its own
  glm::vec<dims, double> middle_away{};  ///< from the place to the block's point
  double joint = 0.0;                    ///< from the place to the next joint
};

/// The block about a place, of the field that `key` names. dims: 2 or 3.
template <int dims>
Block<dims> block_at(const glm::vec<dims, double>& at, std::uint64_t key);

/// What a rough surface that faces `up` sends back of sun and sky, over what it would send back of
/// light that met it square: in clear air four fifths of the light are the sun's, of a low sun
/// less, of one that has set nothing. World space; `to_sun` is a unit vector.
double light_on(const glm::dvec3& up, const glm::dvec3& to_sun);

/// Distance in metres, along the fall line, between neighbouring places of a map with steps of
/// `step_m` metres, on ground that faces `up`. `up` is a unit vector, not below the horizon. Ground
/// steeper than 78 degrees counts as five steps. Finer detail would show as streaks up the slope.
double slope_step_m(const glm::dvec3& up, double step_m);

/// One size of the blocks that a surface is broken into.
struct BlockSize {
  double block_m;          ///< width, metres
  double tilt;             ///< how far faces turn from the surface's, as tangents
  double dark;             ///< fraction of the light that joints take
  double own_shade = 0.0;  ///< how far a block's own shade is off the mean at most, a fraction
  double dome = 0.0;       ///< how far a face turns outwards at a block's width from its middle
};

/// A surface that is broken into blocks, these into smaller ones and so on. Each block has a face
/// of its own that turns to or away from the light, and dark joints about it.
template <int dims>
class BrokenSurface {
 public:
  /// As a map with that step, > 0, shows it: blocks finer than slope_step_m() are evened out. The
  /// sizes, from the largest to the smallest, have to outlive it.
  BrokenSurface(std::span<const BlockSize> sizes, std::uint64_t key, double step_m);

  /// Whether a map shows any of it, on level ground.
  bool is_shown() const;

  /// The way that the face at a place turns, of no unit length: its mean is `up`, the unbroken
  /// surface's unit normal. Place in metres.
  glm::dvec3 face(const glm::vec<dims, double>& place_m, const glm::dvec3& up) const;
  /// Standard deviation of a component of face() that the map does not show on ground that faces
  /// `up`, a unit vector; a tangent.
  double hidden_tilt(const glm::dvec3& up) const;

  /// How much brighter than the mean of all faces a place is, > 0; 1 on the mean but for domes.
  /// What is below 0.3 and above 1.8 times the mean light is cut off. `up` is the unbroken
  /// surface's unit normal, `to_sun` a unit vector; place in metres.
  double shade(const glm::vec<dims, double>& place_m, const glm::dvec3& up,
               const glm::dvec3& to_sun) const;

 private:
  struct Broken {
    glm::dvec3 face;  ///< face()
    double open;      ///< what joints and the block's own shade leave, over the mean
    double tilt;      ///< standard deviation of a component of the face
  };
  Broken broken(const glm::vec<dims, double>& place_m, const glm::dvec3& up) const;

  std::span<const BlockSize> sizes_;
  std::uint64_t key_;
  double step_m_;
};

}  // namespace wold::terrain
