// What the package says of Blender's versions, against the Blender that is here.
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/files.h"
#include "support/blender.h"
#include "support/places.h"
#include "support/temporary_folder.h"

namespace wold::blender {
namespace {

TEST(BlenderDifferences, HoldInTheVersionsThatTheListNames) {
  if (!test::has_blender()) GTEST_SKIP() << "no Blender on this machine: differences not checked";
  const test::TemporaryFolder folder("differences");
  const std::filesystem::path log = folder.path() / "log";
  const std::string check =
      test::blender_script(test::tests_folder() / "blender/differences_check.py");
  EXPECT_EQ(std::system((check + " > '" + log.string() + "' 2>&1").c_str()), 0) << read_file(log);
  EXPECT_NE(read_file(log).find("differences are right for"), std::string::npos) << read_file(log);
}

}  // namespace
}  // namespace wold::blender
