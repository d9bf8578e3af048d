#include "core/expected_picture.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/files.h"

namespace wold {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// To four digits after the point.
double rounded(float value) {
  const double last_digits = std::round(double{value} * 1e4);
  return last_digits / 1e4;
}

Json json_of(const glm::vec3& colour) {
  return {rounded(colour.x), rounded(colour.y), rounded(colour.z)};
}

glm::vec3 colour_of(const Json& channels) {
  return {channels.at(0).get<float>(), channels.at(1).get<float>(), channels.at(2).get<float>()};
}

Json json_of(const ExpectedThings& things) {
  Json tiles = Json::array();
  for (const ExpectedTile& tile : things.tiles)
    tiles.push_back({tile.tile, json_of(tile.with), json_of(tile.without)});
  return {{"name", things.name}, {"least_share", things.min_fraction}, {"tiles", tiles}};
}

ExpectedThings things_of(const Json& json, int tiles) {
  ExpectedThings things{
      json.at("name").get<std::string>(), json.at("least_share").get<double>(), {}};
  for (const Json& tile : json.at("tiles")) {
    things.tiles.push_back({tile.at(0).get<int>(), colour_of(tile.at(1)), colour_of(tile.at(2))});
    const int number = things.tiles.back().tile;
    if (number < 0 || number >= tiles) throw FileError(fmt::format("there is no tile {}", number));
  }
  return things;
}

ExpectedPicture picture_of(const Json& json) {
  ExpectedPicture expected;
  expected.tiles = {json.at("tiles").at(0).get<int>(), json.at("tiles").at(1).get<int>()};
  if (expected.tiles.x < 1 || expected.tiles.y < 1) throw FileError("there are no tiles");
  for (const Json& things : json.at("things"))
    expected.things.push_back(things_of(things, expected.tiles.x * expected.tiles.y));
  return expected;
}

}  // namespace

void write_expected_picture(const fs::path& path, const ExpectedPicture& expected) {
  Json things = Json::array();
  for (const ExpectedThings& each : expected.things) things.push_back(json_of(each));
  const Json json = {{"tiles", {expected.tiles.x, expected.tiles.y}}, {"things", things}};
  write_file(path, json.dump() + "\n");
}

ExpectedPicture read_expected_picture(const fs::path& path) {
  const std::string text = read_file(path);
  try {
    return picture_of(Json::parse(text));
  } catch (const std::exception& error) {
    throw FileError(fmt::format(
        "{} is damaged ({}); expected what the picture should show: run the same command again",
        path.string(), error.what()));
  }
}

}  // namespace wold
