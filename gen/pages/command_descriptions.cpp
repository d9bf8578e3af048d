#include "pages/command_descriptions.h"

#include <map>

namespace wold::pages {

std::string_view command_description(std::string_view command) {
  static const std::map<std::string_view, std::string_view> descriptions = {
      {"render",
       "Makes the pictures of a scene: bakes the texels that its frames need, writes a "
       "scene for each renderer and frame, runs Blender and POV-Ray on them, and leaves "
       "the pictures in DIR/frames/RENDERER/NNNN.png. What is there already and would come"
       " out the same is kept: run again after an interruption, a fault or a change of the"
       " scene, it does what is missing, and wold plan --why says beforehand what that is."
       " A renderer that fails, hangs or writes no valid picture ends it with a message "
       "that names the log."},
      {"generate",
       "Does what wold render does before it runs the renderers: texels, clouds, snow and "
       "the scenes in DIR/blender and DIR/povray. They work where only the renderer is: "
       "povray scene.pov shows the one, the files of wold extension the other. "
       "DIR/manifest.json lists every file at the end."},
      {"passes",
       "Writes what every pixel of the frames shows, as numbers: depth, normals, positions, "
       "motion, species, cells, snow, weathering, wetness, albedo and light, or those that "
       "--passes "
       "names, in DIR/passes/NNNN.exr. They come from the scene's own model, so that they fit the "
       "pictures of all renderers and need none. wold inspect explains such a file. wold render "
       "--passes makes them with the pictures."},
      {"plan",
       "Lists stages and their tasks, how many of them are to do, and estimates of time, "
       "memory and disk. A task is what one machine can do alone as soon as those before it "
       "are done, by wold task. The forms for machines, --json and --openjd, name every task"
       " with what it waits for."},
      {"task",
       "Does one task of the plan, with the scene, options and folder of all the others; the"
       " order is wold plan's. It leaves whole files or none, does nothing when it has been "
       "done, and may be run anywhere, twice, or at the same time as others. That is what "
       "templates/slurm runs on many machines."},
      {"preview",
       "Draws one picture of what a scene will show without Blender or POV-Ray: frames "
       "from the film's beginning, middle and end, the terrain from above with its light "
       "and snow, the sky, flakes, and the grass at some of its key frames. The frames are"
       " drawn coarsely; where things stand, how they are lit and what colours they have "
       "is as the renderers will have it."},
      {"maps",
       "Writes what the ground of a scene is like as GeoTIFFs, with a value at each of its "
       "heights: height, slope, share on which grass grows, share that is a lake, and of "
       "each frame the weathering degree, the depth of the snow and, on terrains of up to "
       "120 m, the water in it. They lie where terrain.elevation does, in the "
       "azimuthal equidistant projection about the scene's middle, whose metres are the "
       "scene's; without a model they are in metres from its south-western corner."},
      {"check",
       "Reads a scene, says with file, line and column everything that is wrong with it, "
       "warns of what will look wrong, and prints the scene with every key filled in. The "
       "file that it prints is a scene itself."},
      {"inspect",
       "Says what is in files: size, channels and range of pictures; grids, their voxels, "
       "values and transforms of .vdb; voxels, bits and values of .df3. Of damaged ones it"
       " says what is wrong."},
      {"compare",
       "Compares what was got with what was wanted: two pictures, two .vdb or .df3 files, "
       "or two folders, file by file. It prints root mean square, largest difference, the "
       "share beyond the soft limit, PSNR, SSIM and FLIP of pictures, values, topology and"
       " transforms of grids, and exits with 1 when a limit is passed. Limits that are not"
       " given are those for pictures of two runs on different machines."},
      {"curves",
       "Draws how a leaf of the scene ages, over the weathering degree from 0 to 1: "
       "chlorophyll and other pigments, water, strains, stiffness, droop of the tip, and its"
       " reflectance spectra with their colours. Of a season, or with --weather of any "
       "place, it draws greenness, weathering degree, depth and water of the snow day by day"
       " instead. A name that ends in .csv is written as a table."},
      {"wind",
       "Prints the velocity of the scene's wind, east, north and up in metres per second, at each "
       "place and time that --at names: the mean wind of its weather with hills, gusts and the "
       "waves of the grass, as it moves the grass where wind.grass is \"waving\". Nothing has to "
       "be "
       "made before."},
      {"film",
       "Encodes the frames of an output folder by FFmpeg, as a film that any player shows "
       "(H.264 in .mp4) and as a small picture that loops (.webp) beside it. It takes the "
       "frames in order, refuses gaps, and writes whole files or none."},
      {"report",
       "Makes one page that needs nothing else, to look at or to send: the frames with a "
       "slider over time and the weathering degree, both renderers side by side with a wipe "
       "between them, how long each task took, the curves of the scene, its parameters and "
       "what it was warned of."},
      {"new",
       "Writes NAME.toml with the keys that are worth changing first, each with its meaning;"
       " all the others have their defaults. It never replaces a file."},
      {"explain",
       "Prints a key, or all keys of a table, with meaning, unit, range and default, as lines that "
       "a scene can take; without KEY, the tables and the names of their keys. It knows the names "
       "that keys had in earlier versions."},
      {"schema",
       "Prints JSON Schema (draft 2020-12) of scene files, made from the same registry that reads "
       "them: every key with its meaning, range and default. Editors with a TOML language server, "
       "such as Taplo, complete and check a scene by it whose first line is #:schema "
       "./scene.schema.json, as in those of wold new. What one key asks of another is left to wold "
       "check."},
      {"doctor",
       "Lists Blender and POV-Ray as wold render would take them, by --blender and --povray, "
       "WOLD_BLENDER and WOLD_POVRAY, or the PATH, with their versions. Each makes a picture of "
       "one "
       "voxel, from which is known whether it shows volumes and fog; what it computes on is asked "
       "for, too. Other Blenders on the PATH and FFmpeg are listed without being tried. Exit code "
       "0 says that a renderer shows all that a scene can have, 3 that none does. What was found "
       "is "
       "kept in ~/.cache/wold (XDG_CACHE_HOME), where wold render looks."},
      {"extension",
       "Writes wold_blender-VERSION.zip, which Blender installs as an extension (4.2 and newer) or "
       "as an add-on (3.4 to 4.1), and wold_render.py, which renders a folder of wold generate "
       "with "
       "the archive beside it, by Blender or by a Python that has the package bpy. The same "
       "program "
       "writes the same bytes; older files of these names are replaced, and no others."},
  };
  return descriptions.at(command);
}

}  // namespace wold::pages
