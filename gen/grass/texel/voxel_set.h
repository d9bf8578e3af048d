#pragma once

#include <cstdint>
#include <vector>

#include "grass/texel/texel.h"

namespace wold::grass {

/// A sparse set of voxels of a dense box that knows every member's place in ascending order. One
/// bit per voxel of the box and a count per 64 of them: what would be a table of 48 MB for the
/// finest texel stays in the processor's cache.
class VoxelSet {
 public:
  explicit VoxelSet(const TexelShape& shape) : words_(shape.voxels() / 64 + 1) {}

  void insert(std::uint32_t voxel) { words_[voxel / 64].members |= bit(voxel); }
  bool contains(std::uint32_t voxel) const {
    return (words_[voxel / 64].members & bit(voxel)) != 0;
  }

  /// Numbers the members and returns them in ascending order; place() is right until the next
  /// insert().
  std::vector<std::uint32_t> number_members();
  /// The member's place in that order.
  std::uint32_t place(std::uint32_t voxel) const {
    const Word& word = words_[voxel / 64];
    return word.before + count(word.members & (bit(voxel) - 1));
  }

 private:
  struct Word {
    std::uint64_t members = 0;
    std::uint32_t before = 0;  ///< members in all words before this one
  };
  /// std::popcount, which is a function call where the build must run on any x86-64.
  static std::uint32_t count(std::uint64_t bits) {
    bits -= (bits >> 1) & 0x5555555555555555U;
    bits = (bits & 0x3333333333333333U) + ((bits >> 2) & 0x3333333333333333U);
    bits = (bits + (bits >> 4)) & 0x0F0F0F0F0F0F0F0FU;
    return static_cast<std::uint32_t>((bits * 0x0101010101010101U) >> 56);
  }
  static std::uint64_t bit(std::uint32_t voxel) { return std::uint64_t{1} << (voxel % 64); }

  std::vector<Word> words_;
};

}  // namespace wold::grass
