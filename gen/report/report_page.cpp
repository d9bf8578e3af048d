#include "report/report_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "core/duration_text.h"
#include "core/files.h"
#include "core/markup.h"
#include "core/page_picture.h"
#include "core/version.h"
#include "grass/ageing/withering_curves.h"
#include "report/curves_figure.h"
#include "report/pass_pictures.h"
#include "report/report_pictures.h"
#include "scene/registry.h"
#include "scene/shots.h"
#include "work/job.h"

namespace wold::report {
namespace {

using Json = nlohmann::ordered_json;

std::string list_of_warnings(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return {};
  std::string items;
  for (const std::string& warning : warnings)
    items += fmt::format("<li>{}</li>\n", markup_escaped(warning));
  return fmt::format("<ul class=\"warnings\" aria-label=\"Warnings\">\n{}</ul>\n", items);
}

/// "8 frames, 960 × 540 pixels, by Blender and POV-Ray"
std::string summary(const ReportFacts& facts, const EmbeddedFilm& film) {
  if (film.renderers.empty()) return fmt::format("{} frames", facts.frames.size());
  std::vector<std::string> names;
  for (const EmbeddedPictures& one : film.renderers) names.push_back(one.display_name);
  return fmt::format("{} frame{} · {} × {} pixels · {}", facts.frames.size(),
                     facts.frames.size() == 1 ? "" : "s", film.size_px.x, film.size_px.y,
                     fmt::join(names, " and "));
}

std::string times(const ReportFacts& facts) {
  std::string rows;
  for (const StageTime& stage : facts.stages)
    if (stage.done > 0)
      rows += fmt::format(
          "<tr><td>{}</td><td class=\"number\">{} of {}</td><td class=\"number\">{}</td>"
          "<td class=\"number\">{}</td></tr>\n",
          stage.stage, stage.done, stage.tasks, duration_text(stage.seconds / stage.done),
          duration_text(stage.seconds));
  if (rows.empty()) return {};
  return "<h2>Time taken</h2>\n<section class=\"card charts\">\n"
         "<div class=\"bars\" id=\"bars\"></div>\n<div class=\"scroll\"><table>\n"
         "<tr><th>stage</th><th class=\"number\">tasks done</th><th class=\"number\">each</th>"
         "<th class=\"number\">together</th></tr>\n" +
         rows + "</table></div>\n</section>\n";
}

std::string curves(const ReportFacts& facts) {
  if (!facts.scene) return {};
  const std::string svg =
      chart::svg(withering_figure(facts.name, grass::withering_curves(*facts.scene)));
  return fmt::format(
      "<h2>How a leaf ages</h2>\n<section class=\"card curves\"><img alt=\"Curves of pigments, "
      "water, shrinkage, stiffness, droop and reflectance over the weathering degree\" src=\"{}\">"
      "</section>\n",
      data_uri("image/svg+xml", svg));
}

/// Of the first frame that has some.
std::string passes(const ReportFacts& facts) {
  if (facts.passes.empty()) return {};
  const auto& [frame, file] = *facts.passes.begin();
  std::string figures;
  for (const PassPicture& pass : pass_pictures(file))
    figures +=
        fmt::format("<figure><img alt=\"{0}\" src=\"{1}\"><figcaption>{0}</figcaption></figure>\n",
                    markup_escaped(pass.name), pass.data_uri);
  return fmt::format(
      "<h2>Passes of frame {}</h2>\n<section class=\"card passes\">\n{}</section>\n", frame,
      figures.empty() ? fmt::format("<p>{} is damaged.</p>\n", markup_escaped(file.string()))
                      : figures);
}

/// A key's row; `usual` is its value where a scene says nothing, and is empty where there is none.
std::string parameter(const scene::Key& key, const std::string& value, const std::string& usual) {
  return fmt::format("<tr class=\"{}\"><td>{}</td><td>{}{}</td><td>{}</td></tr>\n",
                     value == usual ? "usual" : "own", markup_escaped(scene::leaf_of(key.name)),
                     markup_escaped(value), key.unit.empty() ? "" : " " + markup_escaped(key.unit),
                     markup_escaped(key.doc));
}

std::string parameter_table(const std::string& title, const std::string& rows) {
  return fmt::format("<tbody><tr><th colspan=\"3\">{}</th></tr>\n{}</tbody>\n",
                     markup_escaped(title), rows);
}

std::string parameters_that_stand_once(const scene::Scene& scene) {
  const scene::Scene defaults;
  std::string text, rows, table;
  const auto close = [&] {
    if (!rows.empty()) text += parameter_table(table.empty() ? "scene" : table, rows);
    rows.clear();
  };
  for (const scene::Key& key : scene::registry()) {
    if (scene::table_of(key.name) != table) close();
    table = scene::table_of(key.name);
    rows += parameter(key, scene::toml_text(key.get(scene)), scene::toml_text(key.get(defaults)));
  }
  close();
  return text;
}

std::string parameters_of_arrays(const scene::Scene& scene) {
  std::string text;
  for (const scene::TableArray& array : scene::table_arrays())
    for (std::size_t item = 0; item < array.count(scene); ++item) {
      std::string rows;
      for (const scene::Key& key : scene::item_keys(array, item))
        rows += parameter(key, scene::toml_text(key.get(scene)), "");
      text += parameter_table(fmt::format("{} {}", array.item, item + 1), rows);
    }
  return text;
}

std::string parameters(const ReportFacts& facts) {
  if (!facts.scene) return {};
  return "<h2>Parameters</h2>\n<section class=\"card parameters\">\n"
         "<label><input type=\"checkbox\" id=\"all\"> also those at their usual values</label>\n"
         "<div class=\"scroll\"><table>\n" +
         parameters_that_stand_once(*facts.scene) + parameters_of_arrays(*facts.scene) +
         "</table></div>\n</section>\n";
}

Json seconds_by_frame(const ReportFacts& facts, const std::string& renderer,
                      const std::vector<int>& frames) {
  Json list = Json::array();
  const auto known = facts.seconds.find(renderer);
  for (const int frame : frames)
    list.push_back(known != facts.seconds.end() && known->second.contains(frame)
                       ? Json(known->second.at(frame))
                       : Json(nullptr));
  return list;
}

Json shot_name(const ReportFacts& facts, int frame) {
  const scene::Shot* shot = facts.scene ? scene::shot_of(*facts.scene, frame) : nullptr;
  return shot != nullptr ? Json(shot->name) : Json(nullptr);
}

/// What the page's script shows, as JSON that may stand in a script element.
std::string data_of(const ReportFacts& facts, const EmbeddedFilm& film) {
  Json json = {{"count", facts.frames.size()}, {"size", {film.size_px.x, film.size_px.y}}};
  json["frames"] = Json::array();
  for (const int frame : film.frames)
    json["frames"].push_back({{"number", frame},
                              {"shot", shot_name(facts, frame)},
                              {"degree", facts.scene ? Json(facts.scene->ageing.frames.at(
                                                           static_cast<std::size_t>(frame - 1)))
                                                     : Json(nullptr)}});
  json["renderers"] = Json::array();
  for (const EmbeddedPictures& one : film.renderers) {
    Json pictures = Json::array();
    for (const std::string& uri : one.data_uris)
      pictures.push_back(uri.empty() ? Json(nullptr) : Json(uri));
    json["renderers"].push_back({{"name", one.display_name},
                                 {"pictures", std::move(pictures)},
                                 {"seconds", seconds_by_frame(facts, one.renderer, film.frames)}});
  }
  return filled(json.dump(), "<", "\\u003c");
}

}  // namespace

std::string report_page(const ReportFacts& facts, Progress& progress) {
  const EmbeddedFilm film = embedded_film(facts, progress);
  std::vector<std::string> warnings = facts.warnings;
  warnings.insert(warnings.end(), film.warnings.begin(), film.warnings.end());
  std::string page = read_file(shipped_file("templates/report/page.html"));
  page = filled(page, "<!-- VERSION -->", fmt::format("Wold {}", version));
  page = filled(page, "<!-- NAME -->", markup_escaped(facts.name));
  page = filled(page, "<!-- FACTS -->", summary(facts, film));
  page = filled(page, "<!-- WARNINGS -->", list_of_warnings(warnings));
  page = filled(page, "<!-- TIMES -->", times(facts));
  page = filled(page, "<!-- PASSES -->", passes(facts));
  page = filled(page, "<!-- CURVES -->", curves(facts));
  page = filled(page, "<!-- PARAMETERS -->", parameters(facts));
  return filled(page, "<!-- DATA -->", data_of(facts, film));
}

}  // namespace wold::report
