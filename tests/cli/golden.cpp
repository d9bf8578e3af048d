#include "golden.h"

#include <fmt/format.h>

#include "support/places.h"

namespace wold::test {

void GoldenPictures::expect_golden(const fs::path& picture, const std::string& name) const {
  const fs::path want = tests_folder() / "golden" / (name + ".png");
  const fs::path evidence = build_folder() / "golden";
  const fs::path kept = evidence / "got" / (name + ".png");
  const fs::path report = evidence / name;
  fs::remove_all(report);
  fs::create_directories(kept.parent_path());
  fs::copy_file(picture, kept, fs::copy_options::overwrite_existing);
  const Result result = wold(fmt::format("compare '{}' '{}' --report '{}'", kept.string(),
                                         want.string(), report.string()));
  EXPECT_EQ(result.code, 0) << name << ".png does not look like the picture in tests/golden.\n"
                            << result.err << "If it should look so: tests/run.sh --update-golden";
  if (result.code != 0) return;
  fs::remove_all(report);
  fs::remove(kept);
}

}  // namespace wold::test
