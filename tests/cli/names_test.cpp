#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "core/files.h"
#include "core/image.h"
#include "tiny_film.h"

/// Names that a shell, POV-Ray's language, Python or a locale could take for something else.
namespace wold::test {
namespace {

/// What is run would make a file "touched".
constexpr const char* odd =
    "-a \"b' $(touch touched) `touch touched`;touch touched\n\xC3\xA9 %04d #{x}";

class Names : public TinyFilm {
 protected:
  void SetUp() override {
    TinyFilm::SetUp();
    if (IsSkipped()) return;
    fs::create_directory(folder_ / odd);
    fs::copy(folder_ / "tiny.toml", folder_ / odd / "-tiny.toml");
  }

  Result in_odd_folder(const std::string& command) const {
    return shell("cd -- " + quoted(odd) + " && " + command);
  }

  /// The environment of a locale with a decimal comma.
  std::string german() const {
    EXPECT_EQ(shell("localedef -i de_DE -f UTF-8 ./de_DE.UTF-8").code, 0);
    return "LOCPATH=" + quoted(folder_.string()) + " LC_ALL=de_DE.UTF-8";
  }

  void expect_nothing_else() const {
    for (const fs::path& file : files_below(folder_)) EXPECT_NE(file.filename(), "touched");
    for (const auto& entry : fs::directory_iterator(folder_ / odd))
      EXPECT_THAT(entry.path().filename(), testing::AnyOf("-tiny.toml", "-x", "-y")) << entry;
  }
};

TEST_F(Names, OfFoldersMayBeAnything) {
  const Result made = in_odd_folder(command("render ./-tiny.toml --quiet --out=-x"));
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_EQ(made.out,
            "-x/frames/povray/0001.png\n-x/frames/povray/0002.png\n"
            "-x/frames/povray/0003.png\n");
  expect_undisturbed((fs::path(odd) / "-x").string());
  const Result twice = in_odd_folder(command("task ./-tiny.toml povray 2 --quiet --out=-x"));
  EXPECT_EQ(twice.code, 0) << twice.err;
  for (const std::string form : {"--json", "--openjd", "--why"})
    EXPECT_EQ(in_odd_folder(command("plan ./-tiny.toml --out=-x " + form)).code, 0) << form;
  expect_nothing_else();
  const std::string alone = quoted((fs::path(odd) / "-x/povray").string());
  EXPECT_EQ(shell("cd -- " + alone + " && povray scene.pov -D 2>/dev/null").code, 0);
  EXPECT_EQ(read_image(folder_ / odd / "-x/povray/scene.png").width, 32);
}

TEST_F(Names, OfFoldersMayBeAnythingForBlenderInAGermanLocale) {
  if (!can_render("blender")) GTEST_SKIP() << "no complete blender on this machine";
  const std::string render = "render ./-tiny.toml --quiet --renderer blender --frames 1 --out=";
  EXPECT_EQ(in_odd_folder(command(render + "-x")).code, 0);
  const Result made = in_odd_folder(command(render + "-y", german()));
  EXPECT_EQ(made.code, 0) << made.err;
  const auto here = [](const char* out) { return (fs::path(odd) / out).string(); };
  EXPECT_THAT(different(contents(here("-y")), contents(here("-x"))), testing::IsEmpty());
  expect_nothing_else();
  const std::string alone = quoted(here("-x/blender"));
  ASSERT_EQ(wold("extension --out package").code, 0);
  const std::string script = quoted((folder_ / "package/wold_render.py").string());
  const Result result =
      shell("cd -- " + alone + " && blender -b --python-exit-code 1 -P " + script + " -- . 1");
  EXPECT_EQ(result.code, 0) << result.out << result.err;
  EXPECT_EQ(read_file(folder_ / here("-x/blender/frame_0001.png")).substr(1, 3), "PNG");
}

TEST_F(Names, ADecimalCommaChangesNoByte) {
  const std::string german = this->german();
  ASSERT_EQ(shell("env " + german + " /usr/bin/printf %.1f 1").out, "1,0") << "no German here";
  const Result made = shell(render_line("german", german));
  EXPECT_EQ(made.code, 0) << made.err;
  expect_undisturbed("german");
}

TEST_F(Names, NeedNotBeText) {
  const std::string out = "\xFF\xFE";
  ASSERT_EQ(shell(render_line(quoted(out))).code, 0);
  write(out + "/mine \xC3", "a user's own");
  const Result made = shell(render_line(quoted(out)));
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(nlohmann::json::accept(read_file(folder_ / out / "manifest.json")));
  const Result plan = wold("plan tiny.toml --json --out " + quoted(out));
  EXPECT_EQ(plan.code, 0) << plan.err;
  EXPECT_TRUE(nlohmann::json::accept(plan.out));
  fs::remove(folder_ / out / "mine \xC3");
  expect_undisturbed(out);
}

TEST_F(Names, OfASceneAreFileNames) {
  for (const std::string name :
       {"../../x", "/tmp/x", "..", "a/b", "\"; os.system(\"touch touched\") #", "\"}; #declare x",
        "-x", "", "a\\nb"}) {
    const Result result = wold("render tiny.toml --set " + quoted("name='" + name + "'"));
    EXPECT_EQ(result.code, 2) << name;
    expect_contains(result.err, "name: found");
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}

TEST_F(Names, OfFilesThatASceneNamesReachNoRenderer) {
  const std::string evil = "\"; os.system(\"touch touched\") #\"}; #declare x $(touch touched) ../";
  make_folder(folder_ / evil);
  Image mask(9, 9, 1);
  std::fill(mask.values.begin(), mask.values.end(), 1.0F);
  write_image(folder_ / (evil + "m.png"), mask, PixelFormat::uint8);
  Image sky(32, 32, 4);
  for (std::size_t i = 0; i < sky.values.size(); ++i) sky.values[i] = static_cast<float>(i % 7) / 7;
  write_image(folder_ / (evil + "c.png"), sky, PixelFormat::uint8);
  write(evil + "w.csv", "hours,temperature_c\n0,5\n1,6\n");
  std::string heights = "ncols 5\nnrows 5\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int row = 0; row < 5; ++row) heights += "0 1 2 1 0\n";
  write(evil + "e.asc", heights);
  const auto named = [&](const std::string& key, const std::string& kind) {
    return key + " = '''" + evil + kind + "'''\n";
  };
  write("evil.toml", read_file(folder_ / "tiny.toml") + "[growth]\n" + named("mask", "m.png") +
                         "[weather]\n" + named("table", "w.csv") + "[[clouds]]\ntextures = ['''" +
                         evil + "c.png''']\n");
  const Result made = wold("render evil.toml --quiet --frames 1 --out evil --set " +
                           quoted("terrain.elevation='''" + evil + "e.asc'''"));
  EXPECT_EQ(made.code, 0) << made.err;
  for (const fs::path& file : files_below(folder_)) EXPECT_NE(file.filename(), "touched");
  EXPECT_EQ(shell("grep -rlE 'touched|os.system' evil/povray").code, 1) << "a name came through";
}

}  // namespace
}  // namespace wold::test
