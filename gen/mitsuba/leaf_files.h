#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/tubes.h"
#include "landscape/landscape.h"
#include "mitsuba/ply_file.h"

namespace wold::mitsuba {

/// Blades as leaves. A tube that lets light through becomes a ribbon along its axis, since a leaf
/// is thin: light meets it once and not at two walls. The ribbon is half as wide as the tube's
/// outline is long and rolled about the axis by its own angle, keyed by its number: over all angles
/// it shows the same area from every side as the tube (Cauchy). A tube that lets nothing through,
/// snow or a leaf of the paper's colours, stays. Row r, column c of the pictures is for ring c of
/// tube r, and u and v point there.
Mesh leaf_mesh(const Tubes& tubes);

/// Writes a mesh of blades below `folder`:
///   NAME.ply                leaf_mesh(), metres
///   NAME_reflectance.exr    fractions of light, per ring and tube
///   NAME_transmittance.exr
/// The name says what is in them: what is there already stays. Throws FileError, and InputError
/// where reflectance or transmittance is not known.
void write_leaves(const landscape::BladeMesh& mesh, const std::filesystem::path& folder);

/// The files of a mesh of that name, in that order.
std::vector<std::filesystem::path> leaf_files(const std::string& name,
                                              const std::filesystem::path& folder);

}  // namespace wold::mitsuba
