#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace wold::compare {

/// What still counts as the same. All are fractions of the full range: stored sRGB values in [0, 1]
/// for pictures, integer / maximum for df3, value / largest wanted magnitude for grids. Reaching a
/// limit is allowed, going over it is not. The defaults are meant for the same picture made on
/// another machine: rounding may move a value by some steps of 8 bit anywhere (soft), and where one
/// of four samples of a pixel falls on the other side of an edge that pixel moves by a quarter.
struct Limits {
  double rmse = 0.005;
  double soft = 0.02;              ///< 5 steps of 8 bit
  double allowed_fraction = 0.01;  ///< of samples (pixels, voxels) over `soft`
  double hard = 0.3;               ///< no value may differ more
  double flip = 0.02;              ///< mean FLIP of pictures
  double ssim = 0.98;              ///< the least structural similarity of pictures
};

/// One number of a comparison and the range that the limits leave it.
struct Measure {
  std::string name;
  double value = 0.0;
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();

  /// Reaching a limit is allowed, being no number is not.
  bool is_good() const { return min <= value && value <= max; }
};

/// How far two equally long lists of values are apart. A sample is a pixel or a voxel.
struct Differences {
  double mean_abs = 0.0;
  double rmse = 0.0;
  double max_error = 0.0;
  double fraction_over_soft = 0.0;  ///< of samples with a value that differs by more than `soft`
  std::size_t non_finite = 0;       ///< values that are no finite number in either list
};

/// Takes two lists value by value and sums up how they differ.
class DifferenceSum {
 public:
  /// Differences are divided by `range`, a positive number, before they meet `soft`.
  explicit DifferenceSum(double soft, double range = 1.0) : soft_(soft), range_(range) {}

  void add(double got, double want);
  /// The values since the last call were one sample.
  void end_sample();

  Differences result() const;

 private:
  double soft_;
  double range_;
  Differences sums_;
  std::size_t values_ = 0;
  std::size_t samples_ = 0;
  std::size_t samples_over_ = 0;
  bool is_over_ = false;
};

/// The differences as the limits judge them.
std::vector<Measure> measures(const Differences& differences, const Limits& limits);

/// One sentence for every measure that is out of its range; empty when the two are the same.
std::vector<std::string> exceeded(const std::vector<Measure>& measures);

}  // namespace wold::compare
