#include "work/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/duration_text.h"
#include "core/error.h"
#include "film/exporters.h"
#include "scene/text.h"
#include "work/disk_budget.h"

namespace wold::work {
namespace {

using Json = nlohmann::ordered_json;

/// Names of files need not be text.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<TaskGroup> grouped(Work& work, const StageTasks& tasks) {
  std::vector<TaskGroup> groups;
  std::map<std::pair<Need, std::string>, std::size_t> known;
  for (const int index : tasks.indices) {
    const Verdict verdict = work.verdict({tasks.stage, index});
    const auto [group, is_new] = known.try_emplace({verdict.need, verdict.why}, groups.size());
    if (is_new) groups.push_back({{}, verdict});
    groups[group->second].indices.push_back(index);
  }
  return groups;
}

std::string_view word_of(Need need) {
  constexpr std::string_view words[] = {"no", "perhaps", "yes"};
  return words[static_cast<std::size_t>(need)];
}

std::string size_text(double bytes) {
  return bytes < 1e9 ? fmt::format("{:.0f} MB", bytes / 1e6)
                     : fmt::format("{:.1f} GB", bytes / 1e9);
}

std::string after_text(const StageTasks& tasks) {
  if (tasks.after_all) return fmt::format(", after all {}", name_of(*tasks.after_all));
  if (tasks.after_same)
    return fmt::format(", each after the same of {}", name_of(*tasks.after_same));
  return {};
}

std::string group_text(const TaskGroup& group) {
  return fmt::format("    {}: {}\n", ranges_text(group.indices),
                     group.verdict.need == Need::no ? "done" : group.verdict.why);
}

Json after_json(const StageTasks& tasks) {
  if (tasks.after_all) return {{"stage", name_of(*tasks.after_all)}, {"tasks", "all"}};
  if (tasks.after_same) return {{"stage", name_of(*tasks.after_same)}, {"tasks", "same"}};
  return nullptr;
}

Json stage_json(const StagePlan& stage) {
  Json groups = Json::array();
  for (const TaskGroup& group : stage.groups)
    groups.push_back({{"indices", ranges_text(group.indices)},
                      {"runs", word_of(group.verdict.need)},
                      {"why", group.verdict.why}});
  return {{"stage", name_of(stage.tasks.stage)},
          {"indices", ranges_text(stage.tasks.indices)},
          {"tasks", stage.tasks.indices.size()},
          {"after", after_json(stage.tasks)},
          {"runs", stage.runs},
          {"perhaps", stage.perhaps},
          {"estimate",
           {{"seconds", stage.each.seconds},
            {"memory_bytes", stage.each.memory_bytes},
            {"disk_bytes", stage.each.disk_bytes},
            {"from", stage.each.measured ? "records" : "model"}}},
          {"groups", std::move(groups)}};
}

/// In a template "{{" begins an expression, and nothing else can be meant by it.
void require_no_expression(std::string_view text) {
  if (text.find("{{") != std::string_view::npos)
    throw InputError(fmt::format(
        "--openjd: found {}, expected no \"{{{{\" in what a job template repeats: there "
        "it begins an expression",
        scene::in_quotes(text)));
}

/// The options of a plan that change what its tasks make.
std::vector<std::string> task_options(const RenderOptions& options) {
  std::vector<std::string> arguments = {"--out", "{{Param.Out}}"};
  if (!options.frames.numbers.empty())
    arguments.insert(arguments.end(), {"--frames", ranges_text(options.frames.numbers)});
  for (const std::string& shot : options.frames.shots)
    arguments.insert(arguments.end(), {"--shot", shot});
  if (!options.passes.empty()) arguments.insert(arguments.end(), {"--passes", options.passes});
  for (const exporter::Exporter* one : film::exporters())
    if (const auto chosen = options.programs.find(one->name);
        chosen != options.programs.end() && !chosen->second.empty())
      arguments.insert(arguments.end(), {one->renderer->program.option, chosen->second});
  if (options.threads > 0)
    arguments.insert(arguments.end(), {"--threads", std::to_string(options.threads)});
  for (const std::string& change : options.overrides)
    arguments.insert(arguments.end(), {"--set", change});
  return arguments;
}

Json step_json(const std::string& name, std::vector<std::string> arguments,
               const std::vector<std::string>& options) {
  arguments.insert(arguments.end(), options.begin(), options.end());
  return {{"name", name},
          {"script", {{"actions", {{"onRun", {{"command", "wold"}, {"args", arguments}}}}}}}};
}

Json dependencies_json(const std::vector<std::string_view>& stages) {
  Json list = Json::array();
  for (const std::string_view stage : stages) list.push_back({{"dependsOn", stage}});
  return list;
}

Json stage_step(const StagePlan& stage, const std::vector<std::string>& options) {
  const std::string name(name_of(stage.tasks.stage));
  Json step = step_json(name, {"task", "{{Param.Scene}}", name, "{{Task.Param.Index}}"}, options);
  step["parameterSpace"] = {
      {"taskParameterDefinitions",
       Json::array(
           {{{"name", "Index"}, {"type", "INT"}, {"range", ranges_text(stage.tasks.indices)}}})}};
  const auto after = stage.tasks.after_all ? stage.tasks.after_all : stage.tasks.after_same;
  if (after) step["dependencies"] = dependencies_json({name_of(*after)});
  return step;
}

/// Whether another stage of the plan begins after it.
bool is_waited_for(const Stage& stage, const std::vector<StagePlan>& plan) {
  return std::ranges::any_of(plan, [&](const StagePlan& other) {
    return other.tasks.after_all == stage || other.tasks.after_same == stage;
  });
}

/// Defaults have to be beneath the template's directory and relative to it, taken to be the current
/// one; the value of any other path has to be given with the job.
Json path_parameter(const char* name, const char* kind, const char* flow,
                    const std::filesystem::path& path) {
  Json parameter = {{"name", name}, {"type", "PATH"}, {"objectType", kind}, {"dataFlow", flow}};
  const std::filesystem::path relative =
      std::filesystem::absolute(path).lexically_normal().lexically_relative(
          std::filesystem::current_path());
  if (!relative.empty() && *relative.begin() != "..") parameter["default"] = relative.string();
  return parameter;
}

}  // namespace

