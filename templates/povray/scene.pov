// A withering meadow on a hillside, for POV-Ray 3.7 and 3.8.
//
//   povray scene.pov                     frame 1, in this folder
//   povray scene.pov Declare=FRAME=2     another frame
//   povray povray/scene.pov              from the folder above, if this folder is named "povray"
//   povray data/frame_0001.ini           frame 1 with the scene's size and picture name, from here
//   povray povray/data/frame_0001.ini    the same from the folder above
//
// POV-Ray takes the size of the picture and its antialiasing from options, not from this file:
// povray.ini, which it reads when it is in the folder where POV-Ray is started, has the scene's.
//
// The world is metres, x east, y north, z up, as in the data. POV-Ray is left-handed by default;
// the camera's mirrored "right" in wold_surroundings.inc is the one place that makes it
// right-handed.
//
// Nothing is lit here. Grass, ground and sky carry their radiance, computed for the scene's sun;
// the picture is that radiance times Wold_exposure_gain, in sRGB.
#version 3.7;

global_settings {
  assumed_gamma 1.0
  max_trace_level 256
}

#ifndef (FRAME)
  #declare FRAME = 1;
#end

// POV-Ray's tolerances are absolute: two surfaces nearer than about 5e-5 units are one to it. In
// centimetres that is far below anything here, in metres the seams between cells would show.
#declare Wold_units_per_m = 100;

// POV-Ray looks for files in the folder where it was started and in its library paths.
#local _folder = concat("data/frame_", str(FRAME, -4, 0), "/");
#if (file_exists(concat(_folder, "frame.inc")))
  #declare Wold_here = "";
#else
  #declare Wold_here = "povray/";
  #if (!file_exists(concat(Wold_here, _folder, "frame.inc")))
    #error concat("frame ", str(FRAME, 0, 0), " is not there: ", _folder,
      "frame.inc was not found. Start POV-Ray in the folder of scene.pov or name it: +L<folder>\n")
  #end
#end
#declare Wold_frame_folder = concat(Wold_here, _folder);

#include concat(Wold_frame_folder, "frame.inc")
#include concat(Wold_here, "wold_grass.inc")
#include concat(Wold_here, "wold_clouds.inc")
#include concat(Wold_here, "wold_surroundings.inc")
#include concat(Wold_here, "wold_air.inc")

Wold_grass_maps()

Wold_frame_camera()

Wold_sky(concat(Wold_frame_folder, "sky.exr"))
#ifdef (Wold_backdrop_corner_m)
  Wold_backdrop(concat(Wold_frame_folder, "backdrop.exr"))
#end

#include concat(Wold_here, "data/", Wold_terrain_file)
Wold_draw_ground(concat(Wold_frame_folder, "ground.exr"))

#include concat(Wold_frame_folder, "volumes.inc")
Wold_cells(concat(Wold_frame_folder, "cells.txt"))
#include concat(Wold_frame_folder, "clouds.inc")

#ifdef (Wold_flake_radiance)
  #include concat(Wold_frame_folder, "flakes.inc")
  Wold_falling_flakes()
#end
#ifdef (Wold_fog_extinction_per_m)
  Wold_fog()
#end
