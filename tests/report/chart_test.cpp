#include "report/chart.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <regex>
#include <stdexcept>

#include "core/table.h"

namespace wold::report::chart {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ChartAxis, TicksAreRoundNumbersThatEncloseTheValues) {
  EXPECT_THAT(tick_labels(linear_axis("", 0.0, 0.3152)),
              ElementsAre("0.0", "0.1", "0.2", "0.3", "0.4"));
  EXPECT_THAT(tick_labels(linear_axis("", 0.0, 1.0)),
              ElementsAre("0.0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(tick_labels(linear_axis("", -3.0, 17.0)),
              ElementsAre("-5", "0", "5", "10", "15", "20"));
  EXPECT_THAT(tick_labels(linear_axis("", 0.0, 1.0, 0.25)),
              ElementsAre("0.00", "0.25", "0.50", "0.75", "1.00"));
  EXPECT_THAT(tick_labels(linear_axis("", 2e-5, 3e-5)), testing::Contains("0.000020"));
  EXPECT_THAT(tick_labels(logarithmic_axis("", 5.0, 1430.0)),
              ElementsAre("1", "10", "100", "1000", "10000"));
  for (const double max : {1e-9, 0.07, 0.99, 1.0, 3.7, 42.0, 8e12}) {
    const Axis axis = linear_axis("", 0.0, max);
    EXPECT_TRUE(is_on(axis, max)) << max;
    EXPECT_GE(axis.ticks.size(), 3u) << max;
    EXPECT_LE(axis.ticks.size(), 8u) << max;
  }
}

TEST(ChartAxis, AConstantHasAnAxisToo) {
  EXPECT_TRUE(is_on(linear_axis("", 0.0, 0.0), 0.0));
  EXPECT_TRUE(is_on(logarithmic_axis("", 10.0, 10.0), 10.0));
}

TEST(ChartAxis, TicksEndWhereNeighbouringNumbersAreMoreThanAStepApart) {
  EXPECT_EQ(linear_axis("", 1e17, 1e17 + 64.0, 2.0).ticks.size(), 33u);
}

TEST(ChartAxis, LogarithmicPositionsAreEvenInDecades) {
  const Axis axis = logarithmic_axis("", 1.0, 1000.0);
  EXPECT_NEAR(axis_position(axis, 10.0), 1.0 / 3.0, 1e-12);
  EXPECT_NEAR(axis_position(axis, std::sqrt(1000.0)), 0.5, 1e-12);
  EXPECT_FALSE(is_on(axis, 0.0));
  EXPECT_FALSE(is_on(axis, -1.0));
}

TEST(ChartAxis, RefusesBoundsThatAreNone) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(linear_axis("", 1.0, 0.0), std::invalid_argument);
  EXPECT_THROW(linear_axis("", 0.0, nan), std::invalid_argument);
  EXPECT_THROW(linear_axis("", 0.0, 1.0, -1.0), std::invalid_argument);
  EXPECT_THROW(logarithmic_axis("", 0.0, 1.0), std::invalid_argument);
}

/// Panels of different legends and labels, some too long for one row.
Figure crowded_figure() {
  Panel many{"Many", linear_axis("time (d)", 0.0, 365.0), linear_axis("a (m)", -0.02, 0.013), {}};
  for (int i = 0; i < 9; ++i)
    many.lines.push_back({"measured in the year " + std::to_string(1993 + i),
                          {{0.0, 0.0}, {365.0, 0.001 * i}},
                          {.colour = "#0072b2"}});
  Panel few{"Few <&> \"quoted\"",
            linear_axis("time (d)", 0.0, 365.0),
            logarithmic_axis("b (Pa)", 1.0, 99999.0),
            {{"one", {{1.5, 10.0}}, {}, KeyShape::swatch}},
            "legend:"};
  return {"A title", "A subtitle", {many, few, few, many, few}, 2};
}

struct Box {
  double left, top, right, bottom;
  std::string text;
};

double number_in(const std::string& element, const std::string& attribute) {
  std::smatch found;
  const std::regex pattern(" " + attribute + "=\"([-0-9.]+)\"");
  return std::regex_search(element, found, pattern) ? std::stod(found[1]) : 0.0;
}

/// Room that a text takes: words and numbers measured in Liberation Sans need at most 0.53 of the
/// size per letter.
Box box_of(const std::string& element, const std::string& text) {
  const double size = number_in(element, "font-size");
  const double width = 0.53 * size * static_cast<double>(text.size());
  const double x = number_in(element, "x");
  const double y = number_in(element, "y");
  const double before = element.find("\"middle\"") != std::string::npos ? 0.5
                        : element.find("\"end\"") != std::string::npos  ? 1.0
                                                                        : 0.0;
  if (element.find("rotate(-90") != std::string::npos)
    return {x - 0.75 * size, y - (1.0 - before) * width, x + 0.2 * size, y + before * width, text};
  return {x - before * width, y - 0.75 * size, x + (1.0 - before) * width, y + 0.2 * size, text};
}

std::vector<Box> text_boxes(const std::string& drawing) {
  const std::regex pattern("<text([^>]*)>([^<]*)</text>");
  std::vector<Box> boxes;
  for (std::sregex_iterator i(drawing.begin(), drawing.end(), pattern), end; i != end; ++i)
    boxes.push_back(box_of((*i)[1], (*i)[2]));
  return boxes;
}

