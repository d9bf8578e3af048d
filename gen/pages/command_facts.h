#pragma once

#include <string>
#include <vector>

namespace wold::pages {

/// An option, or an argument that stands without a name before it.
struct OptionFacts {
  std::string name;                ///< "--size"; of an argument "SCENE"
  std::string value;               ///< what follows: "WxH"; "" for a flag
  std::string doc;                 ///< one sentence without its full stop
  std::string usual;               ///< what it is when it is not given, if it says so
  std::vector<std::string> words;  ///< all that the value may be, if these are few
  bool required = false;
  bool repeats = false;  ///< may be given more than once
};

/// A command as the command line declares it; also the program as a whole.
struct CommandFacts {
  std::string name;
  std::string summary;
  std::string example;  ///< of the program: ""
  std::vector<OptionFacts> options;
  std::vector<OptionFacts> arguments;
};

}  // namespace wold::pages
