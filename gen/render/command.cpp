#include "render/command.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"

namespace wold::render {

Command render_command(const Job& job, const std::filesystem::path& output) {
  return job.program.kind->command(job, output);
}

std::optional<double> progress_fraction(const Renderer& renderer, std::string_view line) {
  const auto fraction = renderer.fraction_done(line);
  if (!fraction) return std::nullopt;
  return std::clamp(*fraction, 0.0, 1.0);
}

std::optional<double> leading_finite(std::string_view text) {
  const auto number = leading_number<double>(text);
  if (!number || !std::isfinite(number->value)) return std::nullopt;
  return number->value;
}

}  // namespace wold::render
