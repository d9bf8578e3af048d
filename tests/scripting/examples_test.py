"""The scripts of examples/scripting, run as their users would, with a program in the place of wold
where it is their own doing that counts.

    WOLD=build/wold python3 -m unittest discover -s tests/scripting -p '*_test.py'
"""

from __future__ import annotations

import csv
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as xml
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
WOLD = os.environ.get("WOLD", str(ROOT / "build/wold"))
SCENE = """name = "tiny"
terrain = { size = 4, samples = 33 }
grass = { blades = 20, variants = 1, levels = [30], key_frames = [0.0, 1.0] }
ageing = { frames = [0.1] }
camera = { eye = [2, 0.5], target = [2, 3] }
render = { renderer = "povray", size = [32, 18], samples = 1 }
"""


@unittest.skipUnless(shutil.which("povray"), "no POV-Ray on this machine")
class Examples(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = Path(tempfile.mkdtemp(prefix="wold_scripts_"))
        self.addCleanup(shutil.rmtree, self.folder)
        (self.folder / "tiny.toml").write_text(SCENE, encoding="utf-8")

    def script(
        self, name: str, *words: str, code: int = 0, wold: str = WOLD
    ) -> subprocess.CompletedProcess[str]:
        result = subprocess.run(
            [sys.executable, "-B", ROOT / "examples/scripting" / name, *words, "--wold", wold],
            cwd=self.folder,
            capture_output=True,
            text=True,
        )
        self.assertEqual(result.returncode, code, f"{name} {words}: {result.stderr}")
        return result

    def failing_at(self, call: int) -> str:
        """A program that is wold, but for its n-th call of render, which is cut off."""
        program = self.folder / "failing"
        program.write_text(
            f"""#!/bin/sh
if [ "$1" = render ] && echo >>calls && [ "$(wc -l <calls)" = {call} ]; then
  echo "error: the disk is full" >&2
  exit 4
fi
exec '{WOLD}' "$@"
"""
        )
        program.chmod(0o755)
        return str(program)

    def files(self) -> set[str]:
        return {path.name for path in self.folder.rglob("*") if path.is_file()}

    def test_sweep_puts_every_combination_on_its_sheet(self) -> None:
        words = ["tiny.toml", "--vary", "sun.elevation", "8", "45", "--vary", "sky.turbidity", "2",
                 "4", "--out", "sweep"]  # fmt: skip
        cut = self.script("sweep.py", *words, code=4, wold=self.failing_at(3))
        self.assertIn("the disk is full", cut.stderr)
        self.assertFalse((self.folder / "sweep/sheet.html").exists())
        first = self.folder / "sweep/001/frames/povray/0001.png"
        made = first.stat().st_mtime_ns
        self.assertEqual(self.script("sweep.py", *words).stdout, "sweep/sheet.html\n")
        self.assertEqual(first.stat().st_mtime_ns, made, "what was done has been done again")
        sheet = (self.folder / "sweep/sheet.html").read_text(encoding="utf-8")
        for elevation in (8, 45):
            for turbidity in (2, 4):
                caption = f"sun.elevation={elevation}<br>sky.turbidity={turbidity}<"
                self.assertEqual(sheet.count(caption), 1)
        pictures = {part.split('"')[0] for part in sheet.split("data:image/png;base64,")[1:]}
        self.assertEqual(len(pictures), 4, "each has a picture of its own")

    def test_sweep_refuses_a_wrong_value_before_it_makes_anything(self) -> None:
        words = ["tiny.toml", "--vary", "sun.elevation", "8", "95", "--out", "sweep"]
        result = self.script("sweep.py", *words, code=2)
        self.assertIn("sun.elevation: found 95", result.stderr)
        self.assertFalse((self.folder / "sweep").exists())

    def test_golden_pictures_tell_what_has_changed(self) -> None:
        words = ["tiny.toml", "--golden", "golden"]
        self.assertIn(
            "is missing; --update makes it", self.script("golden.py", *words, code=1).stdout
        )
        self.script("golden.py", *words, "--update")
        self.assertEqual(self.script("golden.py", *words).stdout, "tiny/povray/0001: same\n")
        changed = [*words, "--set", "sun.elevation=8", "--junit", "results.xml"]
        result = self.script("golden.py", *changed, code=1)
        self.assertIn("tiny/povray/0001: rmse is ", result.stdout)
        self.assertTrue(
            (self.folder / "out/golden/differences/tiny/povray/0001/index.html").exists()
        )
        suite = xml.parse(self.folder / "results.xml").getroot()
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("1", "1"))
        self.assertIn("rmse is ", str(suite[0][0].get("message")))
        wrong = self.script("golden.py", *words, "--set", "sun.elevation=95", code=2)
        self.assertIn("sun.elevation: found 95", wrong.stderr)

    def test_data_set_has_a_row_for_every_frame(self) -> None:
        words = ["tiny.toml", "--out", "set", "--worlds", "2", "--frames", "2", "--passes",
                 "depth,species", "--range", "sun.elevation", "8", "60"]  # fmt: skip
        self.script("data_set.py", *words, code=4, wold=self.failing_at(2))
        self.assertNotIn("frames.csv", self.files())
        self.assertEqual(self.script("data_set.py", *words).stdout, "set/frames.csv\n")
        table = (self.folder / "set/frames.csv").read_text(encoding="utf-8")
        rows = list(csv.DictReader(table.splitlines()))
        self.assertEqual([row["world"] + row["frame"] for row in rows], ["11", "12", "21", "22"])
        for row in rows:
            for column in ("povray", "passes"):
                self.assertTrue((self.folder / "set" / row[column]).is_file(), row[column])
            self.assertTrue(8 <= float(row["sun.elevation"]) <= 60)
        self.assertEqual(rows[0]["seed"], rows[1]["seed"])
        self.assertNotEqual(rows[0]["seed"], rows[2]["seed"])
        self.assertEqual(len({row["weathering"] for row in rows}), 4)
        # One world more leaves those before it as they are.
        longer = self.script("data_set.py", *words, "--worlds", "3", "--passes", "depth")
        self.assertEqual(longer.returncode, 0)
        again = (self.folder / "set/frames.csv").read_text(encoding="utf-8")
        self.assertEqual(list(csv.DictReader(again.splitlines()))[:4], rows)

    def test_what_is_missing_is_named(self) -> None:
        result = self.script("sweep.py", "tiny.toml", "--vary", "seed", "1", "--out", "sweep",
                             code=1, wold="/nowhere/wold")  # fmt: skip
        self.assertEqual(
            result.stderr, "error: cannot run /nowhere/wold: No such file or directory\n"
        )


if __name__ == "__main__":
    unittest.main()
