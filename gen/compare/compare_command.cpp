#include "compare/compare_command.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "compare/file_kind.h"
#include "compare/images.h"
#include "compare/vdb.h"
#include "core/df3.h"
#include "core/files.h"
#include "core/image.h"

namespace wold::compare {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
constexpr float difference_gain = 10.0F;

/// What a comparison of any kind comes to.
struct Outcome {
  std::vector<std::string> reasons;  ///< against being the same
  Json metrics = Json::object();
};

Json to_json(const Limits& limits) {
  return {{"rmse", limits.rmse},
          {"soft", limits.soft},
          {"allowed_share", limits.allowed_share},
          {"hard", limits.hard}};
}

Json to_json(const Differences& differences) {
  return {{"mean_abs", differences.mean_abs},
          {"rmse", differences.rmse},
          {"max_error", differences.max_error},
          {"share_over_soft", differences.share_over_soft},
          {"non_finite", differences.non_finite}};
}

Json to_json(const Image& image, const ImageMetrics& metrics) {
  Json json = {{"width", image.width}, {"height", image.height}, {"channels", image.channels}};
  json.update(to_json(static_cast<const Differences&>(metrics)));
  json["worst_px"] = {metrics.worst_px.x, metrics.worst_px.y};
  json["psnr_db"] = metrics.psnr_db;  // JSON has no infinity: null for equal pictures
  json["mean_shift"] = metrics.mean_shift;
  json["mean_abs_blurred8"] = metrics.mean_abs_blurred8;
  json["mean_delta_e"] = metrics.mean_delta_e;
  return json;
}

Json box_json(const GridFacts& facts) {
  return {{facts.box_min.x, facts.box_min.y, facts.box_min.z},
          {facts.box_max.x, facts.box_max.y, facts.box_max.z}};
}

Json to_json(const GridMetrics& grid) {
  Json json = {{"name", grid.name},
               {"type", {grid.got.type, grid.want.type}},
               {"same_transform", grid.same_transform},
               {"active_voxels", {grid.got.active_voxels, grid.want.active_voxels}},
               {"box", {box_json(grid.got), box_json(grid.want)}}};
  if (grid.is_compared) json.update(to_json(static_cast<const Differences&>(grid)));
  return json;
}

/// A viewable copy: PNG holds up to four channels.
void write_shown(const fs::path& path, const Image& image) {
  Image shown(image.width, image.height, std::min(image.channels, 4));
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(image.pixel(x, y), shown.channels, shown.pixel(x, y));
  write_image(path, shown, PixelFormat::uint8);
}

Outcome compare_pictures(const fs::path& got_path, const fs::path& want_path, const Limits& limits,
                         const fs::path& report_folder) {
  const Image got = read_image(got_path);
  const Image want = read_image(want_path);
  if (!report_folder.empty()) {
    write_shown(report_folder / "got.png", got);
    write_shown(report_folder / "want.png", want);
  }
  if (std::string why = shape_difference(got, want); !why.empty()) return {{std::move(why)}};
  if (!report_folder.empty())
    write_shown(report_folder / "difference.png", difference_image(got, want, difference_gain));
  const ImageMetrics metrics = compare_images(got, want, limits.soft);
  return {exceeded(metrics, limits), to_json(got, metrics)};
}

std::vector<std::string> grid_reasons(const GridMetrics& grid, const Limits& limits) {
  if (!grid.same_type) return {fmt::format("type {}, want {}", grid.got.type, grid.want.type)};
  if (!grid.is_compared)
    return {fmt::format("values of type {} cannot be compared", grid.got.type)};
  std::vector<std::string> reasons = exceeded(grid, limits);
  if (!grid.same_transform) reasons.emplace_back("the transforms differ");
  return reasons;
}

Outcome compare_vdbs(const fs::path& got, const fs::path& want, const Limits& limits) {
  const VdbMetrics metrics = compare_vdb(got, want, limits.soft);
  Outcome outcome;
  for (const std::string& name : metrics.only_want)
    outcome.reasons.push_back(fmt::format("grid {} is missing", name));
  for (const std::string& name : metrics.only_got)
    outcome.reasons.push_back(fmt::format("grid {} is not wanted", name));
  outcome.metrics["grids"] = Json::array();
  for (const GridMetrics& grid : metrics.grids) {
    for (const std::string& reason : grid_reasons(grid, limits))
      outcome.reasons.push_back(fmt::format("grid {}: {}", grid.name, reason));
    outcome.metrics["grids"].push_back(to_json(grid));
  }
  return outcome;
}

Outcome compare_df3s(const fs::path& got_path, const fs::path& want_path, const Limits& limits) {
  const Df3 got = read_df3(got_path);
  const Df3 want = read_df3(want_path);
  if (got.size != want.size)
    return {{fmt::format("got {} x {} x {} values, want {} x {} x {}", got.size.x, got.size.y,
                         got.size.z, want.size.x, want.size.y, want.size.z)}};
  DifferenceSum sum(limits.soft);
  for (std::size_t i = 0; i < got.values.size(); ++i) {
    sum.add(got.values[i], want.values[i]);
    sum.end_sample();
  }
  Json json = {{"size", {got.size.x, got.size.y, got.size.z}}, {"bits", {got.bits, want.bits}}};
  json.update(to_json(sum.result()));
  return {exceeded(sum.result(), limits), json};
}

Outcome compare_kind(FileKind kind, const fs::path& got, const fs::path& want, const Limits& limits,
                     const fs::path& report_folder) {
  switch (kind) {
    case FileKind::vdb:
      return compare_vdbs(got, want, limits);
    case FileKind::df3:
      return compare_df3s(got, want, limits);
    case FileKind::picture:
      break;
  }
  return compare_pictures(got, want, limits, report_folder);
}

}  // namespace

ExitCode compare_files(const fs::path& got, const fs::path& want, const Limits& limits,
                       const fs::path& report_folder, std::string& json_out) {
  const FileKind kind = file_kind(got);
  const FileKind want_kind = file_kind(want);
  if (!report_folder.empty()) make_folder(report_folder);
  const Outcome outcome =
      kind == want_kind
          ? compare_kind(kind, got, want, limits, report_folder)
          : Outcome{{fmt::format("got a {}, want a {}", to_string(kind), to_string(want_kind))}};
  const bool same = outcome.reasons.empty();
  const Json json = {{"got", got.string()},        {"want", want.string()},
                     {"kind", to_string(kind)},    {"same", same},
                     {"reasons", outcome.reasons}, {"limits", to_json(limits)},
                     {"metrics", outcome.metrics}};
  json_out = json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
  if (!report_folder.empty()) write_file(report_folder / "metrics.json", json_out);
  return same ? ExitCode::done : ExitCode::different;
}

}  // namespace wold::compare
