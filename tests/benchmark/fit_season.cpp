#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "core/random.h"
#include "phenology/greenness.h"
#include "snowpack/snow_on_ground.h"
#include "support/measured_days.h"

/// Fits the parameters of MeadowParameters and SnowParameters that are fitted, and says how well
/// they do on what they were fitted to, on what was held out, and on a grassland that was left out:
///
///     build/fit_season [GENERATIONS]
///
/// Reads tests/data/weather. The defaults of the two structures are the first set that it prints
/// for each. Exits with 1 when grasslands that were left out are below the goal.
namespace wold {
namespace {

using phenology::MeadowParameters;
using snowpack::SnowParameters;
using test::MeasuredDays;

/// A number to fit, and where it may lie.
template <typename Parameters>
struct Unknown {
  const char* name;
  double Parameters::*number;
  double lowest;
  double highest;
};

const std::vector<Unknown<MeadowParameters>> meadow_unknowns = {
    {"cold_c", &MeadowParameters::cold_c, -2.0, 8.0},
    {"mild_c", &MeadowParameters::mild_c, 9.0, 20.0},
    {"hot_c", &MeadowParameters::hot_c, 22.0, 34.0},
    {"dry", &MeadowParameters::dry, 0.0, 0.28},
    {"moist", &MeadowParameters::moist, 0.3, 1.0},
    {"rooting_days", &MeadowParameters::rooting_days, 1.0, 40.0}};

const std::vector<Unknown<SnowParameters>> snow_unknowns = {
    {"half_snow_c", &SnowParameters::half_snow_c, -1.0, 2.0},
    {"viscosity_pa_s", &SnowParameters::viscosity_pa_s, 1e7, 2e8},
    {"longwave_loss_w_m2", &SnowParameters::longwave_loss_w_m2, 0.0, 150.0},
    {"chilled_share", &SnowParameters::chilled_fraction, 0.0, 1.0}};

/// Differential evolution (Storn and Price 1997), half of the mutants drawn towards the best.
template <typename Parameters>
class Evolution {
 public:
  using Cost = std::function<double(const Parameters&)>;
  Evolution(const std::vector<Unknown<Parameters>>& unknowns, Cost cost)
      : unknowns_(unknowns), cost_(std::move(cost)), members_(population) {
    for (std::size_t i = 0; i < population; ++i) {
      for (const auto& unknown : unknowns_) members_[i].*unknown.number = anywhere(unknown);
      costs_.push_back(cost_(members_[i]));
    }
  }

  Parameters best_after(int generations) {
    for (int generation = 0; generation < generations; ++generation)
      for (std::size_t i = 0; i < population; ++i) try_mutant_of(i);
    return members_[best()];
  }

 private:
  static constexpr std::size_t population = 40;

  double random() { return random_uniform({.seed = 1, .kind = key_of("fit"), .index = draws_++}); }
  std::size_t random_member() { return static_cast<std::size_t>(random() * population); }
  double anywhere(const Unknown<Parameters>& unknown) {
    return unknown.lowest + random() * (unknown.highest - unknown.lowest);
  }
  std::size_t best() const {
    return static_cast<std::size_t>(std::min_element(costs_.begin(), costs_.end()) -
                                    costs_.begin());
  }

  void try_mutant_of(std::size_t i) {
    const Parameters &a = members_[random_member()], &b = members_[random_member()];
    const Parameters& lead = members_[random() < 0.5 ? best() : i];
    const double reach = 0.4 + 0.5 * random();
    Parameters mutant = members_[i];
    for (const auto& unknown : unknowns_) {
      if (random() >= 0.8) continue;
      double& number = mutant.*unknown.number;
      number += reach * (lead.*unknown.number - number + a.*unknown.number - b.*unknown.number);
      if (number < unknown.lowest || number > unknown.highest) number = anywhere(unknown);
    }
    const double cost = cost_(mutant);
    if (cost > costs_[i]) return;
    members_[i] = mutant;
    costs_[i] = cost;
  }

