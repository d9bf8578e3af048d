#include "weather/number_table.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <optional>
#include <sstream>

#include "core/error.h"
#include "core/files.h"
#include "core/number_text.h"
#include "core/quiet_gdal.h"
#include "scene/nearest.h"

namespace wold::weather {
namespace {

std::optional<double> day_in(const std::string& text) {
  OGRField field;
  if (text.size() != std::string("2012-02-29").size() || !OGRParseDate(text.c_str(), &field, 0))
    return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(field.Date.Year),
                                         std::chrono::month(field.Date.Month),
                                         std::chrono::day(field.Date.Day)};
  if (!date.ok()) return std::nullopt;
  return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count());
}

std::string trimmed(std::string text) {
  text.erase(0, text.find_first_not_of(" \t"));
  text.erase(text.find_last_not_of(" \t") + 1);
  return text;
}

/// What is no text would reach GDAL as a table without columns.
void require_text(const std::filesystem::path& file, int number, const std::string& line) {
  constexpr std::size_t longest = 1 << 20;
  const auto refuse = [&](const std::string& found) {
    const SourcePosition where{file.string(), number};
    throw InputError(
        {Problem{where, fmt::format("found {}, expected a table as text in UTF-8", found)}});
  };
  if (line.size() > longest) refuse(fmt::format("{} characters in a line", line.size()));
  if (line.find('\0') != std::string::npos ||
      CPLIsUTF8(line.data(), static_cast<int>(line.size())) == 0)
    refuse("bytes that are no text");
}

/// A file's lines but for those that say nothing, where GDAL can read them.
class LinesWithContent {
 public:
  explicit LinesWithContent(const std::filesystem::path& file)
      : name_(fmt::format("/vsimem/wold/{}.csv", fmt::ptr(this))) {
    std::istringstream all(read_file(file));
    std::string line;
    for (int number = 1; std::getline(all, line); ++number) {
      require_text(file, number, line);
      if (line.empty() || line == "\r" || line.front() == '#') continue;
      text_ += line + '\n';
      numbers_.push_back(number);
      cells_.push_back(cells_in(line));
    }
    VSIFCloseL(VSIFileFromMemBuffer(name_.c_str(), reinterpret_cast<GByte*>(text_.data()),
                                    text_.size(), FALSE));
  }
  ~LinesWithContent() { VSIUnlink(name_.c_str()); }
  LinesWithContent(const LinesWithContent&) = delete;
  LinesWithContent& operator=(const LinesWithContent&) = delete;

  const std::string& name() const { return name_; }
  bool empty() const { return numbers_.empty(); }

  /// The number in the file of the line at `index`, or of the last one.
  int number(std::size_t index) const { return numbers_[std::min(index, numbers_.size() - 1)]; }

  /// How many cells that line has, up to the last one that is not empty; the header is the first.
  std::size_t cells(std::size_t index) const { return cells_[std::min(index, cells_.size() - 1)]; }

 private:
  static std::size_t cells_in(const std::string& line) {
    const CPLStringList cells(
        CSLTokenizeString2(line.c_str(), ",", CSLT_HONOURSTRINGS | CSLT_ALLOWEMPTYTOKENS));
    int count = cells.size();
    while (count > 0 && trimmed(cells[count - 1]).empty()) --count;
    return static_cast<std::size_t>(count);
  }

  std::string name_;
  std::string text_;
  std::vector<int> numbers_;
  std::vector<std::size_t> cells_;
};

/// Reads a table and notes what is wrong with it.
class TableReader {
 public:
  TableReader(const std::filesystem::path& file, const std::vector<TableColumn>& columns,
              OtherColumns other)
      : file_(file.string()), columns_(columns), other_(other), last_(columns.size()) {
    table_.columns.resize(columns.size());
    table_.places.resize(columns.size());
  }

  NumberTable read() {
    const QuietGdal quiet;
    const LinesWithContent lines(file_);
    if (lines.empty())
      throw InputError(
          fmt::format("{}: found no header, expected a line that names columns", file_));
    const char* const drivers[] = {"CSV", nullptr};
    const char* const options[] = {"HEADERS=YES", nullptr};
    const GDALDatasetUniquePtr table(GDALDataset::Open(
        ("CSV:" + lines.name()).c_str(), GDAL_OF_VECTOR | GDAL_OF_VERBOSE_ERROR, drivers, options));
    if (!table || table->GetLayerCount() != 1)
      throw InputError({Problem{header_place(lines),
                                fmt::format("found no columns, expected comma-separated values "
                                            "under a header such as {}",
                                            fmt::join(known_names(), ","))}});
    OGRLayer& layer = *table->GetLayer(0);
    line_ = lines.number(0);
    read_header(*layer.GetLayerDefn());
    if (problems_.empty()) read_rows(layer, lines);
    if (!problems_.empty()) throw InputError(std::move(problems_));
    return std::move(table_);
  }

