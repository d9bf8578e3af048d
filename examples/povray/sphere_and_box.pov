// A plain sphere and a box in the meadow of examples/hillside.toml, at the first yellow:
//
//     wold generate examples/hillside.toml --renderer povray
//     povray +Lout/hillside/povray examples/povray/sphere_and_box.pov +W480 +H270
//
// Each stands in the grass, which hides its foot, and throws its shadow on grass and ground.
#version 3.7;
#include "wold.inc"

#declare Degree = 0.3;

global_settings { Wold_Settings(Degree) }

// Things are put on Wold_terrain, which is not drawn yet.
Wold_Terrain(Degree)

// The landscape's light comes from all of the sky and from the sun: "ambient" as "diffuse".
#declare Paint = finish { ambient 0.8 diffuse 0.8 emission 0 }

#declare Ball = sphere {
  <20, 8.2, Wold_height_m(20, 8.2) + 0.4> * Wold_units_per_m, 0.45 * Wold_units_per_m
  pigment { color srgb <0.72, 0.16, 0.11> }
  finish { Paint }
}

#declare Crate = box {
  <-0.4, -0.4, -0.2> * Wold_units_per_m, <0.4, 0.4, 0.75> * Wold_units_per_m
  rotate 30 * z
  translate <21.9, 8.8, Wold_height_m(21.9, 8.8)> * Wold_units_per_m
  pigment { color srgb <0.66, 0.63, 0.57> }
  finish { Paint }
}

#declare Things = union {
  object { Ball }
  object { Crate }
}

Wold_Shadows(Things)
Wold_Light(Degree)
Wold_Ground(Degree)
Wold_Grass(Wold_terrain, Degree)
Wold_Clouds(0)
Wold_Snow(0)
Wold_Camera(Degree)

object { Things }
