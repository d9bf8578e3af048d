#pragma once

#include "core/image.h"
#include "shutter/motion_field.h"

namespace wold::shutter {

/// A picture as a shutter takes it that is open for a share of the time from one frame to the next:
/// 0 leaves it sharp, 0.5 is a film camera's half turn. The moment of the sharp picture is the
/// middle of that time, in which every place goes straight by its motion.
///
/// Each pixel is the mean of what stands there in moments so close to each other that nothing goes
/// farther than a pixel between two of them (128 of them at most). What stands there is looked for
/// in the sharp picture by following motions back, from the pixel's own and from the fastest one
/// nearby; the nearest of what is found hides the rest. Where what was behind something comes into
/// view, the sharp picture does not show it: the farthest of what is around stands for it, and the
/// picture's edge for what lies beyond it.
///
/// `sharp` is linear light, of the field's size. Throws std::invalid_argument when its size is
/// another one.
Image motion_blurred(const Image& sharp, const MotionField& field, double shutter);

}  // namespace wold::shutter
