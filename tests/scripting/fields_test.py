"""Whether docs/scripting.md names just the fields that commands print as JSON.

    WOLD=build/wold python3 -m unittest discover -s tests/scripting -p '*_test.py'

Every field that is printed has to stand in a table of the command's section, and every field of a
table has to be printed by one of the runs.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import tempfile
import unittest
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
WOLD = os.environ.get("WOLD", str(ROOT / "build/wold"))
SCENE = """name = "tiny"
terrain = { size = 4, samples = 33 }
grass = { blades = 20, variants = 1, levels = [30], key_frames = [0.0, 1.0] }
ageing = { frames = [0.1, 0.5] }
camera = { eye = [2, 0.5], target = [2, 3] }
render = { renderer = "povray", size = [32, 18], samples = 1 }
[[clouds]]
"""


def documented(command: str) -> set[str]:
    """The paths in the tables of a command's section."""
    page = (ROOT / "docs/scripting.md").read_text(encoding="utf-8")
    section = page.split(f"\n## wold {command}\n")[1].split("\n## ")[0]
    first_columns = re.findall(r"^\| (`.*?`) \|", section, flags=re.MULTILINE)
    return set(re.findall(r"`([^`]+)`", "\n".join(first_columns)))


def fields(value: Any, path: str = "") -> Iterator[str]:
    """The paths of all values that are neither objects nor arrays of objects."""
    if isinstance(value, dict):
        for name, part in value.items():
            yield from fields(part, f"{path}.{name}" if path else name)
    elif isinstance(value, list) and value and all(isinstance(part, dict) for part in value):
        for part in value:
            yield from fields(part, path + "[]")
    else:
        yield path


def pattern(path: str) -> re.Pattern[str]:
    """Words in capitals stand for any name, which may have dots of its own."""
    return re.compile(re.sub(r"\\?\b[A-Z]+\b", "[^\\\\[\\\\]]+", re.escape(path)))


