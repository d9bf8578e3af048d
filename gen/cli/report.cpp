#include "cli/commands.h"
#include "cli/output.h"
#include "cli/report_facts.h"
#include "cli/report_page.h"
#include "core/files.h"

namespace wold::cli {

ExitCode run_report(const std::filesystem::path& out, const std::filesystem::path& page,
                    Progress& progress) {
  const std::filesystem::path file = page.empty() ? out / "report.html" : page;
  write_file(file, report_page(report_facts(out), progress));
  print_data(file.string() + "\n");
  return ExitCode::done;
}

}  // namespace wold::cli
