#include "golden.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/image.h"

namespace wold::test {
namespace {

float difference(const Image& got, const Image& want, int x, int y) {
  float largest = 0.0F;
  for (int channel = 0; channel < want.channels; ++channel)
    largest = std::max(largest, std::abs(got.pixel(x, y)[channel] - want.pixel(x, y)[channel]));
  return largest;
}

/// Whether a pixel looks altogether different and all around it look alike.
bool is_speck(const Image& got, const Image& want, int x, int y) {
  constexpr float other = 0.3F, alike = 0.1F;
  if (difference(got, want, x, y) <= other) return false;
  for (int j = std::max(y - 1, 0); j <= std::min(y + 1, want.height - 1); ++j)
    for (int i = std::max(x - 1, 0); i <= std::min(x + 1, want.width - 1); ++i)
      if ((i != x || j != y) && difference(got, want, i, j) > alike) return false;
  return true;
}

/// The picture without up to three specks. Cycles passes over a face of a volume here and there: in
/// a pixel of 100,000 or so, and on a processor that rounds its approximate reciprocals otherwise
/// in another one.
Image without_specks(Image got, const Image& want) {
  constexpr std::size_t most = 3;
  if (got.width != want.width || got.height != want.height || got.channels != want.channels)
    return got;
  std::vector<std::pair<int, int>> specks;
  for (int y = 0; y < want.height; ++y)
    for (int x = 0; x < want.width; ++x)
      if (is_speck(got, want, x, y)) specks.emplace_back(x, y);
  if (specks.size() > most) return got;
  for (const auto& [x, y] : specks) std::copy_n(want.pixel(x, y), want.channels, got.pixel(x, y));
  return got;
}

}  // namespace

void GoldenPictures::expect_golden(const fs::path& picture, const std::string& name) const {
  const fs::path want = fs::path(WOLD_TESTS_DIR) / "golden" / (name + ".png");
  const fs::path evidence = fs::path(WOLD_BUILD_DIR) / "golden";
  const fs::path kept = evidence / "got" / (name + ".png");
  const fs::path report = evidence / name;
  fs::remove_all(report);
  fs::create_directories(kept.parent_path());
  fs::copy_file(picture, kept, fs::copy_options::overwrite_existing);
  fs::path judged = kept;
  if (fs::exists(want)) {
    judged = folder_ / "judged.png";
    write_image(judged, without_specks(read_image(kept), read_image(want)), PixelFormat::uint8);
  }
  const Result result = wold(fmt::format("compare '{}' '{}' --report '{}'", judged.string(),
                                         want.string(), report.string()));
  EXPECT_EQ(result.code, 0) << name << ".png does not look like the picture in tests/golden.\n"
                            << result.err << "If it should look so: tests/run.sh --update-golden";
  if (result.code != 0) return;
  fs::remove_all(report);
  fs::remove(kept);
}

}  // namespace wold::test
