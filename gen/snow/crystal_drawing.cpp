#include "snow/crystal_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/elementary.h"
#include "core/random.h"
#include "snow/canvas.h"

/// Shapes are as Bentley and Humphreys photographed them (Snow crystals, 1931); their proportions
/// are ours.
namespace wold::snow {
namespace {

using std::numbers::pi;
constexpr double sixth_turn = pi / 3.0;
constexpr double reach = 0.9;  ///< leaves the border of the coarsest level transparent

/// Keyed numbers of one crystal.
class Draws {
 public:
  explicit Draws(std::uint64_t key) : key_(key) {}
  double between(double low, double high, std::string_view what, std::uint64_t index = 0) const {
    return low + (high - low) * random_uniform({key_, key_of("shape"), index, key_of(what)});
  }
  int whole(int low, int high, std::string_view what, std::uint64_t index = 0) const {
    return low + static_cast<int>(between(0.0, high + 1 - low, what, index));
  }
  std::uint64_t key(std::uint64_t index) const {
    return random_bits({key_, key_of("part"), index, 0});
  }

 private:
  std::uint64_t key_;
};

glm::dvec2 direction(double angle) { return {math::cos(angle), math::sin(angle)}; }

glm::dmat2 turn(double angle) {
  const glm::dvec2 x = direction(angle);
  return {x, {-x.y, x.x}};
}

std::vector<glm::dvec2> hexagon(double radius, const glm::dvec2& centre = glm::dvec2(0.0)) {
  std::vector<glm::dvec2> corners(6);
  for (int i = 0; i < 6; ++i)
    corners[static_cast<std::size_t>(i)] = centre + radius * direction(i * sixth_turn);
  return corners;
}

void outline(Canvas& canvas, const std::vector<glm::dvec2>& corners, double width, double opacity) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    canvas.stroke(corners[i], corners[(i + 1) % corners.size()], width, width, opacity);
}

/// One of a dendrite's twelve rows of side branches: of one arm, to one side.
struct BranchRow {
  double arm_angle;
  double arm_length;
  double side;  ///< 1 to the left, -1 to the right
  std::uint64_t index;
};

/// A side branch, parallel to the next arm, with smaller ones parallel to its own arm.
void draw_branch(Canvas& canvas, const Draws& draws, const BranchRow& row, double start,
                 double length, double width) {
  const glm::dvec2 along_arm = direction(row.arm_angle);
  const glm::dvec2 along = direction(row.arm_angle + row.side * sixth_turn);
  const glm::dvec2 foot = start * row.arm_length * along_arm;
  const glm::dvec2 tip = foot + length * along;
  canvas.stroke(foot, tip, 2.2 * width, 1.2 * width, 0.45);
  canvas.stroke(foot, tip, width, 0.45 * width, 0.9);
  const int twigs = static_cast<int>(length / draws.between(0.06, 0.11, "twigs"));
  for (int twig = 1; twig < twigs; ++twig) {
    const double fraction = static_cast<double>(twig) / twigs;
    const double twig_length = 0.42 * length * (1.0 - fraction) + 0.015;
    const glm::dvec2 at = glm::mix(foot, tip, fraction);
    canvas.stroke(at, at + twig_length * along_arm, 0.6 * width, 0.3 * width, 0.7);
    canvas.stroke(at,
                  at + 0.6 * twig_length * direction(row.arm_angle + 2.0 * row.side * sixth_turn),
                  0.6 * width, 0.3 * width, 0.7);
  }
}

/// Six arms grew in the same air, so that their branches agree, but for accidents.
void draw_dendrite(Canvas& canvas, const Draws& draws) {
  const int branches = draws.whole(6, 11, "branches");
  const double width = draws.between(0.036, 0.056, "width");
  const double first = draws.between(0.14, 0.3, "first");
  const double bushy = draws.between(0.6, 1.0, "bushy");
  const double core = draws.between(0.1, 0.24, "core");
  canvas.polygon(hexagon(core), 0.75);
  outline(canvas, hexagon(core), 0.02, 0.9);
  for (std::uint64_t arm = 0; arm < 6; ++arm) {
    const double angle = static_cast<double>(arm) * sixth_turn;
    const double length = draws.between(0.86, 0.94, "arm", arm);
    canvas.stroke({0.0, 0.0}, length * direction(angle), 2.8 * width, 1.2 * width, 0.5);
    canvas.stroke({0.0, 0.0}, length * direction(angle), 1.3 * width, 0.5 * width, 0.95);
    for (std::uint64_t side = 0; side < 2; ++side) {
      const BranchRow row = {angle, length, side == 0 ? 1.0 : -1.0, 2 * arm + side};
      for (int branch = 0; branch < branches; ++branch) {
        const auto which = static_cast<std::uint64_t>(branch);
        const std::uint64_t accident = 100 * (row.index + 1) + which;
        const double start = first + (0.97 - first) * (branch + 0.5) / branches;
        const double room = std::min(0.8 * start, 0.9 * (1.06 - start));
        const double agreed = room * bushy * draws.between(0.55, 1.0, "length", which);
        const double grown = agreed * draws.between(0.82, 1.08, "accident", accident);
        draw_branch(canvas, draws, row, start, grown, width * 0.8);
      }
    }
  }
}

/// A hexagon with a raised rim, ribs to its corners, rings of former rims, and sometimes sectors.
void draw_plate(Canvas& canvas, const Draws& draws) {
  const bool sectored = draws.between(0.0, 1.0, "sectored") < 0.5;
  const double radius = sectored ? draws.between(0.55, 0.7, "radius") : 0.9;
  canvas.polygon(hexagon(radius), 0.42);
  if (sectored) {
    const double tip = 0.93 - radius * 0.6;
    for (int i = 0; i < 6; ++i) {
      const auto lobe = hexagon(tip, radius * 0.6 * direction(i * sixth_turn));
      canvas.polygon(lobe, 0.42);
      outline(canvas, lobe, 0.03, 0.75);
      canvas.stroke({0.0, 0.0}, 0.9 * direction(i * sixth_turn), 0.05, 0.025, 0.8);
    }
  } else {
    outline(canvas, hexagon(radius), 0.06, 0.95);
    outline(canvas, hexagon(radius - 0.07), 0.025, 0.7);
  }
  const int rings = draws.whole(1, 3, "rings");
  for (int ring = 0; ring < rings; ++ring) {
    const double ring_radius =
        radius * draws.between(0.2, 0.85, "ring", static_cast<std::uint64_t>(ring));
    outline(canvas, hexagon(ring_radius), 0.03, 0.72);
    canvas.polygon(hexagon(0.6 * ring_radius), 0.47);
  }
  for (int i = 0; i < 6; ++i) {
    const glm::dvec2 rib = direction(i * sixth_turn);
    const glm::dvec2 next = direction((i + 1) * sixth_turn);
    constexpr std::uint64_t ridges = 5;
    for (std::uint64_t ridge = 0; ridge < ridges; ++ridge) {
      const double at = radius * draws.between(0.25, 0.9, "ridge", ridge);
      const double length = 0.3 * at * draws.between(0.3, 1.0, "ridge length", ridge);
      canvas.stroke(at * rib, at * rib + length * (next - rib), 0.02, 0.01, 0.6);
      canvas.stroke(at * next, at * next + length * (rib - next), 0.02, 0.01, 0.6);
    }
  }
  for (int i = 0; i < 6; ++i)
    canvas.stroke(0.1 * direction(i * sixth_turn), 0.95 * radius * direction(i * sixth_turn), 0.045,
                  0.02, 0.75);
}

/// A hexagonal prism from the side: three faces, hollow ends.
void draw_prism(Canvas& canvas, const Draws& draws, const glm::dvec2& centre, double angle,
                double half_length, double half_width) {
  const glm::dvec2 along = direction(angle);
  const glm::dvec2 across(-along.y, along.x);
  const auto at = [&](double x, double y) {
    return centre + x * half_length * along + y * half_width * across;
  };
  canvas.polygon({at(-1.0, -0.9), at(1.0, -0.9), at(1.0, 0.9), at(-1.0, 0.9)}, 0.6);
  const double edge = 0.035;
  for (const double y : {-1.0, -0.45, 0.45, 1.0})
    canvas.stroke(at(-0.98, y), at(0.98, y), edge, edge, std::abs(y) > 0.9 ? 0.95 : 0.75);
  const double depth = draws.between(0.25, 0.7, "hollow");
  for (const double end : {-1.0, 1.0}) {
    canvas.stroke(at(end, -0.85), at(end, 0.85), edge, edge, 0.9);
    canvas.stroke(at(end, -0.7), at(end * depth, 0.0), 0.025, 0.02, 0.8);
    canvas.stroke(at(end, 0.7), at(end * depth, 0.0), 0.025, 0.02, 0.8);
  }
}

/// A few needles that grew together.
void draw_needles(Canvas& canvas, const Draws& draws, double width) {
  const double angle = draws.between(0.0, pi, "angle");
  const int needles = draws.whole(3, 5, "count");
  for (int i = 0; i < needles; ++i) {
    const auto which = static_cast<std::uint64_t>(i);
    const glm::dvec2 along = draws.between(0.55, 0.85, "half", which) *
                             direction(angle + draws.between(-0.25, 0.25, "turned", which));
    const glm::dvec2 middle =
        draws.between(-0.15, 0.15, "aside", which) * direction(angle + pi / 2.0);
    const glm::dvec2 near_end = middle - 0.85 * along;
    const glm::dvec2 far_end = middle + 0.85 * along;
    canvas.stroke(middle - along, near_end, 0.2 * width, width, 0.7);
    canvas.stroke(near_end, far_end, width, width, 0.65);
    canvas.stroke(near_end, far_end, 0.3 * width, 0.3 * width, 0.9);
    canvas.stroke(far_end, middle + along, width, 0.2 * width, 0.7);
  }
}

/// A column, or needles.
void draw_column(Canvas& canvas, const Draws& draws) {
  if (draws.between(0.0, 1.0, "needles") < 0.4)
    draw_needles(canvas, draws, 0.16);
  else
    draw_prism(canvas, draws, {0.0, 0.0}, draws.between(0.0, pi, "angle"),
               draws.between(0.65, 0.85, "length"), draws.between(0.24, 0.36, "width"));
}

/// Part of an aggregate, caught in it at any tilt.
Placing caught(const Draws& draws, double size) {
  // Nearly evenly over radii, so that the middle is the densest.
  const double away = (0.88 - 0.94 * size) * math::pow(draws.between(0.0, 1.0, "away"), 0.8);
  const double tilt = draws.between(0.3, 1.0, "tilt");
  return {turn(draws.between(0.0, pi, "tilted")) * glm::dmat2(size, 0.0, 0.0, size * tilt) *
              turn(draws.between(0.0, pi, "turned")),
          away * direction(draws.between(0.0, 2.0 * pi, "where"))};
}

/// Splinters of broken branches, more of them in the middle.
void draw_splinters(Canvas& canvas, const Draws& draws) {
  constexpr std::uint64_t splinters = 120;
  for (std::uint64_t i = 0; i < splinters; ++i) {
    const double angle = draws.between(0.0, 2.0 * pi, "splinter angle", i);
    const double away = draws.between(0.0, 0.62, "splinter", i);
    const glm::dvec2 from = away * direction(angle);
    const double heading = draws.between(0.0, 2.0 * pi, "splinter heading", i);
    const double length = draws.between(0.05, 0.16, "splinter length", i);
    canvas.stroke(from, from + length * direction(heading), 0.03, 0.015, 0.55);
  }
}

/// Dendrites, for the most part, and needles.
void draw_aggregate(Canvas& canvas, const Draws& draws, int side_px) {
  const int parts = draws.whole(8, 12, "parts");
  for (int i = 0; i < parts; ++i) {
    const Draws own(draws.key(static_cast<std::uint64_t>(i)));
    Canvas body(side_px);
    body.place(caught(own, own.between(0.34, 0.6, "size")));
    if (own.between(0.0, 1.0, "kind") < 0.8)
      draw_dendrite(body, own);
    else
      draw_needles(body, own, 0.06);
    canvas.lay_over(body);
  }
  draw_splinters(canvas, draws);
}

/// 1 at 0, falling smoothly to 0 at 1.
double soft(double x) {
  const double left = std::clamp(1.0 - x, 0.0, 1.0);
  return left * left * (3.0 - 2.0 * left);
}

/// A smooth picture of an opacity on [-1, 1]^2, y up.
template <class Opacity>
Image smooth(int side_px, const Opacity& opacity) {
  Image image(side_px, side_px, 1);
  for (int y = 1; y < side_px - 1; ++y)
    for (int x = 1; x < side_px - 1; ++x)
      *image.pixel(x, y) = static_cast<float>(
          opacity(2.0 * (x + 0.5) / side_px - 1.0, 1.0 - 2.0 * (y + 0.5) / side_px));
  return image;
}

}  // namespace

Image drawn_crystal(Crystal crystal, int side_px, std::uint64_t key) {
  const Draws draws(key);
  Canvas canvas(side_px);
  canvas.place({reach * turn(draws.between(0.0, sixth_turn, "turned")), {0.0, 0.0}});
  switch (crystal) {
    case Crystal::plate:
      draw_plate(canvas, draws);
      break;
    case Crystal::column:
      draw_column(canvas, draws);
      break;
    case Crystal::dendrite:
      draw_dendrite(canvas, draws);
      break;
    case Crystal::aggregate:
      draw_aggregate(canvas, draws, side_px);
      break;
  }
  return canvas.picture();
}

Image drawn_disc(int side_px) {
  return smooth(side_px, [](double x, double y) { return soft(math::hypot(x, y) / 0.95); });
}

Image drawn_streak(int side_px) {
  return smooth(side_px, [](double x, double y) {
    constexpr double end = 0.7;
    const double beyond = std::max(0.0, std::abs(y) - end) / (0.95 - end);
    return soft(std::abs(x) / 0.95) * soft(beyond);
  });
}

}  // namespace wold::snow
