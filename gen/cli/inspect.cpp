#include "compare/inspect.h"

#include "cli/commands.h"
#include "console/output.h"

namespace wold::cli {

ExitCode run_inspect(const std::vector<std::filesystem::path>& files, bool json) {
  std::string text;
  bool sound = true;
  for (const std::filesystem::path& file : files) {
    const compare::Inspection inspection = compare::inspect(file);
    sound = sound && inspection.problems.empty();
    const char* separator = text.empty() ? "" : json ? ",\n" : "\n";
    text += separator + (json ? inspection.json : inspection.text);
  }
  console::print_data(json ? "[\n" + text + "]\n" : text);
  return sound ? ExitCode::done : ExitCode::file;
}

}  // namespace wold::cli