  const std::vector<Unknown<Parameters>>& unknowns_;
  Cost cost_;
  std::vector<Parameters> members_;
  std::vector<double> costs_;
  std::uint64_t draws_ = 0;
};

template <typename Parameters>
void print(const Parameters& parameters, const std::vector<Unknown<Parameters>>& unknowns) {
  for (const auto& unknown : unknowns)
    fmt::print("  {} = {:.4g}", unknown.name, parameters.*unknown.number);
  fmt::print("\n");
}

double efficiency(const MeasuredDays& place, const MeadowParameters& meadow, int year) {
  return fit_of(place, phenology::greenness(place.days, meadow),
                [&](const weather::Day& day) { return year == 0 || test::year_of(day) == year; })
      .efficiency();
}

/// Mean efficiency over places, in a year or (0) in all.
double mean_efficiency(const std::vector<MeasuredDays>& places, const MeadowParameters& meadow,
                       int year) {
  double sum = 0.0;
  for (const MeasuredDays& place : places) sum += efficiency(place, meadow, year);
  return sum / static_cast<double>(places.size());
}

MeadowParameters fitted_meadow(const std::vector<MeasuredDays>& places, int year, int generations) {
  return Evolution<MeadowParameters>(
             meadow_unknowns,
             [&](const MeadowParameters& meadow) { return -mean_efficiency(places, meadow, year); })
      .best_after(generations);
}

void fit_meadow_to_each_year(const std::vector<MeasuredDays>& places, int generations) {
  for (const int year : {2013, 2012}) {
    const MeadowParameters meadow = fitted_meadow(places, year, generations);
    fmt::print("Greenness, fitted to {}: efficiency {:.3f}, in the other year {:.3f}\n", year,
               mean_efficiency(places, meadow, year), mean_efficiency(places, meadow, 4025 - year));
    print(meadow, meadow_unknowns);
    for (const MeasuredDays& place : places)
      fmt::print("  {}: {:.3f}, held out {:.3f}\n", place.place, efficiency(place, meadow, year),
                 efficiency(place, meadow, 4025 - year));
  }
}

/// Mean efficiency at places that the parameters were not fitted to.
double fit_meadow_without_each_place(const std::vector<MeasuredDays>& places, int generations) {
  double sum = 0.0;
  for (std::size_t left_out = 0; left_out < places.size(); ++left_out) {
    std::vector<MeasuredDays> others = places;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(left_out));
    const MeadowParameters meadow = fitted_meadow(others, 0, generations);
    const double there = efficiency(places[left_out], meadow, 0);
    sum += there;
    fmt::print("Greenness, both years, without {}: efficiency {:.3f}, there {:.3f}\n",
               places[left_out].place, mean_efficiency(others, meadow, 0), there);
    print(meadow, meadow_unknowns);
  }
  return sum / static_cast<double>(places.size());
}

bool fit_meadow(int generations) {
  constexpr double goal = 0.69;
  std::vector<MeasuredDays> places;
  for (const std::string& name : test::grasslands())
    places.push_back(test::measured_days(name, "greenness", 40.0));
  fit_meadow_to_each_year(places, generations);
  const double left_out = fit_meadow_without_each_place(places, generations);
  fmt::print("Greenness at a place that was left out: efficiency {:.3f}, goal {}\n", left_out,
             goal);
  return left_out >= goal;
}

constexpr const char* snow_place = "col_de_porte_1993_2004";

MeasuredDays measured_snow(const char* column) {
  return test::measured_days(snow_place, column, 45.3);
}

double depth_rmse(const MeasuredDays& place, const SnowParameters& snow,
                  const std::function<bool(const weather::Day&)>& chosen) {
  return fit_of(place, test::modelled_snow(place.days, &snowpack::SnowOnGround::depth_m, snow),
                chosen)
      .rmse();
}

/// Of every second winter: those that began in odd years or in even ones.
auto winters(int odd) {
  return [odd](const weather::Day& day) {
    return test::in_winter(day) && test::year_of(day, true) % 2 == odd;
  };
}

/// With the defaults: water that lies in the winters that were held out, and when each winter's
/// snow goes.
void judge_snow(const MeasuredDays& depth) {
  const MeasuredDays water = measured_snow("swe_pit_mm");
  const auto modelled_mm = test::modelled_snow(water.days, &snowpack::SnowOnGround::water_mm);
  fmt::print("Water of the snow, winters of odd years: RMSE {:.0f} mm, held out {:.0f} mm\n",
             fit_of(water, modelled_mm, winters(1)).rmse(),
             fit_of(water, modelled_mm, winters(0)).rmse());
  const auto modelled_m = test::modelled_snow(depth.days, &snowpack::SnowOnGround::depth_m);
  for (int year = 1993; year < 2004; ++year) {
    const auto measured = test::last_snow(depth.days, depth.measured, year);
    const auto modelled = test::last_snow(depth.days, modelled_m, year);
    if (measured && modelled)
      fmt::print("  {}/{:02}: snow gone {:+} days from what was measured\n", year, (year + 1) % 100,
                 (*modelled - *measured).count());
  }
}

void fit_snow(int generations) {
  const MeasuredDays place = measured_snow("snow_depth_m");
  for (const int odd : {1, 0}) {
    const SnowParameters snow =
        Evolution<SnowParameters>(snow_unknowns, [&](const SnowParameters& trial) {
          return depth_rmse(place, trial, winters(odd));
        }).best_after(generations);
    fmt::print("Depth of snow, fitted to winters of {} years: RMSE {:.3f} m, held out {:.3f} m\n",
               odd ? "odd" : "even", depth_rmse(place, snow, winters(odd)),
               depth_rmse(place, snow, winters(1 - odd)));
    print(snow, snow_unknowns);
    for (int year = 1993; year < 2004; ++year)
      fmt::print("  {}/{:02}{}: {:.3f}\n", year, (year + 1) % 100,
                 year % 2 == odd ? "" : ", held out",
                 depth_rmse(place, snow, [&](const weather::Day& day) {
                   return test::in_winter(day) && test::year_of(day, true) == year;
                 }));
  }
  judge_snow(place);
}

}  // namespace
}  // namespace wold

int main(int count, char** arguments) {
  const int generations = count > 1 ? std::stoi(arguments[1]) : 120;
  const bool is_good = wold::fit_meadow(generations);
  if (std::filesystem::exists(wold::test::measured_file(wold::snow_place)))
    wold::fit_snow(generations);
  else
    fmt::print("No snow: {} is not there, see tests/data/README.md\n", wold::snow_place);
  return is_good ? 0 : 1;
}
