#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "landscape/landscape.h"
#include "usd/tint.h"

namespace wold::usd {

/// Where the light comes from: see frame_text().
enum class Light { baked, lit };

/// A Volume prim with the grids of volume_file.h. `inside`: path of the prim around it. It reaches
/// from 0 to `size_m`.
std::string volume_text(const std::string& inside, const std::filesystem::path& file,
                        const glm::dvec3& size_m);

/// A frame's grass: prototypes, which are not shown by themselves, and for each cell a scene graph
/// instance of one.
class Grass {
 public:
  explicit Grass(const landscape::Landscape& landscape);

  /// /Landscape/Prototypes and /Landscape/Grass.
  std::string text() const;

  /// What fills the prototypes' materials in a variant.
  std::string materials_text(Light light) const;

 private:
  std::string prototypes_text() const;
  std::string cells_text() const;

  const landscape::Landscape& landscape_;
  CellLight light_;
  std::map<TintedBlades, int> blades_;               ///< to the prototype's number
  std::map<std::string, int> texels_;                ///< by the file's name
  std::map<int, const landscape::Volume*> volumes_;  ///< of the prototypes of texels
  std::vector<int> blades_of_cells_;
};

}  // namespace wold::usd