 private:
  SourcePosition header_place(const LinesWithContent& lines) const {
    return {file_, lines.number(0), 1};
  }

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
      if (place == known.end() && other_ == OtherColumns::refused)
        note(found.size(),
             fmt::format("found a column \"{}\", expected {}{}", name, fmt::join(known, ", "),
                         scene::suggestion(scene::nearest(name, known))));
      else if (place != known.end() && std::find(found.begin(), found.end(), name) != found.end())
        note(found.size(), fmt::format("found the column \"{}\" twice, expected it once", name));
      found.push_back(name);
      if (place != known.end())
        table_.places[static_cast<std::size_t>(place - known.begin())] = field + 1;
      column_of_field_.push_back(static_cast<std::size_t>(place - known.begin()));
    }
    for (const TableColumn& column : columns_)
      if (column.required && std::find(found.begin(), found.end(), column.name) == found.end())
        note(0, fmt::format("found no column \"{}\", expected the header's line to name it{}",
                            column.name, found_instead(column.name, found)));
  }

  /// Where other columns are ignored, one may be the column that is missing, misspelt.
  std::string found_instead(const std::string& name, const std::vector<std::string>& found) const {
    if (other_ == OtherColumns::refused) return "";
    const std::string near = scene::nearest(name, found);
    return near.empty() ? "" : fmt::format("; is it \"{}\"?", near);
  }

  void read_rows(OGRLayer& layer, const LinesWithContent& lines) {
    for (const auto& row : layer) {
      line_ = lines.number(table_.lines.size() + 1);
      table_.lines.push_back(line_);
      const std::size_t columns = column_of_field_.size();
      if (const std::size_t cells = lines.cells(table_.lines.size()); cells > columns)
        note(columns, fmt::format("found {} cells, expected {} as in the header; decimals take a "
                                  "point",
                                  cells, columns));
      for (std::size_t field = 0; field < column_of_field_.size(); ++field)
        if (column_of_field_[field] < columns_.size())
          read_cell(field, trimmed(row->GetFieldAsString(static_cast<int>(field))));
    }
    if (table_.lines.empty())
      note(0, "found no rows, expected at least one line of numbers after the header");
  }

  void read_cell(std::size_t field, const std::string& text) {
    const std::size_t index = column_of_field_[field];
    const TableColumn& column = columns_[index];
    std::vector<double>& above = table_.columns[index];
    if (text.empty() && column.may_be_empty) {
      above.push_back(std::numeric_limits<double>::quiet_NaN());
      return;
    }
    const std::optional<double> value = column.is_date ? day_in(text) : number_in<double>(text);
    if (!value || !(column.is_date || (*value >= column.lowest && *value <= column.highest))) {
      note(field, fmt::format("{}: found {}, expected {}", column.name,
                              text.empty() ? "nothing" : text, expected_text(column)));
    } else if (column.rises && !above.empty() && !(*value > above.back())) {
      note(field,
           fmt::format("{}: found {} after {}, expected a {} than in the line above", column.name,
                       text, last_[index], column.is_date ? "later day" : "larger number"));
    } else {
      above.push_back(*value);
      last_[index] = text;
    }
  }

  static std::string expected_text(const TableColumn& column) {
    if (column.is_date) return "a day of the calendar as in 2012-02-29";
    if (column.highest == std::numeric_limits<double>::max())
      return fmt::format("a number of at least {:g} {}", column.lowest, column.unit);
    return fmt::format("a number from {:g} to {:g} {}", column.lowest, column.highest, column.unit);
  }

  std::string file_;
  const std::vector<TableColumn>& columns_;
  OtherColumns other_;
  NumberTable table_;
  std::vector<std::string> last_;  ///< number of each column, as it is written
  std::vector<std::size_t> column_of_field_;
  std::vector<Problem> problems_;
  int line_ = 1;
};

}  // namespace

NumberTable read_table(const std::filesystem::path& file, const std::vector<TableColumn>& columns,
                       OtherColumns other) {
  return TableReader(file, columns, other).read();
}

}  // namespace wold::weather
