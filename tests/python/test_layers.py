"""The check of includes against the table of libraries sees each kind of fault."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import layers

TABLE = """
wold_library(core PUBLIC fmt::fmt PRIVATE GDAL::GDAL)
wold_library(sun PUBLIC wold_core)  # shines
wold_library(snow PUBLIC wold_core
  PRIVATE wold_sun)
wold_library(film PUBLIC wold_snow)
"""
FILES = {
    "core/curve.h": "#include <vector>",
    "core/raster.cpp": "#include <gdal_priv.h>",
    "sun/sun.h": '#include "core/curve.h"',
    "snow/snow.h": '#include "core/curve.h"',
    "snow/melt.cpp": '#include "sun/sun.h"',
    "film/film.h": '#include "core/curve.h"\n#include "snow/snow.h"',
}


class Layers(unittest.TestCase):
    def faults(self, table=TABLE, **files):
        """Of FILES with these, "_" for "/" and the extension after the last one."""
        with tempfile.TemporaryDirectory() as scratch:
            gen = pathlib.Path(scratch)
            (gen / "CMakeLists.txt").write_text(table)
            changed = {"{}/{}.{}".format(*name.split("_")): text for name, text in files.items()}
            for name, text in {**FILES, **changed}.items():
                (gen / name).parent.mkdir(exist_ok=True)
                (gen / name).write_text(text + "\n")
            return layers.faults(gen)

    def has(self, words, faults):
        self.assertTrue(any(words in fault for fault in faults), faults)

    def test_what_agrees_has_no_fault(self):
        self.assertEqual(self.faults(), [])

    def test_a_library_that_is_not_in_the_line(self):
        found = self.faults(sun_rise_cpp='#include "snow/snow.h"')
        self.assertEqual(found, ['sun/rise.cpp: "snow/snow.h": not in the links of sun'])

    def test_a_header_has_only_what_is_public(self):
        found = self.faults(snow_glare_h='#include "sun/sun.h"')
        self.assertEqual(found, ['snow/glare.h: "sun/sun.h": not in the PUBLIC links of snow'])

    def test_private_links_are_not_handed_on(self):
        found = self.faults(film_a_cpp='#include "sun/sun.h"')
        self.has('"sun/sun.h": not in the links of film', found)

    def test_libraries_of_others_are_asked_for_too(self):
        self.has('"gdal_priv.h": not in the', self.faults(sun_a_cpp="  #  include <gdal_priv.h>"))

    def test_an_arrow_that_nobody_needs(self):
        self.has("no file of snow includes sun", self.faults(snow_melt_cpp=""))
        self.has("no header of film includes snow", self.faults(film_film_h=""))

    def test_a_circle(self):
        table = TABLE.replace("sun PUBLIC wold_core", "sun PUBLIC wold_core PRIVATE wold_film")
        self.has("film is linked to itself", self.faults(table))

    def test_a_folder_that_is_no_library(self):
        self.has("rain: not in the table", self.faults(rain_rain_h=""))

    def test_physics_that_takes_the_whole_scene(self):
        found = self.faults(snow_fall_h="void fall(const scene::Scene& scene);")
        self.assertEqual(found, ["snow/fall.h:1: takes the whole scene"])
        self.assertEqual(self.faults(film_film_cpp="void f(const scene::Scene& scene);"), [])

    def test_the_table_of_wold_is_read_whole(self):
        gen = pathlib.Path(layers.__file__).resolve().parents[1] / "gen"
        table = layers.read_table((gen / "CMakeLists.txt").read_text())
        self.assertIn("core", table["scene"].public)
        self.assertGreater(len(table), 25)
