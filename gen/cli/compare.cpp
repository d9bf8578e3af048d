#include "cli/commands.h"
#include "cli/output.h"
#include "compare/compare_command.h"

namespace wold::cli {

ExitCode run_compare(const CompareOptions& options) {
  std::string metrics;
  const ExitCode verdict =
      compare::compare_files(options.got, options.want, options.limits, options.report, metrics);
  print_data(metrics);
  return verdict;
}

}  // namespace wold::cli
