#include "work/folder_format.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "core/files.h"
#include "core/version.h"
#include "support/temporary_folder.h"

namespace wold::work {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// An output folder whose format.json is that text.
class FolderFormat : public testing::Test {
 protected:
  void write(const std::string& text) const {
    make_folder(out() / "tasks");
    write_file(out() / "tasks/format.json", text);
  }
  std::filesystem::path out() const { return folder_.path() / "out"; }

  /// What is said when the folder is refused; empty when it is not.
  std::string refusal() const {
    try {
      require_known_format(out());
      return {};
    } catch (const InputError& error) {
      return error.what();
    }
  }

 private:
  test::TemporaryFolder folder_{"folder_format"};
};

TEST_F(FolderFormat, IsWrittenOnceAndAccepted) {
  make_folder(out() / "tasks");
  write_folder_format(out());
  const auto written = std::filesystem::last_write_time(out() / "tasks/format.json");
  EXPECT_EQ(read_file(out() / "tasks/format.json"),
            std::string(R"({"format":1,"wold":")") + version + "\"}\n");
  EXPECT_EQ(refusal(), "");
  write_folder_format(out());
  EXPECT_EQ(std::filesystem::last_write_time(out() / "tasks/format.json"), written);
}

// The number came after the first format.
TEST_F(FolderFormat, WithoutANumberIsTheFirst) {
  EXPECT_EQ(refusal(), "");
  for (const std::string damaged :
       {"", "{", "[]", "1", "{}", R"({"format": "2"})", R"({"format": 1.5})"}) {
    write(damaged);
    EXPECT_EQ(refusal(), "") << damaged;
  }
}

TEST_F(FolderFormat, OfAnotherNumberIsRefusedWithWhatToDo) {
  write(R"({"format": 2, "wold": "0.9.0"})");
  EXPECT_THAT(refusal(), AllOf(HasSubstr(out().string() + ", an output folder of format 2"),
                               HasSubstr("that wold 0.9.0 has made"), HasSubstr("format 1"),
                               HasSubstr("wold render " + out().string() + "/scene.toml --out")));
  // 1 in 32 bits, and what is no whole number of 64.
  for (const std::string other : {"0", "-1", "4294967297", "18446744073709551615"}) {
    write("{\"format\": " + other + "}");
    EXPECT_THAT(refusal(), HasSubstr("another version")) << other;
  }
}

// Whoever made the folder may have written anything there.
TEST_F(FolderFormat, OfStrangersShowsNoControlCharacters) {
  write(R"({"format": 2, "wold": "\u001b[2J"})");
  EXPECT_THAT(refusal(), HasSubstr("wold ?[2J"));
}

}  // namespace
}  // namespace wold::work
