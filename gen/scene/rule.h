#pragma once

#include <string>
#include <vector>

namespace wold::scene {

/// A rule about several keys: the keys, those to blame first, whether it holds, and what to say
/// when it does not.
struct Rule {
  std::vector<std::string> keys;
  bool holds;
  std::string message;
};

}  // namespace wold::scene
