#include "compare/inspect_layers.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>

namespace wold::compare {
namespace {

using Json = nlohmann::ordered_json;

constexpr float nothing = 1e10F;

std::string layer_of(const std::string& channel) { return channel.substr(0, channel.rfind('.')); }

/// "species" of the layer "species00".
std::string without_number(const std::string& layer) {
  const std::size_t last = layer.find_last_not_of("0123456789");
  return layer.substr(0, last + 1);
}

Json channel_json(const ImageChannel& channel) {
  std::optional<float> least, largest;
  double sum = 0.0, count = 0.0;
  for (const float value : channel.values) {
    if (!(std::abs(value) < nothing)) continue;
    least = std::min(least.value_or(value), value);
    largest = std::max(largest.value_or(value), value);
    sum += double{value};
    ++count;
  }
  Json json = {{"stored_as", channel.stored_as == PixelFormat::half ? "half" : "float"}};
  if (least) {
    json["range"] = {*least, *largest};
    json["mean"] = sum / count;
  }
  if (const auto left_out = static_cast<double>(channel.values.size()) - count; left_out > 0.0)
    json["fraction_without_a_number"] = left_out / static_cast<double>(channel.values.size());
  return json;
}

/// Adds "unit" and "meaning", which "wold/<layer>" has with a semicolon between them.
void add_meaning(const LayeredImage& image, const std::string& layer, Json& json) {
  const auto text = image.attributes.find("wold/" + without_number(layer));
  if (text == image.attributes.end()) return;
  const std::size_t semicolon = text->second.find("; ");
  if (semicolon == std::string::npos) return;
  json["unit"] = text->second.substr(0, semicolon);
  json["meaning"] = text->second.substr(semicolon + 2);
}

/// The mean of what an id covers, over the pairs of channels of a Cryptomatte.
double covered(const LayeredImage& image, const std::string& layer, std::uint32_t bits) {
  double sum = 0.0;
  for (const ImageChannel& ids : image.channels) {
    if (without_number(layer_of(ids.name)) != layer) continue;
    const char letter = ids.name.back();
    if (letter != 'R' && letter != 'B') continue;
    const ImageChannel* fractions = image.find(layer_of(ids.name) + (letter == 'R' ? ".G" : ".A"));
    if (!fractions) continue;
    for (std::size_t i = 0; i < ids.values.size(); ++i)
      if (std::bit_cast<std::uint32_t>(ids.values[i]) == bits) sum += double{fractions->values[i]};
  }
  return sum / static_cast<double>(image.pixels());
}

/// A manifest is somebody's text: what is no name with a number of eight digits is left out.
Json names_json(const LayeredImage& image, const std::string& layer, const std::string& manifest) {
  Json names = Json::object();
  const Json read = Json::parse(manifest, nullptr, /*allow_exceptions=*/false);
  if (!read.is_object()) return names;
  for (const auto& [name, value] : read.items()) {
    if (!value.is_string()) continue;
    const auto hex = value.get<std::string>();
    std::uint32_t bits = 0;
    const char* end = hex.data() + hex.size();
    if (std::from_chars(hex.data(), end, bits, 16).ptr == end && !hex.empty())
      names[name] = covered(image, layer, bits);
  }
  return names;
}

void add_names(const LayeredImage& image, const std::string& layer, Json& json) {
  for (const auto& [attribute, text] : image.attributes) {
    if (!attribute.starts_with("cryptomatte/") || !attribute.ends_with("/name")) continue;
    const std::string key = attribute.substr(0, attribute.size() - std::string("name").size());
    const auto manifest = image.attributes.find(key + "manifest");
    if (text == layer && manifest != image.attributes.end())
      json["covered_by"] = names_json(image, layer, manifest->second);
  }
}

}  // namespace

bool has_layers(const LayeredImage& image) {
  return std::ranges::any_of(image.channels, [](const ImageChannel& channel) {
    return channel.name.find('.') != std::string::npos;
  });
}

Json layers_json(const LayeredImage& image) {
  std::vector<std::string> layers;
  for (const ImageChannel& channel : image.channels)
    if (const std::string layer = without_number(layer_of(channel.name));
        std::ranges::count(layers, layer) == 0)
      layers.push_back(layer);
  Json json = Json::object();
  for (const std::string& layer : layers) {
    Json& one = json[layer.empty() ? "unnamed" : layer];
    one = Json::object();
    add_meaning(image, layer, one);
    add_names(image, layer, one);
    for (const ImageChannel& channel : image.channels) {
      if (without_number(layer_of(channel.name)) != layer) continue;
      if (one.contains("covered_by"))
        one["channels"].push_back(channel.name);
      else
        one["channels"][channel.name] = channel_json(channel);
    }
  }
  return json;
}

Json header_json(const LayeredImage& image) {
  Json json = Json::object();
  for (const char* name : {"wold/format", "wold/frame", "wold/camera"})
    if (const auto text = image.attributes.find(name); text != image.attributes.end())
      json[std::string(name).substr(std::string("wold/").size())] = text->second;
  return json;
}

}  // namespace wold::compare
