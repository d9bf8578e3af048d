#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wold::render {

/// What a renderer can compute on beside the processor.
struct Device {
  std::string type;  ///< "OPTIX", "CUDA", "HIP", "ONEAPI" or "METAL"
  std::string name;  ///< the maker's

  bool operator==(const Device&) const = default;
};

/// What a renderer can show and compute on, as it was seen in pictures that it made.
struct Capabilities {
  std::string version;          ///< its own word for it
  std::string python;           ///< of a Blender, its Python's version; else ""
  bool volumes = false;         ///< a volume of one voxel was seen
  bool fog = false;             ///< a homogeneous medium was seen
  std::optional<bool> nanovdb;  ///< whether volumes stay sparse in memory; nothing: not known
  std::vector<Device> devices;
  int threads = 0;  ///< of the processor that it uses

  bool operator==(const Capabilities&) const = default;
};

}  // namespace wold::render
