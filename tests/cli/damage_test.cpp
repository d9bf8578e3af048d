#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/files.h"
#include "tiny_film.h"

/// Files that are no longer what was written, and clocks that jumped.
namespace wold::test {
namespace {

std::string cut(const std::string& bytes) { return bytes.substr(0, bytes.size() / 2); }
std::string emptied(const std::string&) { return {}; }
std::string garbled(const std::string& bytes) { return std::string(bytes.size(), '\xA5'); }
std::string with_a_bit_flipped(const std::string& bytes) {
  std::string other = bytes;
  if (!other.empty()) other[other.size() / 2] ^= 0x10;
  return other;
}

using Harm = std::string (*)(const std::string&);
constexpr Harm harms[] = {cut, emptied, garbled, with_a_bit_flipped};

class Damaged : public TinyFilm {
 protected:
  void SetUp() override {
    TinyFilm::SetUp();
    if (IsSkipped()) return;
    fs::copy(folder_ / "undisturbed", folder_ / "out", fs::copy_options::recursive);
  }

  /// In place, as disks do it. Logs are the renderers' own.
  void damage(const fs::path& file, Harm harm) const {
    if (*file.begin() == "logs") return;
    const std::string bytes = harm(read_file(folder_ / "out" / file));
    std::ofstream(folder_ / "out" / file, std::ios::binary) << bytes;
  }
};

TEST_F(Damaged, OneFileOfEachKindByABit) {
  std::map<std::string, fs::path> one;
  for (const fs::path& file : files_below(folder_ / "out"))
    one[file.begin()->string() + file.extension().string()] = file;
  EXPECT_GE(one.size(), 10U);
  for (const auto& [kind, file] : one) {
    SCOPED_TRACE(file);
    damage(file, with_a_bit_flipped);
    expect_goes_on("out");
  }
}

TEST_F(Damaged, AllFilesAtOnceButTheRecords) {
  for (const Harm harm : harms) {
    for (const fs::path& file : files_below(folder_ / "out"))
      if (*file.begin() != "tasks") damage(file, harm);
    expect_goes_on("out");
  }
}

TEST_F(Damaged, AllRecordsAtOnce) {
  for (const Harm harm : harms) {
    for (const fs::path& file : files_below(folder_ / "out/tasks")) damage("tasks" / file, harm);
    expect_goes_on("out");
  }
}

TEST_F(Damaged, ARecordCannotHaveFilesElsewhereRemoved) {
  write("precious", "mine");
  const fs::path record = folder_ / "out/tasks/povray_0001.json";
  const std::string text = read_file(record);
  const std::string picture = "frames/povray/0001.png";
  for (const std::string& elsewhere :
       {std::string("../precious"), (folder_ / "precious").string()}) {
    std::string changed = text;
    changed.replace(changed.find(picture), picture.size(), elsewhere);
    write_file(record, changed);
    expect_goes_on("out");
    EXPECT_EQ(read_file(folder_ / "precious"), "mine");
  }
}

// A stranger's folder: its records say of the edited files what they say of sound ones.
TEST_F(Damaged, ForPovrayDataAreNumbersAndItsSettingsOursWhateverTheRecordsSay) {
  const auto edit = [&](const std::string& name, const std::string& more) {
    const fs::path file = folder_ / "out" / name;
    std::ofstream(file, std::ios::app) << more;
    const fs::path record = folder_ / "out/tasks/scenes_0001.json";
    nlohmann::json json = nlohmann::json::parse(read_file(record));
    json["outputs"][name] = {fs::file_size(file), 0, content_hash(read_file(file))};
    write_file(record, json.dump());
    fs::remove(folder_ / "out/frames/povray/0001.png");
  };
  const std::string cells = "povray/data/frame_0001/cells.txt";
  edit(cells, "\n#fopen File \"../../precious\" write\n#write (File, \"harm\")\n");
  const Result refused = shell(render_line("out"));
  EXPECT_EQ(refused.code, 4);
  expect_contains(refused.err, cells);
  expect_contains(refused.err, "found \"#fopen File");
  EXPECT_FALSE(fs::exists(folder_ / "precious"));
  fs::remove(folder_ / "out" / cells);
  edit("povray/povray.ini", "Pre_Scene_Command=touch ../../precious\n");
  EXPECT_EQ(shell(render_line("out")).code, 0);
  EXPECT_FALSE(fs::exists(folder_ / "precious"));
  expect_goes_on("out");
}

TEST_F(Damaged, TimesOfFilesMeanNothing) {
  const auto pictures = [&] { return times("out/frames"); };
  for (const std::string day : {"1970-01-01T12:00:00Z", "2106-01-01T12:00:00Z"}) {
    ASSERT_EQ(shell("find out -exec touch -d " + day + " {} +").code, 0);
    const auto before = pictures();
    expect_goes_on("out");
    EXPECT_THAT(different(pictures(), before), testing::IsEmpty()) << "nothing to do";
  }
  const Result result = shell(render_line("out") + " --set camera.field_of_view=50");
  EXPECT_EQ(result.code, 0) << result.err;
  expect_goes_on("out");
}

}  // namespace
}  // namespace wold::test