TEST(Chart, NoTextOverlapsAnotherOrLeavesThePaper) {
  const std::string drawing = svg(crowded_figure());
  const double width = number_in(drawing, "width");
  const double height = number_in(drawing, "height");
  const std::vector<Box> boxes = text_boxes(drawing);
  ASSERT_GT(boxes.size(), 5u * 15u);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Box& a = boxes[i];
    EXPECT_TRUE(a.left >= 0.0 && a.top >= 0.0 && a.right <= width && a.bottom <= height) << a.text;
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const Box& b = boxes[j];
      EXPECT_FALSE(a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom)
          << a.text << " and " << b.text;
    }
  }
}

/// Names of the elements still open after reading the text; a wrong end leaves an "!".
std::vector<std::string> open_elements(const std::string& xml) {
  const std::regex tag("<(/?)([a-z]+)((?: [a-zA-Z0-9:-]+=\"[^\"<&]*\")*)(/?)>");
  std::vector<std::string> open;
  for (std::sregex_iterator i(xml.begin(), xml.end(), tag), end; i != end; ++i) {
    const bool closes = (*i)[1].length() > 0;
    if (closes && (open.empty() || open.back() != (*i)[2])) return {"!" + (*i)[2].str()};
    if (closes) open.pop_back();
    if (!closes && (*i)[4].length() == 0) open.push_back((*i)[2]);
  }
  return open;
}

TEST(Chart, IsWellFormedAndEscapesItsTexts) {
  const std::string drawing = svg(crowded_figure());
  EXPECT_THAT(drawing, testing::StartsWith("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "));
  EXPECT_THAT(drawing, testing::EndsWith("</svg>\n"));
  EXPECT_THAT(open_elements(drawing), testing::IsEmpty());
  const auto tags = std::count(drawing.begin(), drawing.end(), '<');
  EXPECT_EQ(tags, std::count(drawing.begin(), drawing.end(), '>'));
  EXPECT_THAT(drawing, HasSubstr(">(b) Few &lt;&amp;&gt; &quot;quoted&quot;</text>"));
}

TEST(Chart, PutsPointsWhereTheAxesSay) {
  Figure figure;
  figure.plot_px = {200.0, 100.0};
  figure.panels = {{"P",
                    linear_axis("x", 0.0, 10.0),
                    logarithmic_axis("y", 1.0, 100.0),
                    {{"l", {{0.0, 1.0}, {5.0, 10.0}, {10.0, 100.0}}, {}}}}};
  const std::string drawing = svg(figure);
  std::smatch found;
  ASSERT_TRUE(std::regex_search(
      drawing, found,
      std::regex("points=\"([0-9.]+),([0-9.]+) ([0-9.]+),([0-9.]+) ([0-9.]+),([0-9.]+)\"")));
  const auto at = [&](int i) { return std::stod(found[static_cast<std::size_t>(i)]); };
  EXPECT_NEAR(at(3) - at(1), 100.0, 0.02);
  EXPECT_NEAR(at(5) - at(1), 200.0, 0.02);
  EXPECT_NEAR(at(2) - at(4), 50.0, 0.02);
  EXPECT_NEAR(at(2) - at(6), 100.0, 0.02);
}

TEST(Chart, RefusesWhatItCannotShow) {
  Figure figure = crowded_figure();
  figure.panels[1].lines[0].points = {{1.0, 2.0}, {366.0, 2.0}, {401.0, 2.0}};
  try {
    svg(figure);
    FAIL() << "a point off the axes was accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("line \"one\": (401, 2) is off the axes"));
  }
  EXPECT_THROW(svg(Figure{}), std::invalid_argument);
}

TEST(Table, IsOneLinePerRow) {
  const std::vector<Column> table = {{"day", {0.0, 0.29}}, {"modulus_pa", {5e8, -1.0 / 3.0}}};
  EXPECT_EQ(csv(table), "day,modulus_pa\n0,5e+08\n0.29,-0.333333\n");
}

TEST(Table, RefusesColumnsThatDoNotFit) {
  const std::vector<Column> ragged = {{"a", {1.0, 2.0}}, {"b", {1.0}}};
  try {
    csv(ragged);
    FAIL() << "ragged columns were accepted";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "column \"b\" has 1 values, \"a\" has 2");
  }
  EXPECT_THROW(csv(std::vector<Column>{{"a,b", {1.0}}}), std::invalid_argument);
}

/// Writes 0,5 and 1.000 as Germans do.
class GermanNumbers : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Sets both libraries' locales; C's only where the system has one with a decimal comma.
class GermanLocale {
 public:
  GermanLocale() : before_(std::locale::global(std::locale(std::locale(), new GermanNumbers))) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8"})
      if (std::setlocale(LC_NUMERIC, name) != nullptr) break;
  }
  ~GermanLocale() {
    std::locale::global(before_);
    std::setlocale(LC_NUMERIC, "C");
  }
  GermanLocale(const GermanLocale&) = delete;
  GermanLocale& operator=(const GermanLocale&) = delete;

 private:
  std::locale before_;
};

TEST(Chart, HasTheSameBytesInALocaleWithDecimalCommas) {
  const std::vector<Column> table = {{"a", {1234.5, 0.25}}};
  const std::string figure_before = svg(crowded_figure());
  const std::string table_before = csv(table);
  const GermanLocale german;
  EXPECT_EQ(svg(crowded_figure()), figure_before);
  EXPECT_EQ(csv(table), table_before);
}

}  // namespace
}  // namespace wold::report::chart
