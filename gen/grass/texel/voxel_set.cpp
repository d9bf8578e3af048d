#include "grass/texel/voxel_set.h"

#include <bit>

namespace wold::grass {

std::vector<std::uint32_t> VoxelSet::number_members() {
  std::uint32_t total = 0;
  for (Word& word : words_) {
    word.before = total;
    total += count(word.members);
  }
  std::vector<std::uint32_t> members;
  members.reserve(total);
  for (std::size_t i = 0; i < words_.size(); ++i)
    for (std::uint64_t rest = words_[i].members; rest != 0; rest &= rest - 1)
      members.push_back(static_cast<std::uint32_t>(i * 64) +
                        static_cast<std::uint32_t>(std::countr_zero(rest)));
  return members;
}

}  // namespace wold::grass
