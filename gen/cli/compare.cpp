#include "cli/commands.h"
#include "compare/compare_command.h"
#include "console/output.h"

namespace wold::cli {

ExitCode run_compare(const CompareOptions& options) {
  const compare::Verdict verdict =
      compare::compare_paths(options.got, options.want, options.limits, options.report);
  console::print_data(verdict.json);
  if (verdict.code == ExitCode::different) console::print_message(verdict.lines);
  if (!options.report.empty())
    console::print_message("see " + (options.report / "index.html").string());
  return verdict.code;
}

}  // namespace wold::cli