class Fields(unittest.TestCase):
    folder: Path

    @classmethod
    def setUpClass(cls) -> None:
        cls.folder = Path(tempfile.mkdtemp(prefix="wold_fields_"))
        (cls.folder / "tiny.toml").write_text(SCENE, encoding="utf-8")

    @classmethod
    def tearDownClass(cls) -> None:
        shutil.rmtree(cls.folder)

    def answer(self, *words: str, code: int = 0) -> Any:
        result = subprocess.run([WOLD, *words], cwd=self.folder, capture_output=True, text=True)
        self.assertEqual(result.returncode, code, f"{words}: {result.stderr}")
        answer = json.loads(result.stdout)
        for part in answer if isinstance(answer, list) else [answer]:
            self.assertEqual(part["version"], 1)
        return answer

    def hold(self, command: str, answers: list[Any], elsewhere: tuple[str, ...] = ()) -> None:
        """`elsewhere`: fields that this machine or these files do not have."""
        named = documented(command)
        printed = {path for answer in answers for path in fields(answer)}
        known = [pattern(path) for path in named]
        for path in sorted(printed):
            self.assertTrue(any(one.fullmatch(path) for one in known), f"{path} is not in the docs")
        for path in sorted(named - set(elsewhere)):
            # An object that may be null stands in the tables with its fields.
            one = re.compile(pattern(path).pattern + r"(\..*|\[\].*)?")
            self.assertTrue(any(one.fullmatch(got) for got in printed), f"{path} is never printed")

    def test_version(self) -> None:
        named = ("ffmpeg.program", "ffmpeg.version")
        answer = self.answer("--version", "--json")
        if answer["ffmpeg"] is None:
            del answer["ffmpeg"]
        self.hold("--version --json", [answer], named)

    def test_check(self) -> None:
        answer = self.answer("check", "tiny.toml", "--json")
        self.hold("check --json", [answer])
        scene = answer["scene"]
        self.assertEqual(scene["grass"]["blades"], 20)
        self.assertEqual(scene["ageing"]["frames"], [0.1, 0.5])
        self.assertEqual([layer["kind"] for layer in scene["clouds"]], ["cumulus"])
        text = subprocess.run(
            [WOLD, "check", "tiny.toml"], cwd=self.folder, capture_output=True, text=True
        ).stdout
        keys = re.findall(r"^(\w+) = ", text, flags=re.MULTILINE)
        self.assertEqual(sorted(keys), sorted(self.keys_of(scene)))

    def keys_of(self, scene: dict[str, Any]) -> Iterator[str]:
        lists = ("species", "clouds", "cloud_events", "season_keys", "shots")
        lists += ("paths", "cover_classes")
        for name, value in scene.items():
            if isinstance(value, dict):
                yield from value
            elif name in lists:
                for item in value:
                    yield from item
            else:
                yield name

    def test_explain(self) -> None:
        answers = [self.answer("explain", key, "--json") for key in ("sun.elevation", "clouds")]
        for answer in answers:
            for key in answer["keys"]:
                key["schema"] = str(key["schema"])  # what JSON Schema has is not ours to list
        self.hold("explain --json", answers)
        self.assertEqual(answers[0]["keys"][0]["default"], 38.0)
        self.assertEqual({key["repeats"] for key in answers[1]["keys"]}, {True})

    def test_plan(self) -> None:
        answers = [self.answer("plan", "tiny.toml", "--json")]
        answers.append(self.answer("render", "tiny.toml", "--dry-run", "--json"))
        self.assertEqual(answers[0], answers[1])
        self.hold("plan --json", answers)

    def test_what_has_been_made(self) -> None:
        generated = self.answer("generate", "tiny.toml", "--json", "--out", "made", "--quiet")
        self.assertEqual([frame["pictures"] for frame in generated["frames"]], [{}, {}])
        passes = self.answer("passes", "tiny.toml", "--json", "--out", "made", "--quiet")
        answers = [passes]
        if shutil.which("povray"):
            words = ["render", "tiny.toml", "--json", "--out", "made", "--quiet"]
            answers.append(self.answer(*words, "--passes", "all"))
        for frame in answers[-1]["frames"]:
            for file in [*frame["pictures"].values(), frame["passes"]]:
                self.assertTrue((self.folder / file).is_file(), file)
        without = () if len(answers) > 1 else ("frames[].pictures.RENDERER",)
        self.hold("render --json", answers, without)
        self.inspect_and_compare()

    def inspect_and_compare(self) -> None:
        made = self.folder / "made"
        df3 = next(made.rglob("*.df3"))
        vdb = [str(file) for file in sorted((made / "texels").glob("*.vdb"))]
        pictures = [str(file) for file in sorted((made / "clouds").glob("*.png"))]
        passes = [str(made / f"passes/000{n}.exr") for n in (1, 2)]
        files = [str(df3), vdb[0], pictures[0], passes[0]]
        self.hold("inspect --json", [self.answer("inspect", *files, "--json")])
        damaged = self.folder / "damaged.png"
        damaged.write_bytes(b"\x89PNG\r\n")
        faulty = self.answer("inspect", str(damaged), "--json", code=4)
        self.assertEqual(len(faulty[0]["problems"]), 1)
        answers = [
            self.answer("compare", pictures[0], pictures[0]),
            self.answer("compare", str(df3), str(df3)),
            self.answer("compare", vdb[0], vdb[-1], code=1),
        ]
        folders = self.answer("compare", str(made / "clouds"), str(made / "clouds"))
        pairs = folders.pop("files")
        self.hold("compare", [*answers, folders | {"files": []}, *pairs])

    def test_maps(self) -> None:
        answer = self.answer("maps", "tiny.toml", "--json", "--out", "maps", "--quiet")
        self.hold("maps --json", [answer])
        for one in answer:
            self.assertTrue((self.folder / one["file"]).is_file(), one["file"])

    def test_wind(self) -> None:
        answer = self.answer("wind", "tiny.toml", "--json", "--at", "1,2,10,0", "--at", "1,2,10,5")
        self.hold("wind --json", [answer])
        self.assertEqual([one["time_s"] for one in answer], [0.0, 5.0])

    def test_doctor(self) -> None:
        if not (shutil.which("povray") or shutil.which("blender")):
            self.skipTest("no renderer on this machine")
        result = subprocess.run([WOLD, "doctor", "--json"], capture_output=True, text=True)
        answer = json.loads(result.stdout)
        self.assertEqual(result.returncode, 0 if answer["complete"] else 3)
        elsewhere = tuple(
            path
            for path in documented("doctor --json")
            if path.startswith(("other_blenders", "ffmpeg")) or ".capabilities.devices" in path
        )
        for name in ("other_blenders", "ffmpeg"):
            if not answer[name]:
                del answer[name]
        for renderer in answer["renderers"]:
            if renderer["capabilities"] and not renderer["capabilities"]["devices"]:
                del renderer["capabilities"]["devices"]
        self.hold("doctor --json", [answer], elsewhere)


if __name__ == "__main__":
    unittest.main()
