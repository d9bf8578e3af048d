#include "render/command.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace wold::render {

Command render_command(const Job& job, const std::filesystem::path& output) {
  return job.program.kind->command(job, output);
}

std::optional<double> progress_fraction(const Renderer& renderer, std::string_view line) {
  const auto fraction = renderer.fraction_done(line);
  if (!fraction) return std::nullopt;
  return std::clamp(*fraction, 0.0, 1.0);
}

std::optional<double> leading_number(std::string_view text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace wold::render
