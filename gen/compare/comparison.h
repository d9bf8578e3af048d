#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compare/differences.h"
#include "compare/file_kind.h"

namespace wold::compare {

/// A picture of a report, as it was written.
struct Evidence {
  std::string caption;
  std::filesystem::path file;
};

/// What the comparison of two files of any kind comes to.
struct Comparison {
  std::string name;           ///< of both files, for people
  std::filesystem::path got;  ///< empty: there is no such file
  std::filesystem::path want;
  std::string kind;                 ///< "picture", "vdb" or "df3"
  std::vector<std::string> faults;  ///< that no limit forgives
  std::vector<Measure> measures;
  nlohmann::ordered_json metrics = nlohmann::ordered_json::object();
  std::vector<Evidence> evidence;  ///< empty without a report
};

/// One sentence for all that speaks against being the same.
std::vector<std::string> reasons(const Comparison& comparison);

inline bool is_same(const Comparison& comparison) { return reasons(comparison).empty(); }

/// Everything but the evidence, with keys in a fixed order.
nlohmann::ordered_json to_json(const Comparison& comparison, const Limits& limits);

nlohmann::ordered_json to_json(const Differences& differences);

/// One line: name, "same" or what speaks against it.
std::string to_line(const Comparison& comparison);

}  // namespace wold::compare
