#pragma once

#include <filesystem>

/// Where things of this build lie, as absolute paths. Compiled apart, so that no other file of the
/// tests knows its folder: what ccache keeps of them is then found from any clone.
namespace wold::test {

/// Folder of the tests' sources.
std::filesystem::path tests_folder();
/// Folder of the templates of the renderers' scripts.
std::filesystem::path templates_folder();
std::filesystem::path build_folder();
/// Folder of the manual pages that the build makes.
std::filesystem::path pages_folder();
/// The program wold; a test that runs it depends on its target.
std::filesystem::path wold_program();

}  // namespace wold::test
