#pragma once

#include "small_film.h"

namespace wold::test {

/// The smallest film, tiny.toml: three frames of 32 x 18 pixels by POV-Ray itself, a second or two.
/// Skipped where it is missing.
class TinyFilm : public SmallFilm {
 protected:
  void SetUp() override;

  std::string render_line(const std::string& out, const std::string& environment = "") const {
    return command("render tiny.toml --quiet --out " + out, environment);
  }

  /// Renders what is missing and expects what a run that nothing disturbed has made: every file,
  /// byte for byte, and nothing else.
  void expect_goes_on(const std::string& out) const;

  /// Likewise for what is there already.
  void expect_undisturbed(const std::string& out) const;

 private:
  std::map<std::string, std::string> undisturbed_;
};

}  // namespace wold::test
