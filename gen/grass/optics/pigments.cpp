#include "grass/optics/pigments.h"

#include <algorithm>
#include <cstddef>

#include "core/files.h"
#include "grass/ageing/model_table.h"

namespace wold::grass {
namespace {

double maximum(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

}  // namespace

LeafSpectra load_leaf_spectra() {
  const ModelTable table(shipped_file("models/leaf/prospect_d.toml"));
  const std::size_t rows = table.column("wavelength_nm").size();
  const auto column = [&](const char* name) { return table.column(name, rows); };
  const ModelTable hair(shipped_file("models/fur/melanin.toml"));
  return {column("wavelength_nm"),
          column("refractive_index"),
          column("chlorophyll_cm2_ug"),
          column("chlorophyll_a_cm2_ug"),
          column("chlorophyll_b_cm2_ug"),
          column("carotenoid_cm2_ug"),
          column("brown"),
          column("water_cm"),
          column("dry_cm2_g"),
          hair.column("eumelanin_mm", rows),
          hair.column("pheomelanin_mm", rows)};
}

Observer load_observer(double first_nm, double last_nm) {
  const ModelTable table(shipped_file("models/colour/cie1931_d65.toml"));
  const std::vector<double>& wavelength_nm = table.column("wavelength_nm");
  const auto column = [&](const char* name) { return table.column(name, wavelength_nm.size()); };
  const std::vector<double> x = column("x");
  const std::vector<double> y = column("y");
  const std::vector<double> z = column("z");
  const std::vector<double> d65 = column("d65");
  std::vector<glm::dvec3> matching;
  std::vector<double> illuminant;
  for (std::size_t i = 0; i < wavelength_nm.size(); ++i) {
    if (wavelength_nm[i] < first_nm || wavelength_nm[i] > last_nm) continue;
    matching.emplace_back(x[i], y[i], z[i]);
    illuminant.push_back(d65[i]);
  }
  return Observer(matching, illuminant);
}

std::vector<double> paper_reflectance(const LeafSpectra& spectra, double chlorophyll) {
  constexpr double sum = 27.0 + 9.0 + 4.0;
  const double a = chlorophyll * 27.0 / sum / maximum(spectra.chlorophyll_a_cm2_ug);
  const double b = chlorophyll * 9.0 / sum / maximum(spectra.chlorophyll_b_cm2_ug);
  const double c = 4.0 / sum / maximum(spectra.carotenoid_cm2_ug);
  std::vector<double> reflectance;
  for (std::size_t i = 0; i < spectra.wavelength_nm.size(); ++i)
    reflectance.push_back(1.0 -
                          (c * spectra.carotenoid_cm2_ug[i] + a * spectra.chlorophyll_a_cm2_ug[i] +
                           b * spectra.chlorophyll_b_cm2_ug[i]));
  return reflectance;
}

}  // namespace wold::grass
