// A withering meadow on a hillside, for POV-Ray 3.7.
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
// the camera's mirrored "right" in surroundings.inc is the one place that makes it right-handed.
//
// Nothing is lit here. Grass, ground and sky carry their radiance, computed for the scene's sun;
// the picture is that radiance times Exposure_gain, in sRGB.
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
#declare Units_per_m = 100;

// POV-Ray looks for files in the folder where it was started and in its library paths.
#local Frame_folder = concat("data/frame_", str(FRAME, -4, 0), "/");
#if (file_exists(concat(Frame_folder, "frame.inc")))
  #declare Here = "";
#else
  #declare Here = "povray/";
  #if (!file_exists(concat(Here, Frame_folder, "frame.inc")))
    #error concat("frame ", str(FRAME, 0, 0), " is not there: ", Frame_folder,
      "frame.inc was not found. Start POV-Ray in the folder of scene.pov or name it: +L<folder>\n")
  #end
#end
#declare Frame_folder = concat(Here, Frame_folder);

#include concat(Frame_folder, "frame.inc")
#include concat(Here, "grass.inc")
#include concat(Here, "clouds.inc")
#include concat(Here, "surroundings.inc")
#include concat(Here, "air.inc")

// Here grass stands where it grew and nothing else casts shadows; wold.inc has more to say.
#macro Onto_ground(Middle, Side_m) #end
#macro Shade_density(Channel, Middle) #end
#macro Shade_pane() #end

Grass_maps()

Frame_camera()

Sky(concat(Frame_folder, "sky.exr"))
#ifdef (Backdrop_corner_m)
  Backdrop(concat(Frame_folder, "backdrop.exr"))
#end

#include concat(Here, "data/", Terrain_file)
Ground(concat(Frame_folder, "ground.exr"))

#include concat(Frame_folder, "volumes.inc")
#include concat(Frame_folder, "cells.inc")
#include concat(Frame_folder, "clouds.inc")

#ifdef (Flake_radiance)
  #include concat(Frame_folder, "flakes.inc")
  Falling_flakes()
#end
#ifdef (Fog_extinction_per_m)
  Fog()
#end
