#pragma once

#include <string>

#include "core/progress.h"
#include "report/report_facts.h"

namespace wold::report {

/// The page, templates/report/page.html filled in: pictures, times, curves and parameters, all in
/// one text. Pictures are shrunk, and of very long films frames are left out, so that it stays
/// below about 30 MB; the page says so. The same folder gives the same bytes. Throws FileError,
/// and InterruptedError from `progress`.
std::string report_page(const ReportFacts& facts, Progress& progress);

}  // namespace wold::report
