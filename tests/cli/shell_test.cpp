#include <fmt/format.h>
#include <gmock/gmock.h>

#include "core/files.h"
#include "program.h"
#include "support/places.h"

/// Completion and manual, judged by the shells and the formatter they are for.
namespace wold::test {
namespace {

using testing::StartsWith;

class Completion : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    make_folder(folder_ / "moor");
    write("heath.toml", "");
    write("heath.txt", "");
  }

  void write_script(const std::string& shell) const {
    const Result script = wold("--completion " + shell);
    EXPECT_EQ(script.code, 0) << script.err;
    write("wold." + shell, script.out);
  }

  /// What a shell offers after a line, one per line.
  std::string bash(const std::string& line) const {
    write("try.bash",
          "source ./wold.bash\ncompopt() { :; }\nCOMP_LINE=$1 COMP_POINT=${#1}\n_wold\n"
          "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
    const Result result = shell("bash -u try.bash " + quoted(line));
    EXPECT_EQ(result.err, "") << line;
    return result.out;
  }
  std::string fish(const std::string& line) const {
    const Result result = shell("HOME=$PWD fish --no-config -c 'source wold.fish; complete -C \"" +
                                line + "\"' | cut -f 1");
    EXPECT_EQ(result.err, "") << line;
    return result.out;
  }
};

TEST_F(Completion, OfBash) {
  write_script("bash");
  EXPECT_EQ(bash("wold re"), "render\nreport\n");
  expect_contains(bash("wold "), "\npreview\n");
  EXPECT_EQ(bash("wold render --gr"), "--grass\n");
  EXPECT_EQ(bash("wold render --grass "), "texels\nblades\nauto\npoints\n");
  EXPECT_EQ(bash("wold render "), "heath.toml\nmoor\n");
  EXPECT_EQ(bash("wold film "), "moor\n");
  EXPECT_EQ(bash("wold inspect heath.tx"), "heath.txt\n");
  EXPECT_EQ(bash("wold check heath.toml --set grass.pix"), "grass.pixels_per_voxel=\n");
  EXPECT_EQ(bash("wold check heath.toml --set clouds[1].sp"), "clouds[1].speed=\n");
  // Bash itself keeps what stands before '='.
  EXPECT_EQ(bash("wold check heath.toml --set render.grass=b"), "blades\n");
  EXPECT_EQ(bash("wold new --kind s"), "snow\nseason\n");
  EXPECT_EQ(bash("wold --completion "), "bash\nzsh\nfish\n");
}

TEST_F(Completion, OfFish) {
  if (!is_installed("fish"))
    GTEST_SKIP() << "no fish on this machine: its completion is not tested";
  write_script("fish");
  EXPECT_EQ(fish("wold re"), "render\nreport\n");
  EXPECT_EQ(fish("wold render --gr"), "--grass\n");
  EXPECT_EQ(fish("wold render --grass "), "auto\nblades\npoints\ntexels\n");
  EXPECT_EQ(fish("wold film "), "moor/\n");
  EXPECT_THAT(fish("wold render h"), StartsWith("heath.toml\n"));
  EXPECT_EQ(fish("wold check heath.toml --set render.grass=b"), "render.grass=blades\n");
}

TEST_F(Completion, OfZsh) {
  if (!is_installed("zsh")) GTEST_SKIP() << "no zsh on this machine: its completion is not tested";
  write_script("zsh");
  // A terminal in which what is typed is completed by two tabs.
  write("try.zsh",
        "zmodload zsh/zpty\nzpty z zsh -f -i\n"
        "zpty -w z 'PS1=; autoload -U compinit; compinit -u -D; source ./wold.zsh; print rea''dy'\n"
        "zpty -r -m z out '*ready*'\n"
        "zpty -w -n z \"$1\"$'\\t\\t'\nzpty -r -m z out \"*$2*\" && print found\n");
  const auto offers = [&](const std::string& line, const std::string& answer) {
    return shell(fmt::format("timeout 20 zsh -f try.zsh {} {}", quoted(line), quoted(answer))).out;
  };
  EXPECT_EQ(offers("wold render --gr", "auto*blades*points*texels"), "found\n");
  EXPECT_EQ(offers("wold check heath.toml --set grass.pix", "els_per_voxel="), "found\n");
  EXPECT_EQ(offers("wold new --kind s", "season*snow"), "found\n");
}

TEST_F(Program, CompletionOfAnUnknownShellIsRefused) {
  const Result result = wold("--completion tcsh");
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.err, "error: --completion: found tcsh, expected one of: bash, zsh, fish\n");
}

TEST_F(Program, TheManualHasEveryCommandAndKeyAndNoFaults) {
  const Result manual = wold("--man");
  EXPECT_EQ(manual.code, 0);
  write("wold.1", manual.out);
  if (!is_installed("man")) GTEST_SKIP() << "no man on this machine: the manual is not tested";
  const Result shown = shell("LC_ALL=C.UTF-8 MANWIDTH=100 MANROFFOPT=-ww man --warnings -l wold.1");
  EXPECT_EQ(shown.code, 0);
  EXPECT_EQ(shown.err, "");
  EXPECT_THAT(shown.out, StartsWith("WOLD(1)"));
  for (const std::string part :
       {"wold render [options] SCENE", "wold inspect [options] FILE...", "--size WxH",
        "wold new meadow --kind season", "grass.pixels_per_voxel", "season_keys.wind_speed",
        "a number from -60 to 50 deg C", "EXIT STATUS"})
    expect_contains(shown.out, part);
}

// Each command's own page is built, whole, and without faults of its making.
TEST_F(Program, EveryCommandHasItsPage) {
  const Result manual = wold("--man");
  for (const std::string command :
       {"render", "generate", "plan", "task", "preview", "maps", "check", "inspect", "compare",
        "curves", "film", "report", "new", "wind", "doctor", "extension"}) {
    expect_contains(manual.out, "\\fBwold\\fR \\fB" + command);
    const Result page = wold(command + " --man");
    EXPECT_EQ(page.code, 0) << page.err;
    EXPECT_EQ(page.out, read_file(pages_folder() / ("wold-" + command + ".1")));
    if (!is_installed("man")) continue;
    write("page.1", page.out);
    const Result shown =
        shell("LC_ALL=C.UTF-8 MANWIDTH=80 MANROFFOPT=-ww man --warnings -l page.1");
    EXPECT_EQ(shown.err, "") << command;
    for (const std::string part : {"DESCRIPTION", command.c_str(), "EXIT STATUS", "SEE ALSO"})
      expect_contains(shown.out, part);
  }
}

}  // namespace
}  // namespace wold::test
