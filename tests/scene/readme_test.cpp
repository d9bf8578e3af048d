#include <gtest/gtest.h>

#include "core/files.h"
#include "scene/write.h"

namespace wold::scene {
namespace {

TEST(Readme, ListsEveryKeyAsTheRegistryHasIt) {
  const std::string readme = read_file(WOLD_TESTS_DIR "/../README.md");
  EXPECT_NE(readme.find(keys_markdown()), std::string::npos)
      << "README.md: replace the tables under \"Keys of a scene\" by `wold --help-keys`";
}

}  // namespace
}  // namespace wold::scene
