#pragma once

#include "core/image.h"

namespace wold::compare {

/// How many pixels of the picture one degree of the viewer's sight holds. 67 is a screen of 0.7 m
/// with 3840 pixels across, seen from 0.7 m.
constexpr double usual_pixels_per_degree = 67.0;

/// How different two pictures of one size look to someone who flips between them, pixel by pixel
/// from 0 to 1, in one channel; the mean is the pictures' difference. Values are read as sRGB.
///
/// The LDR-FLIP of Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem and Fairchild 2020
/// (FLIP: A Difference Evaluator for Alternating Images, Proceedings of the ACM on Computer
/// Graphics and Interactive Techniques 3(2):15).
Image flip_map(const Image& got, const Image& want,
               double pixels_per_degree = usual_pixels_per_degree);

}  // namespace wold::compare
