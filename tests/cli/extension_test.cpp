#include <gmock/gmock.h>

#include "core/files.h"
#include "core/version.h"
#include "core/zip_archive.h"
#include "program.h"

/// Blender's package as an archive, read back by Python's reader.
namespace wold::test {
namespace {

const std::string archive = std::string("wold_blender-") + version + ".zip";

class Extension : public Program {
 protected:
  /// "NAME BYTES DATE" of everything in an archive whose sums are right.
  std::string listing(const std::string& file) const {
    write("list.py",
          "import sys, zipfile\nwith zipfile.ZipFile(sys.argv[1]) as archive:\n"
          "    assert archive.testzip() is None\n"
          "    for entry in archive.infolist():\n"
          "        print(entry.filename, entry.file_size, *entry.date_time[:3])\n");
    const Result result = shell("python3 list.py " + quoted(file));
    EXPECT_EQ(result.code, 0) << result.err;
    return result.out;
  }
};

TEST_F(Extension, ArchivesAreReadByOthersAndAlwaysTheSame) {
  const std::vector<ArchivedFile> files = {{"top/empty", ""},
                                           {"top/within/\xC3\xA9.bin", std::string("a\0b", 3)}};
  const std::string bytes = zip_archive(files);
  write("a.zip", bytes);
  EXPECT_EQ(listing("a.zip"), "top/empty 0 1980 1 1\ntop/within/\xC3\xA9.bin 3 1980 1 1\n");
  EXPECT_EQ(zip_archive(files), bytes);
}

TEST_F(Extension, HoldsThePackageInAFolderOfItsName) {
  const Result result = wold("extension --out 'a b'");
  EXPECT_EQ(result.code, 0) << result.err;
  EXPECT_EQ(result.out, "a b/" + archive + "\na b/wold_render.py\n");
  expect_contains(result.err, "install-file");
  const std::string names = listing("a b/" + archive);
  expect_contains(names, "wold_blender/__init__.py ");
  expect_contains(names, "wold_blender/blender_manifest.toml ");
  EXPECT_EQ(names.find("__pycache__"), std::string::npos) << names;
  EXPECT_EQ(read_file(folder_ / "a b/wold_render.py"),
            read_file(shipped_file("templates/blender/wold_render.py")));
}

TEST_F(Extension, ReplacesItsOwnFilesOnlyAndWholly) {
  ASSERT_EQ(wold("extension --out x").code, 0);
  const std::string bytes = read_file(folder_ / "x" / archive);
  write("x/" + archive, "old");
  write("x/mine.txt", "a user's own");
  ASSERT_EQ(wold("extension --out x").code, 0);
  EXPECT_EQ(read_file(folder_ / "x" / archive), bytes);
  EXPECT_EQ(read_file(folder_ / "x/mine.txt"), "a user's own");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "x"), {}), 3);
  write("file", "");
  EXPECT_EQ(wold("extension --out file").code, 4);
  EXPECT_EQ(wold("extension").code, 2);
}

}  // namespace
}  // namespace wold::test
