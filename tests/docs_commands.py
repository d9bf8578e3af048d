"""Runs the commands that the docs show, page by page, as a reader would in an empty folder:

    python3 tests/docs_commands.py WOLD [PAGE...]       default: the pages for those who begin
    python3 tests/docs_commands.py --pages              lists these

Pictures are made small and grass coarse, so that a page takes seconds. What a page expects to be
there (moor.toml, dem.tif, days.csv, the examples) is laid there first. Lines that name no program
of Wold's are left out, as are those that need a network or a cluster. Exit code 1 when a command
fails, 77 without POV-Ray and Blender.
"""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PAGES = [
    "README.md",
    "docs/for_blender_users.md",
    "docs/for_povray_users.md",
    "docs/for_scientists.md",
    "docs/passes.md",
    "docs/scripting.md",
    "docs/tasks.md",
    "docs/openjd.md",
    "docs/own_scenes.md",
]
SMALL = [
    "--set", "render.size=[48,27]", "--set", "render.samples=1", "--set", "terrain.samples=33",
    "--set", "grass.variants=1", "--set", "grass.levels=[30]",
    "--set", "grass.key_frames=[0,0.5,1]",
]  # fmt: skip
# Of the scenes that `wold new` writes: what is before the camera, bushes alone having places of
# their own, and two pictures.
SMALL_NEW = [
    "--set", "terrain.size=22", "--set", "terrain.hill_height=2", "--set", "terrain.relief=0.3",
    "--set", "terrain.relief_feature=10", "--set", "camera.eye=[11,2]",
    "--set", "camera.target=[11,18]", "--set", "paths[1].way=[11,4,12,18]",
    "--set", "species[2].cover=1", "--set", "species[3].cover=1", "--set", "species[3].driest=0",
    "--set", "ageing.frames=[0,0.6]",
]  # fmt: skip
DAYS = [31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31]
MAKES = {"render", "generate", "passes", "preview", "task"}
LONG_OPTIONS = re.compile(r" --(size|frames) [\w,-]+")


def commands_of(page: str) -> list[str]:
    """Indented lines that run wold or one of its scripts, or POV-Ray on what it has made."""
    text = (ROOT / page).read_text(encoding="utf-8")
    lines = (line.split("  #")[0].strip() for line in re.findall(r"^    (\S.*)$", text, re.M))
    runs = re.compile(r"(build/)?wold |examples/scripting/|povray |cd ")
    return [line for line in lines if runs.match(line) and "http" not in line]


def lay_out(page: str, folder: Path, wold: str) -> None:
    """What pages take to be there, and the files that they show: blocks that begin with a name."""
    text = (ROOT / page).read_text(encoding="utf-8")
    for block in re.findall(r"^(    # \w+\.toml\n(?:(?:    .*)?\n)*)", text, re.M):
        (folder / block.split()[1]).write_text(re.sub(r"^    ", "", block, flags=re.M))
    subprocess.run([wold, "new", "moor"], cwd=folder, capture_output=True, check=True)
    shutil.copytree(ROOT / "examples", folder / "examples")
    heights = "\n".join(
        " ".join(str(900 + (row * column) % 37) for column in range(41)) for row in range(41)
    )
    (folder / "dem.tif").write_text(
        "ncols 41\nnrows 41\nxllcorner 0\nyllcorner 0\ncellsize 90\nNODATA_value -9999\n" + heights
    )
    days = (
        f"2003-{month + 1:02}-{day:02},{5 - abs(month - 6)},{14 - abs(month - 6)},{day % 4}"
        for month in range(12)
        for day in range(1, DAYS[month] + 1)
    )
    (folder / "days.csv").write_text(
        "date,tmin_c,tmax_c,precipitation_mm\n" + "\n".join(days) + "\n"
    )


def shrunk(command: str, wold: str) -> str:
    """The same command for little pictures, with the program that is tested."""
    command = re.sub(r"^(build/)?wold ", f"{shlex.quote(wold)} ", command)
    words = command.split()
    verb = words[1] if words[0] == shlex.quote(wold) else ""
    if words[0] == "povray":
        return re.sub(r"\+[WH]\d+", "", command) + " +W48 +H27 -D"
    if words[0].startswith("examples/scripting/"):
        command = re.sub(r" --vary sky.turbidity 2 4", "", LONG_OPTIONS.sub("", command))
        world = " --worlds 1 --frames 2" if "data_set" in words[0] else ""
        few = " --set ageing.frames=[0.3]" if not world else ""
        return f"{command} --wold {shlex.quote(wold)}{world}{few} {shlex.join(SMALL)}"
    if verb in MAKES or "--out /" in command:
        command = re.sub(r" --size \w+", "", command)
        new = SMALL_NEW if "moor.toml" in words else []
        return f"{command} {shlex.join(SMALL + new)}"
    return command


def wrong_commands(page: str, wold: str) -> list[str]:
    folder = Path(tempfile.mkdtemp(prefix="wold_docs_"))
    try:
        lay_out(page, folder, wold)
        shared = folder / "shared"
        wrong, place = [], folder
        for shown in commands_of(page):
            if shown.startswith("cd "):
                place = (place / shown.removeprefix("cd ")).resolve()
                continue
            command = shrunk(shown, wold).replace("/shared/", f"{shared}/")
            if re.match(r"\S+ new ", command):
                (folder / (command.split()[2].removesuffix(".toml") + ".toml")).unlink(
                    missing_ok=True
                )
            result = subprocess.run(
                ["bash", "-c", command], cwd=place, capture_output=True, text=True
            )
            if result.returncode != 0:
                wrong.append(f"{page}: {shown}\n  {result.stderr.strip()[-600:]}")
        return wrong
    finally:
        shutil.rmtree(folder)


def main() -> int:
    if sys.argv[1] == "--pages":
        print("\n".join(PAGES))
        return 0
    wold = str(Path(sys.argv[1]).resolve())
    if not (shutil.which("povray") and shutil.which("blender") and shutil.which("ffmpeg")):
        print("skipped: a renderer or FFmpeg is not installed")
        return 77
    count, wrong = 0, []
    for page in sys.argv[2:] or PAGES:
        count += len(commands_of(page))
        start = time.monotonic()
        wrong += wrong_commands(page, wold)
        print(f"{page}: {time.monotonic() - start:.0f} s", flush=True)
    print("\n".join(wrong) if wrong else f"{count} commands: all work")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
