#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <string_view>

#include "core/elementary.h"

namespace wold {

/// Randomness keyed by identity: the same (seed, kind, index, purpose) gives the same number on
/// any machine, with any number of threads, in any order. Nothing is drawn in sequence, so adding
/// a draw never changes another one.
struct RandomKey {
  std::uint64_t seed = 0;
  std::uint64_t kind = 0;     ///< what the thing is: key_of("blade")
  std::uint64_t index = 0;    ///< which one
  std::uint64_t purpose = 0;  ///< what the number is for: key_of("height")
};

/// FNV-1a of a name, for the kind and purpose of a key.
constexpr std::uint64_t key_of(std::string_view name) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  for (char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return hash;
}

/// The finaliser of SplitMix64 (Steele, Lea and Flood 2014): a bijection that mixes all bits.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ULL;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ULL;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// 64 random bits for a key.
constexpr std::uint64_t random_bits(const RandomKey& key) {
  return mixed(mixed(mixed(mixed(key.seed) ^ key.kind) ^ key.index) ^ key.purpose);
}

/// Uniform in [0, 1).
constexpr double random_uniform(const RandomKey& key) {
  return static_cast<double>(random_bits(key) >> 11) * 0x1.0p-53;
}

/// Uniform integer in [0, count); count > 0.
constexpr std::uint32_t random_below(const RandomKey& key, std::uint32_t count) {
  return static_cast<std::uint32_t>(((random_bits(key) >> 32) * count) >> 32);
}

/// Standard normal (Box and Muller 1958).
inline double random_normal(const RandomKey& key) {
  const double u = 1.0 - random_uniform(key);
  const double v = random_uniform({key.seed, key.kind, key.index, key.purpose ^ key_of("second")});
  return std::sqrt(-2.0 * math::log(u)) * math::cos(2.0 * std::numbers::pi * v);
}

}  // namespace wold
