#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "render/program.h"

namespace wold::render {

struct Answer;
struct Capabilities;
struct Command;
struct Job;
struct RendererProgram;

/// Asked several times a second while a program runs: whether to stop it.
using Interrupted = std::function<bool()>;

/// A kind of external program that makes pictures, and all that is asked of it. There is one object
/// of each kind, by whose address the kind is known.
struct Renderer {
  ExternalProgram program;
  /// What --help says of the option that names the program: "POV-Ray".
  std::string_view option_doc;
  /// What a program that is something else should have been: "Blender and no Python".
  std::string_view expected_program;
  /// Builds that show more, between commas, for those whose build shows too little; may be empty.
  std::string_view better_builds = {};
  /// The package by which a Python stands in the program's place; may be empty.
  std::string_view python_package = {};
  /// Whether it computes on what render.device names: another device has other last bits.
  bool has_devices = false;
  /// Whether builds stand beside each other on the PATH under names such as `blender-4.5`.
  bool has_numbered_names = false;
  /// Ends the name of what it keeps beside its output while it runs, and leaves there when it is
  /// stopped: ".pov-state" for one. May be empty.
  std::string_view state_extension = {};
  /// Folder of shipped files that pictures depend on beside the exported ones: a
  /// shipped_file() name.
  std::string_view templates;

  /// The program, if its answer to --version is that of such a renderer; nothing if it is something
  /// else. Throws RendererError that says what to do when something is missing, and FileError.
  std::function<std::optional<RendererProgram>(const FoundProgram&, const Answer&,
                                               const Interrupted&)>
      recognise;
  /// What makes the program render a job to an absolute path.
  std::function<Command(const Job&, const std::filesystem::path& output)> command;
  /// How far a line of its output says that it is; nothing for any other line. Need not be in
  /// [0, 1].
  std::function<std::optional<double>(std::string_view line)> fraction_done;
  /// See probe.h.
  std::function<Capabilities(const RendererProgram&, const Interrupted&)> probe;
  std::function<std::string(const RendererProgram&)> probe_content;
  /// What to do about things that its picture does not show, "grass" for one, after a semicolon;
  /// empty: nothing is known. May be missing.
  std::function<std::string(std::string_view things)> advice = {};
  /// Expects a frame (from 1) of an exported folder to hold nothing that the program would run.
  /// Throws FileError. Missing where the program runs nothing of the folder.
  std::function<void(const std::filesystem::path& folder, int frame)> require_data_only = {};
};

/// "Blender" or "POV-Ray", for people.
std::string_view display_name(const Renderer& renderer);

/// The program: `chosen`, which an option such as --blender named, else what a variable such as
/// $WOLD_BLENDER names, else the first of its name on the PATH; see find_program(). Throws
/// RendererError that names the Debian package to install when there is none.
FoundProgram find_renderer(const Renderer& renderer, const std::string& chosen = {});

}  // namespace wold::render
