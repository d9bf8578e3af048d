#include "compare/report_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include "core/files.h"
#include "core/markup.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

/// Where the page finds a picture. Evidence has plain names of its own, whatever the folder's is.
std::string source(const Evidence& evidence, const fs::path& page) {
  return evidence.file.lexically_relative(page.parent_path()).generic_string();
}

std::string image(const Evidence& evidence, const fs::path& page, std::string_view css_class) {
  return fmt::format(R"(<img class="{}" src="{}" alt="{}" loading="lazy">)", css_class,
                     source(evidence, page), markup_escaped(evidence.caption));
}

std::string figure(std::string_view caption, std::string_view content) {
  return fmt::format("<figure><figcaption>{}</figcaption>{}</figure>\n", markup_escaped(caption),
                     content);
}

/// What was got; a click shows what was wanted in its place.
std::string flip_figure(const Evidence& got, const Evidence& want, const fs::path& page) {
  return fmt::format(
      "<figure><label class=\"flip\"><input type=\"checkbox\" aria-label=\"show want\">"
      "<span class=\"got\">got (click for want)</span><span class=\"want\">want (click for got)"
      "</span>{}{}</label></figure>\n",
      image(got, page, "got"), image(want, page, "want"));
}

std::string pictures(std::span<const Evidence> evidence, const fs::path& page) {
  if (evidence.empty()) return {};
  std::string text = "<div class=\"pictures\">\n";
  if (evidence.size() > 1) {
    text += flip_figure(evidence[0], evidence[1], page);
    evidence = evidence.subspan(1);
  }
  for (const Evidence& one : evidence) text += figure(one.caption, image(one, page, "alone"));
  return text + "</div>\n";
}

std::string limit(const Measure& measure) {
  if (std::isfinite(measure.max)) return fmt::format("at most {:.4g}", measure.max);
  if (std::isfinite(measure.min)) return fmt::format("at least {:.4g}", measure.min);
  return "";
}

std::string row(const Measure& measure) {
  return fmt::format(
      "<tr{}><td>{}</td><td class=\"number\">{:.5g}</td><td>{}</td><td>{}</td></tr>\n",
      measure.is_good() ? "" : " class=\"bad\"", markup_escaped(measure.name), measure.value,
      limit(measure), measure.is_good() ? "" : "exceeded");
}

std::string table(const std::vector<Measure>& measures) {
  if (measures.empty()) return {};
  std::string rows;
  for (const Measure& measure : measures) rows += row(measure);
  return "<div class=\"wide\"><table>\n"
         "<tr><th>measure</th><th>value</th><th>limit</th><th></th></tr>\n" +
         rows + "</table></div>\n";
}

std::string list_of_faults(const std::vector<std::string>& faults) {
  if (faults.empty()) return {};
  std::string items;
  for (const std::string& fault : faults)
    items += fmt::format("<li>{}</li>\n", markup_escaped(fault));
  return fmt::format("<ul class=\"faults\">\n{}</ul>\n", items);
}

std::string path_text(const fs::path& path) {
  return path.empty() ? "nothing" : markup_escaped(path.string());
}

std::string section(const Comparison& comparison, const fs::path& page, bool is_single) {
  const bool same = is_same(comparison);
  return fmt::format(
      "<details class=\"{}\"{}>\n"
      "<summary>{} <span class=\"verdict\">{}</span></summary>\n"
      "<div class=\"body\">\n{}{}{}"
      "<p class=\"paths\">got {}<br>want {}</p>\n"
      "</div>\n</details>\n",
      same ? "same" : "different", is_single || !same ? " open" : "",
      markup_escaped(comparison.name), same ? "same" : "different",
      list_of_faults(comparison.faults), pictures(comparison.evidence, page),
      table(comparison.measures), path_text(comparison.got), path_text(comparison.want));
}

std::string title(const std::vector<Comparison>& comparisons) {
  if (comparisons.size() == 1)
    return fmt::format("{}: {}", markup_escaped(comparisons.front().name),
                       is_same(comparisons.front()) ? "same" : "different");
  return fmt::format("{} of {} differ", std::ranges::count_if(comparisons, std::not_fn(is_same)),
                     comparisons.size());
}

/// Stands in the template, and so in every page.
constexpr std::string_view mark = R"(<meta name="generator" content="wold compare">)";

}  // namespace

bool is_report_page(std::string_view text) { return text.find(mark) != std::string_view::npos; }

void write_report_page(const fs::path& page, const std::vector<Comparison>& comparisons) {
  std::string sections;
  for (const Comparison& comparison : comparisons)
    sections += section(comparison, page, comparisons.size() == 1);
  const std::string text = filled(read_file(shipped_file("templates/compare/page.html")),
                                  "<!-- TITLE -->", title(comparisons));
  write_file(page, filled(text, "<!-- COMPARISONS -->", sections));
}

}  // namespace wold::compare
