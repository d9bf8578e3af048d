#include "work/task_record.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file_list.h"
#include "core/files.h"

namespace wold::work {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;
/// For reading: it finds keys without looking at all of them, however many a file has.
using ReadJson = nlohmann::json;

std::string file_name(const Task& task) {
  return fmt::format("{}_{:04}.json", name_of(task.stage), task.index);
}

Json json_of(const Task& task, const TaskRecord& record) {
  Json outputs = Json::object();
  for (const auto& [name, state] : record.outputs)
    outputs[name] = {state.bytes, state.modified_ns, state.hash};
  Json json = {{"version", 1},
               {"stage", name_of(task.stage)},
               {"index", task.index},
               {"source", record.source},
               {"scene", record.facts},
               {"seconds", record.seconds},
               {"memory_bytes", record.memory_bytes},
               {"outputs", std::move(outputs)}};
  if (record.removed) json["removed"] = true;
  return json;
}

/// A damaged record must not have files elsewhere removed.
void require_below(const std::string& name) {
  const fs::path path = fs::path(name).lexically_normal();
  const bool is_below = !path.empty() && path.is_relative() && path != "." && *path.begin() != "..";
  // Where the system takes a name to end.
  if (!is_below || name.find('\0') != std::string::npos)
    throw FileError(fmt::format("found {}, expected a file below the output folder", name));
}

template <class Whole>
Whole whole_number(const ReadJson& json) {
  if (!json.is_number_integer()) throw FileError("expected a whole number");
  return json.get<Whole>();
}

TaskRecord record_of(const ReadJson& json) {
  TaskRecord record{json.at("source").get<std::string>(),
                    json.at("scene").get<std::string>(),
                    {},
                    json.at("seconds").get<double>(),
                    json.at("memory_bytes").get<double>(),
                    json.value("removed", false)};
  for (const auto& [name, state] : json.at("outputs").items()) {
    require_below(name);
    record.outputs[name] = {whole_number<std::uintmax_t>(state.at(0)),
                            whole_number<std::int64_t>(state.at(1)),
                            state.at(2).get<std::string>()};
  }
  return record;
}

/// What a reader makes of a file's JSON; nothing when it is missing or damaged, since then the work
/// is done again.
template <class Reader>
auto read_json(const fs::path& path, const Reader& reader)
    -> std::optional<decltype(reader(ReadJson()))> {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return std::nullopt;
  try {
    return reader(ReadJson::parse(read_file(path)));
  } catch (const ReadJson::exception&) {
    return std::nullopt;
  } catch (const FileError&) {
    return std::nullopt;
  }
}

}  // namespace

std::optional<TaskRecord> TaskRecords::read(const Task& task) const {
  return read_json(folder_ / file_name(task), record_of);
}

void TaskRecords::write(const Task& task, const TaskRecord& record) const {
  write_file(folder_ / file_name(task), json_of(task, record).dump() + "\n");
}

SceneFacts TaskRecords::read_facts(const std::string& hash) const {
  return read_json(folder_ / fmt::format("scene_{}.json", hash),
                   [](const ReadJson& json) { return json.get<SceneFacts>(); })
      .value_or(SceneFacts{});
}

void TaskRecords::write_facts(const SceneFacts& facts) const {
  update_file(folder_ / fmt::format("scene_{}.json", hash_of(facts)), Json(facts).dump(1) + "\n");
}

void TaskRecords::for_each(
    const std::function<void(const std::string&, const TaskRecord&)>& visit) const {
  for (const fs::path& path : files_below(folder_)) {
    const std::string name = path.stem().string();
    if (const auto record = read_json(path, record_of))
      visit(name.substr(0, name.rfind('_')), *record);
  }
}

}  // namespace wold::work
