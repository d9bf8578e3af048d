#include "snow/weather_table.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/error.h"
#include "scene/nearest.h"
#include "terrain/quiet_gdal.h"

namespace wold::snow {
namespace {

std::optional<double> number_in(std::string text) {
  text.erase(0, text.find_first_not_of(" \t"));
  text.erase(text.find_last_not_of(" \t") + 1);
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

/// Reads a table and notes what is wrong with it.
class TableReader {
 public:
  TableReader(const std::filesystem::path& file, const std::vector<TableColumn>& columns)
      : file_(file.string()), columns_(columns), numbers_(columns.size()) {}

  std::vector<std::vector<double>> read() {
    const terrain::QuietGdal quiet;
    const char* const drivers[] = {"CSV", nullptr};
    const char* const options[] = {"HEADERS=YES", nullptr};
    const GDALDatasetUniquePtr table(GDALDataset::Open(
        ("CSV:" + file_).c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options));
    if (!table || table->GetLayerCount() != 1)
      throw FileError(fmt::format("{}: cannot be read as comma-separated values: {}", file_,
                                  CPLGetLastErrorMsg()));
    OGRLayer& layer = *table->GetLayer(0);
    read_header(*layer.GetLayerDefn());
    if (problems_.empty()) read_rows(layer);
    if (!problems_.empty()) throw InputError(std::move(problems_));
    return std::move(numbers_);
  }

 private:
  void note(std::size_t field, std::string message) {
    problems_.push_back({{file_, line_, static_cast<int>(field) + 1}, std::move(message)});
  }

  std::vector<std::string> known_names() const {
    std::vector<std::string> names;
    for (const TableColumn& column : columns_) names.push_back(column.name);
    return names;
  }

  void read_header(const OGRFeatureDefn& header) {
    const std::vector<std::string> known = known_names();
    std::vector<std::string> found;
    for (int field = 0; field < header.GetFieldCount(); ++field) {
      const std::string name = header.GetFieldDefn(field)->GetNameRef();
      const auto place = std::find(known.begin(), known.end(), name);
      if (place == known.end())
        note(found.size(),
             fmt::format("found a column \"{}\", expected {}{}", name, fmt::join(known, ", "),
                         scene::suggestion(scene::nearest(name, known))));
      else if (std::find(found.begin(), found.end(), name) != found.end())
        note(found.size(), fmt::format("found the column \"{}\" twice, expected it once", name));
      found.push_back(name);
      column_of_field_.push_back(static_cast<std::size_t>(place - known.begin()));
    }
    for (const TableColumn& column : columns_)
      if (column.required && std::find(found.begin(), found.end(), column.name) == found.end())
        note(0, fmt::format("found no column \"{}\", expected the header's line to name it",
                            column.name));
  }

  void read_rows(OGRLayer& layer) {
    for (const auto& row : layer) {
      ++line_;
      for (std::size_t field = 0; field < column_of_field_.size(); ++field)
        read_cell(field, row->GetFieldAsString(static_cast<int>(field)));
    }
    if (line_ == 1)
      note(0, "found no rows, expected at least one line of numbers after the header");
  }

  void read_cell(std::size_t field, const std::string& text) {
    const TableColumn& column = columns_[column_of_field_[field]];
    std::vector<double>& above = numbers_[column_of_field_[field]];
    const std::optional<double> value = number_in(text);
    if (!value || !(*value >= column.lowest && *value <= column.highest)) {
      note(field, fmt::format("{}: found {}, expected a number {}", column.name,
                              text.empty() ? "nothing" : text, range_text(column)));
    } else if (column.rises && !above.empty() && !(*value > above.back())) {
      note(field,
           fmt::format("{}: found {} after {:g}, expected a larger number than in the line above",
                       column.name, text, above.back()));
    } else {
      above.push_back(*value);
    }
  }

  static std::string range_text(const TableColumn& column) {
    if (column.highest == std::numeric_limits<double>::max())
      return fmt::format("of at least {:g} {}", column.lowest, column.unit);
    return fmt::format("from {:g} to {:g} {}", column.lowest, column.highest, column.unit);
  }

  std::string file_;
  const std::vector<TableColumn>& columns_;
  std::vector<std::vector<double>> numbers_;
  std::vector<std::size_t> column_of_field_;
  std::vector<Problem> problems_;
  int line_ = 1;
};

}  // namespace

std::vector<std::vector<double>> read_table(const std::filesystem::path& file,
                                            const std::vector<TableColumn>& columns) {
  return TableReader(file, columns).read();
}

}  // namespace wold::snow
