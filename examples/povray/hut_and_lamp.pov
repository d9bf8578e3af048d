// A hut and a lamp in the meadow of examples/hillside.toml, as examples/blender/hut_and_lamp.py has
// them in Blender:
//
//     wold generate examples/hillside.toml --renderer povray
//     povray +Lout/hillside/povray examples/povray/hut_and_lamp.pov +W480 +H270
//
// The hut shades grass and ground, and grass hides its foot. The lamp is for dusk: generate with
// --set sun.elevation=-2.
#version 3.7;
#include "wold.inc"

#declare Degree = 0;

global_settings { Wold_Settings(Degree) }

// Things are put on Wold_terrain, which is not drawn yet.
Wold_Terrain(Degree)

// The landscape's light comes from all of the sky and from the sun: "ambient" as "diffuse".
#declare Paint = finish { ambient 0.8 diffuse 0.8 emission 0 }

// Metres: half of the length and of the width, the walls' height, that of the ridge, and how far
// the roof reaches beyond the walls.
#declare X = 1.3;
#declare Y = 0.9;
#declare Wall = 1.3;
#declare Ridge = 2.1;
#declare Eaves = 0.25;
#declare Low = Wall - Eaves * (Ridge - Wall) / Y;

// The gable's outline, along x. Walls reach into the ground.
#declare Walls = prism {
  linear_sweep -X, X, 6
  <-Y, -0.6>, <Y, -0.6>, <Y, Wall>, <0, Ridge>, <-Y, Wall>, <-Y, -0.6>
  pigment { color rgb <0.23, 0.15, 0.09> / 0.8 }
  finish { Paint }
}
#declare Roof = prism {
  linear_sweep -X - Eaves, X + Eaves, 7
  <-Y - Eaves, Low>, <0, Ridge>, <Y + Eaves, Low>, <Y + Eaves, Low + 0.03>, <0, Ridge + 0.03>,
  <-Y - Eaves, Low + 0.03>, <-Y - Eaves, Low>
  pigment { color rgb <0.30, 0.10, 0.07> / 0.8 }
  finish { Paint }
}
#declare Hut = union {
  object { Walls }
  object { Roof }
  // A prism's sweep is its y, its outline x and z: these are to be x, y and z.
  matrix <0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0>
  rotate degrees(0.5) * z
  translate <19.6, 11.5, Wold_height_m(19.6, 11.5)>
  scale Wold_units_per_m
}

Wold_Shadows(Hut)
Wold_Light(Degree)
// By eye: the landscape's light is in units of its own. Things are as exposed as it is.
#declare Lamp = <22.2, 9.6, Wold_height_m(22.2, 9.6) + 1.4> * Wold_units_per_m;
Wold_Lamp(Lamp, <1, 0.65, 0.3> * 19 * Wold_exposure_gain, 0.2 * Wold_units_per_m)
Wold_Ground(Degree)
Wold_Grass(Wold_terrain, Degree)
Wold_Clouds(0)
Wold_Snow(0)
Wold_Camera(Degree)

object { Hut }
