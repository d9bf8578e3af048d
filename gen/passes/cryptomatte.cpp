#include "passes/cryptomatte.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <nlohmann/json.hpp>
#include <numeric>
#include <utility>

namespace wold::passes {
namespace {

constexpr std::size_t max_ranks = 6;

std::string hex(std::uint32_t hash) { return fmt::format("{:08x}", hash); }

}  // namespace

std::uint32_t murmur_hash(std::string_view text) {
  constexpr std::uint32_t c1 = 0xcc9e2d51U, c2 = 0x1b873593U;
  const auto byte = [&](std::size_t i) {
    return std::uint32_t{static_cast<unsigned char>(text[i])};
  };
  const auto scrambled = [&](std::uint32_t block) { return std::rotl(block * c1, 15) * c2; };
  std::uint32_t hash = 0;
  const std::size_t whole = text.size() / 4 * 4;
  for (std::size_t i = 0; i < whole; i += 4) {
    hash ^= scrambled(byte(i) | byte(i + 1) << 8 | byte(i + 2) << 16 | byte(i + 3) << 24);
    hash = std::rotl(hash, 13) * 5 + 0xe6546b64U;
  }
  std::uint32_t rest = 0;
  for (std::size_t i = text.size(); i > whole; --i) rest = rest << 8 | byte(i - 1);
  hash ^= scrambled(rest);
  hash ^= static_cast<std::uint32_t>(text.size());
  hash = (hash ^ hash >> 16) * 0x85ebca6bU;
  hash = (hash ^ hash >> 13) * 0xc2b2ae35U;
  return hash ^ hash >> 16;
}

namespace {

std::uint32_t id_bits(std::string_view name) {
  const std::uint32_t hash = murmur_hash(name);
  const std::uint32_t exponent = hash >> 23 & 255U;
  return exponent == 0 || exponent == 255 ? hash ^ 1U << 23 : hash;
}

}  // namespace

float id_of(std::string_view name) { return std::bit_cast<float>(id_bits(name)); }

/// A layer of four has two names: R and G of the first, B and A of the second.
std::size_t Cryptomatte::channels_of(std::size_t names) {
  return (std::min(names, max_ranks) + 1) / 2 * 4;
}

Cryptomatte::Cryptomatte(std::string layer, std::vector<std::string> names, std::size_t pixels)
    : layer_(std::move(layer)),
      names_(std::move(names)),
      channels_(channels_of(names_.size()), std::vector<float>(pixels, 0.0F)) {
  for (const std::string& name : names_) ids_.push_back(id_of(name));
}

void Cryptomatte::set(std::size_t pixel, std::span<const double> fractions) {
  std::vector<std::size_t> order(names_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return fractions[a] > fractions[b]; });
  for (std::size_t rank = 0; rank < std::min(order.size(), max_ranks); ++rank) {
    const std::size_t name = order[rank];
    if (!(fractions[name] > 0.0)) break;
    channels_[2 * rank][pixel] = ids_[name];
    channels_[2 * rank + 1][pixel] = static_cast<float>(fractions[name]);
  }
}

void Cryptomatte::add_to(LayeredImage& image) const {
  for (std::size_t i = 0; i < channels_.size(); ++i)
    image.channels.push_back({fmt::format("{}{:02}.{}", layer_, i / 4, "RGBA"[i % 4]),
                              PixelFormat::float32, channels_[i]});
  nlohmann::ordered_json manifest = nlohmann::ordered_json::object();
  for (const std::string& name : names_) manifest[name] = hex(id_bits(name));
  const std::string key = "cryptomatte/" + hex(murmur_hash(layer_)).substr(0, 7) + "/";
  image.attributes[key + "name"] = layer_;
  image.attributes[key + "hash"] = "MurmurHash3_32";
  image.attributes[key + "conversion"] = "uint32_to_float32";
  image.attributes[key + "manifest"] =
      manifest.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace wold::passes
