#include "small_film.h"

#include <fmt/format.h>

#include <fstream>
#include <thread>

#include "core/files.h"

namespace wold::test {
namespace {

constexpr const char* scene = R"(name = "small"
seed = 3
[terrain]
size = 6
samples = 49
[grass]
blades = 40
variants = 2
levels = [62, 30]
key_frames = [0.0, 0.5, 1.0]
pixels_per_voxel = 0.6
[ageing]
frames = [0.1, 0.8]
[camera]
eye = [3, 0.5]
target = [3, 1.6]
target_height = 0
[render]
size = [64, 36]
samples = 1
)";

}  // namespace

void SmallFilm::SetUp() {
  Program::SetUp();
  write("small.toml", scene);
}

std::map<std::string, std::string> SmallFilm::contents(const std::string& folder) const {
  std::map<std::string, std::string> hashes;
  for (const fs::path& file : files_below(folder_ / folder))
    if (file != "manifest.json" && *file.begin() != "logs" && *file.begin() != "tasks")
      hashes[file.string()] = content_hash(read_file(folder_ / folder / file));
  return hashes;
}

std::map<std::string, fs::file_time_type> SmallFilm::times(const std::string& folder) const {
  std::map<std::string, fs::file_time_type> times;
  for (const fs::path& file : files_below(folder_ / folder))
    times[file.string()] = fs::last_write_time(folder_ / folder / file);
  return times;
}

void SmallFilm::expect_nothing_half_written(const std::string& folder) const {
  std::string checked;
  for (const fs::path& file : files_below(folder_ / folder)) {
    EXPECT_FALSE(file.filename().string().starts_with(".")) << file;
    const std::string kind = file.extension().string();
    if (kind == ".vdb" || kind == ".df3" || kind == ".png" || kind == ".exr")
      checked += " ./" + quoted((folder / file).string());
  }
  if (checked.empty()) return;
  const Result result = wold("inspect" + checked);
  EXPECT_EQ(result.code, 0) << result.out << result.err;
}

std::string SmallFilm::blender_played_by(const std::string& body, const FakeBlender& fake) const {
  const std::string head = fake_blender_head((folder_ / "probes").string(), fake);
  write("fake.sh", fmt::format(R"({}cd '{}'
while [ $# -gt 0 ]; do
  case $1 in --) scene=$2; frame=$3 ;; --out) out=$2 ;; esac
  shift
done
echo $frame >> calls
good=good_$frame.png
paint() {{ '{}' "$scene/data/frame_000$frame/expected.json" $good 64 36 $1; }}
paint
{}
)",
                               head, folder_.string(), WOLD_PAINTER, body));
  fs::permissions(folder_ / "fake.sh", fs::perms::owner_all);
  return "WOLD_BLENDER='" + (folder_ / "fake.sh").string() + "' XDG_CACHE_HOME='" +
         (folder_ / ".cache").string() + "'";
}

std::string SmallFilm::calls() const {
  std::ifstream file(folder_ / "calls");
  std::string frames;
  for (std::string frame; std::getline(file, frame);) frames += frame + " ";
  fs::remove(folder_ / "calls");
  return frames;
}

std::vector<fs::path> files_below(const fs::path& folder) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path().lexically_relative(folder));
  return files;
}

bool eventually(const std::function<bool()>& happens) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!happens()) {
    if (std::chrono::steady_clock::now() > give_up) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return true;
}

bool is_gone(const fs::path& pid_file) {
  std::string pid = read_file(pid_file);
  pid.erase(pid.find_last_not_of('\n') + 1);
  std::ifstream stat("/proc/" + pid + "/stat");
  const std::string text{std::istreambuf_iterator<char>(stat), {}};
  return text.empty() || text.find(") Z ") != std::string::npos;
}

}  // namespace wold::test
