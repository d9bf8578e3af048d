#include "cli/commands.h"
#include "cli/output.h"
#include "compare/compare_command.h"

namespace wold::cli {

ExitCode run_compare(const CompareOptions& options) {
  const compare::Verdict verdict =
      compare::compare_paths(options.got, options.want, options.limits, options.report);
  print_data(verdict.json);
  if (verdict.code == ExitCode::different) print_message(verdict.lines);
  if (!options.report.empty()) print_message("see " + (options.report / "index.html").string());
  return verdict.code;
}

}  // namespace wold::cli
