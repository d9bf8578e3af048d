#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "compare/differences.h"
#include "core/image.h"

namespace wold::compare {

/// How two pictures of one shape differ; values as stored.
struct ImageMetrics : Differences {
  glm::ivec2 worst_px{0};          ///< column and row, from the top left, of max_error
  double psnr_db = 0.0;            ///< peak 1; infinite for equal pictures
  std::vector<double> mean_shift;  ///< mean of got - want per channel: brighter or darker
  double mean_abs_blurred8 = 0.0;  ///< mean_abs after means over 8 x 8 pixels: forgives small
                                   ///< shifts and grain, keeps wrong brightness
  double mean_delta_e = 0.0;       ///< CIE 1976 L*a*b* distance, values read as sRGB; 2.3 is just
                                   ///< noticeable (Mahy et al. 1994)
  double ssim = 1.0;               ///< structural similarity, see ssim.h; 1 for equal pictures
  double flip = 0.0;               ///< mean of the map; 0 for equal pictures
  Image flip_map;                  ///< see flip.h
};

/// Says how the shapes differ ("got 32 x 18 pixels with 3 channels, want ..."); empty when they
/// do not.
std::string shape_difference(const Image& got, const Image& want);

/// Throws std::invalid_argument when the shapes differ.
ImageMetrics compare_images(const Image& got, const Image& want, double soft);

/// |got - want| times `gain`, for the eye. Throws std::invalid_argument when the shapes differ.
Image difference_image(const Image& got, const Image& want, float gain);

/// A FLIP map in the colours of its paper, encoded sRGB: magma, from black for 0 to pale yellow
/// for 1.
Image flip_picture(const Image& flip_map);

/// The metrics that a person wants to see, with what the limits say of them.
std::vector<Measure> measures(const ImageMetrics& metrics, const Limits& limits);

}  // namespace wold::compare
