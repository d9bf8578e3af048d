#include "work/shared_files.h"

namespace wold::work {

SharedFiles::SharedFiles(const TaskRecords& records) {
  records.for_each([&](const std::string& stage, const TaskRecord& record) {
    if (stage == name_of(Stage::scenes)) add(record);
  });
}

void SharedFiles::add(const TaskRecord& frame) {
  if (frame.removed) return;
  for (const auto& [name, state] : frame.outputs) ++frames_[name];
}

void SharedFiles::take_away(const TaskRecord& frame) {
  if (frame.removed) return;
  for (const auto& [name, state] : frame.outputs)
    if (const auto found = frames_.find(name); found != frames_.end() && --found->second == 0)
      frames_.erase(found);
}

}  // namespace wold::work