std::vector<StagePlan> make_plan(const Job& job) {
  Work work(job);
  std::vector<StagePlan> plan;
  for (const StageTasks& tasks : stages_of(job)) {
    StagePlan stage{tasks, estimate(job, tasks, work), grouped(work, tasks)};
    for (const TaskGroup& group : stage.groups) {
      if (group.verdict.need == Need::yes) stage.runs += group.indices.size();
      if (group.verdict.need == Need::perhaps) stage.perhaps += group.indices.size();
    }
    stage.disk_bytes =
        bytes_at_once(job, tasks.stage, stage.runs + stage.perhaps, stage.each, work);
    plan.push_back(std::move(stage));
  }
  return plan;
}

namespace {

/// What all that is to be done takes, and what is free.
std::string total_text(const Job& job, const std::vector<StagePlan>& plan) {
  double seconds = 0.0, disk_bytes = 0.0, memory_bytes = 0.0;
  for (const StagePlan& stage : plan) {
    const auto tasks = static_cast<double>(stage.runs + stage.perhaps);
    if (tasks == 0.0) continue;
    seconds += tasks * stage.each.seconds;
    disk_bytes += stage.disk_bytes;
    memory_bytes = std::max(memory_bytes, stage.each.memory_bytes);
  }
  if (seconds == 0.0) return {};
  const std::optional<double> free = free_bytes(job.out);
  return fmt::format("  in all  {}, up to {} of memory, {} of disk{}\n", duration_text(seconds),
                     size_text(memory_bytes), size_text(disk_bytes),
                     free ? fmt::format(" ({} are free)", size_text(*free)) : "");
}

}  // namespace

std::string plan_text(const Job& job, const std::vector<StagePlan>& plan, bool why) {
  std::string text = summary(job);
  for (const StagePlan& stage : plan) {
    const std::string perhaps =
        stage.perhaps > 0 ? fmt::format(" and perhaps {}", stage.perhaps) : "";
    text += fmt::format("  {:8}{} of {} to do{}; each {}, {} of memory, {} of disk ({}){}\n",
                        name_of(stage.tasks.stage), stage.runs, stage.tasks.indices.size(), perhaps,
                        duration_text(stage.each.seconds), size_text(stage.each.memory_bytes),
                        size_text(stage.each.disk_bytes),
                        stage.each.measured ? "measured" : "guessed", after_text(stage.tasks));
    if (why)
      for (const TaskGroup& group : stage.groups) text += group_text(group);
  }
  return text + total_text(job, plan);
}

std::string plan_json(const Job& job, const std::vector<StagePlan>& plan) {
  Json stages = Json::array();
  for (const StagePlan& stage : plan) stages.push_back(stage_json(stage));
  const Json json = {{"version", 1},
                     {"scene", job.scene.name},
                     {"out", job.out.string()},
                     {"frames", ranges_text(job.frames)},
                     {"stages", std::move(stages)}};
  return text_of(json);
}

std::string plan_openjd(const RenderOptions& options, const Job& job,
                        const std::vector<StagePlan>& plan) {
  const std::vector<std::string> with = task_options(options);
  for (const std::string& argument : with)
    if (argument != "{{Param.Out}}") require_no_expression(argument);
  require_no_expression(job.scene.name);
  Json steps = Json::array();
  std::vector<std::string_view> last;
  for (const StagePlan& stage : plan) {
    steps.push_back(stage_step(stage, with));
    if (!is_waited_for(stage.tasks.stage, plan)) last.push_back(name_of(stage.tasks.stage));
  }
  // Finds everything there and lists it in manifest.json.
  std::vector<std::string> last_command = {"render", "{{Param.Scene}}"};
  if (options.keep != Keep::all)
    last_command.insert(last_command.end(), {"--keep", std::string(word_of(options.keep))});
  steps.push_back(step_json("manifest", last_command, with));
  steps.back()["dependencies"] = dependencies_json(last);
  const Json json = {
      {"specificationVersion", "jobtemplate-2023-09"},
      {"name", job.scene.name},
      {"parameterDefinitions", Json::array({path_parameter("Scene", "FILE", "IN", options.scene),
                                            path_parameter("Out", "DIRECTORY", "OUT", job.out)})},
      {"steps", std::move(steps)}};
  return text_of(json);
}

}  // namespace wold::work
