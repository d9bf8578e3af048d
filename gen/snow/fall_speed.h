#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "scene/modes.h"

namespace wold::snow {

/// What a flake is.
enum class Crystal : std::uint8_t { plate, column, dendrite, aggregate };
inline constexpr std::size_t crystal_kinds = 4;
/// The choice that is each crystal alone, in the order of Crystal.
inline constexpr std::array<scene::CrystalChoice, crystal_kinds> single_crystals = {
    scene::CrystalChoice::plate, scene::CrystalChoice::column, scene::CrystalChoice::dendrite,
    scene::CrystalChoice::aggregate};

/// Terminal speed in still air by greatest diameter: Locatelli and Hobbs 1974 (Fall speeds and
/// masses of solid precipitation particles, table 1), V = a D^b, D in mm, measured between 750 and
/// 1500 m above the sea. Outside the diameters that were measured the nearest one's speed holds.
double fall_speed_m_s(Crystal crystal, double diameter_mm);

/// Fractions of the crystals among flakes of a diameter; they sum to 1. When they are mixed, small
/// flakes are plates and columns, large ones aggregates, some dendrites throughout.
std::array<double, crystal_kinds> crystal_fractions(scene::CrystalChoice choice,
                                                    double diameter_mm);

/// The crystal that a uniform number in [0, 1) picks by those shares.
Crystal picked_crystal(const std::array<double, crystal_kinds>& fractions, double uniform);

}  // namespace wold::snow
