#include "cli/commands.h"
#include "console/output.h"
#include "pages/explanation_json.h"
#include "pages/scene_schema.h"
#include "scene/explanation.h"
#include "scene/write.h"

namespace wold::cli {

ExitCode run_explain(const std::string& name, bool json) {
  console::print_data(json ? pages::explanation_json(name) : scene::explanation(name));
  return ExitCode::done;
}

ExitCode run_schema() {
  console::print_data(pages::scene_schema());
  return ExitCode::done;
}

ExitCode run_help_keys() {
  console::print_data(scene::keys_markdown());
  return ExitCode::done;
}

}  // namespace wold::cli
