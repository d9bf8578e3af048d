#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <string_view>

#include "core/files.h"
#include "temporary_folder.h"
#include "work/own_folder.h"
#include "work/task_record.h"

namespace {

using namespace wold;

/// Below the output folder, and not the folder itself.
bool is_below(const std::string& name) {
  const auto path = std::filesystem::path(name).lexically_normal();
  return !path.empty() && path.is_relative() && path != "." && *path.begin() != ".." &&
         name.find('\0') == std::string::npos;
}

bool same(const work::TaskRecord& a, const work::TaskRecord& b) {
  const auto same_file = [](const auto& x, const auto& y) {
    return x.first == y.first && x.second.bytes == y.second.bytes &&
           x.second.modified_ns == y.second.modified_ns && x.second.hash == y.second.hash;
  };
  return a.source == b.source && a.facts == b.facts && a.seconds == b.seconds &&
         a.memory_bytes == b.memory_bytes && a.outputs.size() == b.outputs.size() &&
         std::equal(a.outputs.begin(), a.outputs.end(), b.outputs.begin(), same_file);
}

}  // namespace

/// Any bytes are a task's record, a list of files and a scene's facts, or count as missing; what
/// was read names files below the output folder alone, and can be written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
  static const test::TemporaryFolder folder("fuzz_records");
  const std::string_view text(reinterpret_cast<const char*>(bytes), count);
  make_folder(folder.path() / "tasks");
  write_file(folder.path() / "tasks/texels_0001.json", text);
  write_file(folder.path() / "tasks/scene_found.json", text);
  write_file(folder.path() / "manifest.json", text);
  work::is_own_manifest(folder.path() / "manifest.json");
  const work::TaskRecords records(folder.path());
  if (const auto record = records.read({work::Stage::texels, 1})) {
    for (const auto& output : record->outputs)
      if (!is_below(output.first)) std::abort();
    const work::Task copy{work::Stage::texels, 2};
    records.write(copy, *record);
    const auto again = records.read(copy);
    if (!again || !same(*again, *record)) std::abort();
  }
  if (const work::SceneFacts facts = records.read_facts("found"); !facts.empty()) {
    records.write_facts(facts);
    if (records.read_facts(work::hash_of(facts)) != facts) std::abort();
    std::filesystem::remove(folder.path() / ("tasks/scene_" + work::hash_of(facts) + ".json"));
  }
  return 0;
}
