#include <fmt/format.h>

#include "cli/commands.h"
#include "console/output.h"
#include "core/files.h"
#include "report/report_facts.h"
#include "report/report_page.h"

namespace wold::cli {
namespace {

/// What the page is made of must not be replaced by it.
void check_name(const std::filesystem::path& page) {
  const std::string extension = page.extension().string();
  if (extension != ".html" && extension != ".htm")
    throw InputError(
        fmt::format("--out: found {}, expected a file name that ends in .html", page.string()));
}

}  // namespace

ExitCode run_report(const std::filesystem::path& out, const std::filesystem::path& page,
                    Progress& progress) {
  const std::filesystem::path file = page.empty() ? out / "report.html" : page;
  check_name(file);
  write_file(file, report::report_page(report::report_facts(out), progress));
  console::print_data(file.string() + "\n");
  return ExitCode::done;
}

}  // namespace wold::cli
