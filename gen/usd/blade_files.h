#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "landscape/landscape.h"

namespace wold::usd {

/// Writes a mesh of blades below `folder`:
///   NAME.usda             /Blades/mesh, tubes in cell space, metres to 10 um; primvar st
///   NAME_radiance.exr     Landscape's radiance before Landscape::light, per ring and tube
///   NAME_reflectance.exr  fraction of light that a blade sends back or lets through, per ring and
///                         tube: surfaces of USD let nothing through; no file where it is unknown
/// Row r, column c of the pictures is for ring c of tube r. The name says what is in them: what is
/// there already stays. Throws FileError.
void write_blades(const landscape::BladeMesh& mesh, const std::filesystem::path& folder);

/// Whether a mesh's colours without light are known.
bool has_reflectance(const landscape::BladeMesh& mesh);

std::filesystem::path blades_layer(const std::string& name);
std::filesystem::path blades_radiance(const std::string& name);
std::filesystem::path blades_reflectance(const std::string& name);

/// The files that write_blades() writes.
std::vector<std::filesystem::path> blade_files(const landscape::BladeMesh& mesh,
                                               const std::filesystem::path& folder);

}  // namespace wold::usd
