#include "support/places.h"

namespace wold::test {

std::filesystem::path tests_folder() { return WOLD_TESTS_DIR; }
std::filesystem::path templates_folder() { return WOLD_TEMPLATES_DIR; }
std::filesystem::path build_folder() { return WOLD_BUILD_DIR; }
std::filesystem::path pages_folder() { return WOLD_PAGES_DIR; }
std::filesystem::path wold_program() { return WOLD_PROGRAM; }

}  // namespace wold::test
