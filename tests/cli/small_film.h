#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <vector>

#include "program.h"
#include "support/fake_blender.h"

namespace wold::test {

/// A meadow that is made in a second: two patches in three states, two frames of 64 x 36 pixels.
/// The scene is small.toml in the test's folder.
class SmallFilm : public Program {
 protected:
  void SetUp() override;

  /// Makes the texels' work long enough to be stopped in the middle: seconds on one thread.
  static constexpr const char* slower =
      " --threads 1 --set 'grass.levels=[126, 62]' --set grass.blades=300 ";

  /// Content hash of every file below a folder but those that have seconds, the manifest and the
  /// tasks' records, and the logs.
  std::map<std::string, std::string> contents(const std::string& folder) const;

  /// When each file below a folder was written, by its path from there.
  std::map<std::string, fs::file_time_type> times(const std::string& folder) const;

  /// No temporary file is left, and every volume, picture and map that is there is sound.
  void expect_nothing_half_written(const std::string& folder) const;

  /// A shell script that plays Blender; returns the environment that chooses it. In it, $out is the
  /// wanted picture, $frame its number, and $good a sound picture. `paint without` makes that one
  /// without any grass. Every picture adds the number to the file "calls", every probe a line to
  /// "probes". What it says is not kept for other tests.
  std::string blender_played_by(const std::string& body, const FakeBlender& fake = {}) const;

  /// The frames the script was called for since the last time, such as "1 2 ".
  std::string calls() const;
};

/// The keys under which two maps differ: another value, or only in one of them.
template <class Value>
std::vector<std::string> different(const std::map<std::string, Value>& got,
                                   const std::map<std::string, Value>& want) {
  std::vector<std::pair<std::string, Value>> pairs;
  std::set_symmetric_difference(got.begin(), got.end(), want.begin(), want.end(),
                                std::back_inserter(pairs));
  std::set<std::string> keys;
  for (const auto& pair : pairs) keys.insert(pair.first);
  return {keys.begin(), keys.end()};
}

/// The files below a folder, by their paths from there.
std::vector<fs::path> files_below(const fs::path& folder);

/// Waits until something happens; false when it does not within a minute.
bool eventually(const std::function<bool()>& happens);

/// Whether the process whose number stands in a file has ended, be it collected or not.
bool is_gone(const fs::path& pid_file);

}  // namespace wold::test
