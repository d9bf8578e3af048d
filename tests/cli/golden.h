#pragma once

#include "program.h"

namespace wold::test {

/// Judges pictures by those in tests/golden. `tests/run.sh --update-golden` makes these anew.
class GoldenPictures : public Program {
 protected:
  /// Expects a picture to look like tests/golden/NAME.png. If it does not, the picture stays as
  /// golden/got/NAME.png in the build folder, and a page about the difference in golden/NAME.
  void expect_golden(const fs::path& picture, const std::string& name) const;
};

}  // namespace wold::test
