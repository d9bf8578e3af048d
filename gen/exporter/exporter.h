#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "exporter/costs.h"
#include "exporter/film_settings.h"
#include "landscape/landscape.h"
#include "landscape/needs.h"
#include "render/renderer.h"

/// Entries of the table of exporters: what each is called, does, costs and needs.
namespace wold::exporter {

/// An exporter, with the renderer of its files if Wold runs one. There is one object of each, by
/// whose address the exporter is known.
struct Exporter {
  std::string_view name;          ///< "blender": its folder, its stage, its word in render.renderer
  std::string_view display_name;  ///< "Blender", for people

  /// Writes a frame's files into a folder and returns all that the frame is made of, shared ones
  /// too. Same landscape, same bytes, also when several processes write at a time. Throws
  /// FileError.
  std::function<std::vector<std::filesystem::path>(const landscape::Landscape&, const FilmSettings&,
                                                   const std::filesystem::path& folder)>
      export_frame;
  /// Writes what a film has once into a folder. Throws FileError. May be missing.
  std::function<void(const FilmSettings&, const std::filesystem::path& folder)> export_film = {};
  /// Folders below its own that frames write to, but for data/frame_0001 and its like: "data",
  /// "data/volumes". Their number does not depend on the film's length.
  std::vector<std::string> shared_folders = {};
  /// Names of files of its folder that are copied to the output folder with every frame.
  std::vector<std::string> files_for_output_folder = {};
  /// What will be wrong with a frame's picture soon; empty when nothing is. Throws InputError when
  /// the renderer cannot show the frame. May be missing.
  std::function<std::string(const landscape::Landscape&)> warning_of = {};

  landscape::Needs needs = {};
  FileCosts files = {};

  /// The program that makes pictures of its files; nullptr: Wold runs none.
  const render::Renderer* renderer = nullptr;
  MemoryCosts memory = {};  ///< of the renderer
  /// Seconds of one thread for a megapixel with so many samples per pixel. Missing without a
  /// renderer.
  std::function<double(int samples)> seconds_per_megapixel = {};
};

using Exporters = std::span<const Exporter* const>;

/// Whether an exporter writes the file or folder of that name in an output folder.
bool writes(const Exporter& exporter, std::string_view name);

/// The exporter of that name, or nullptr.
const Exporter* find_exporter(Exporters exporters, std::string_view name);

/// What a landscape has to be for all of these: the strictest limits, everything that one asks for.
landscape::Needs needs_of_all(Exporters exporters);

}  // namespace wold::exporter
