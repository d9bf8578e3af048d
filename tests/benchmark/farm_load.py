"""What a task of a film costs a farm's shared file system, and whether that grows with the film or
with the land that is seen:

    python3 tests/benchmark/farm_load.py WOLD [FRAMES...]         default: 20 400

For each number of frames a film's folder is filled as a farm would leave it: one frame is made,
and the others are copies of it by hard links. Then one task of each stage runs, and the system
calls that it makes below the output folder are counted by strace: files opened, names looked up
(stat, access, readlink, rename and their like), names that listed folders have, bytes read and
written. The same is counted of a frame with four times as much land. Exit code 1 when a task of
the longest film takes more calls or names than one of the shortest, or a picture of more land
notably more than one of less, 77 when strace or POV-Ray is missing.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

CALLS = {"openat": "opened", "open": "opened", "getdents64": "listed", "read": "read",
         "pread64": "read", "write": "written", "pwrite64": "written",
         "writev": "written"}  # fmt: skip
COLUMNS = ("opened", "looked up", "listed", "read", "written")
COUNTS = ("opened", "looked up", "listed")  # calls and names; the others are bytes

Load = dict[str, int]
SIDE_M, WIDE_SIDE_M = 4, 8  # of the land
FEW_MORE_CALLS = 60  # for textures of other distances; POV-Ray made ten and more for each cell once


def write_scene(folder: Path, frames: int, side_m: int) -> Path:
    degrees = ", ".join(f"{n / frames:.4f}" for n in range(frames))
    scene = folder / "film.toml"
    scene.write_text(
        f"""name = "film"
terrain = {{ size = {side_m}, samples = 33 }}
grass = {{ blades = 20, variants = 1, levels = [30], key_frames = [0.0, 1.0] }}
ageing = {{ frames = [{degrees}] }}
camera = {{ eye = [2, 0.5], target = [2, 3] }}
render = {{ renderer = "povray", size = [32, 18], samples = 1 }}
""",
        encoding="utf-8",
    )
    return scene


def link_tree(source: Path, target: Path, renamed: Callable[[str], str]) -> None:
    """Hard links under other names: what a film has of a frame, without its bytes."""
    if source.is_dir():
        target.mkdir()
        for part in source.iterdir():
            link_tree(part, target / renamed(part.name), renamed)
    else:
        os.link(source, target)


def fill(out: Path, frames: int) -> None:
    """Makes the frames from the third on look as if they had been made as the first."""
    of_frame = [
        path
        for path in out.rglob("*")
        if re.search(r"_0001(\.\w+)?$|^0001\.\w+$", path.name)
        and not path.name.startswith("texels_")
        and "frame_0001" not in path.parent.name
    ]
    for number in range(3, frames + 1):
        for path in of_frame:
            name = path.name.replace("0001", f"{number:04}")
            link_tree(path, path.with_name(name), str)


def count(log: Path, below: Path) -> Load:
    """What stands in strace's log of calls that concern files below a folder."""
    load = dict.fromkeys(COLUMNS, 0)
    for line in log.read_text(encoding="utf-8", errors="replace").splitlines():
        call = re.match(r"\d+ +(\w+)\((.*)\) += (-?\d+)", line)
        if not call or str(below) not in call.group(2):
            continue
        column = CALLS.get(call.group(1), "looked up")
        if column in ("read", "written"):
            load[column] += max(0, int(call.group(3)))
        elif column == "listed":
            entries = re.search(r"/\* (\d+) entries \*/", call.group(2))
            load[column] += int(entries.group(1)) if entries else 0
        else:
            load[column] += 1
    return load


def load_of(task: list[str], out: Path, folder: Path) -> Load:
    """Of a task. -y names the file of each descriptor; failed look-ups count, too."""
    log = folder / "calls"
    calls = "trace=%file,read,pread64,write,pwrite64,writev,getdents64,fstat"
    subprocess.run(["strace", "-f", "-y", "-s", "0", "-e", calls, "-o", log, *task], check=True)
    return count(log, out)


def measure(wold: str, frames: int, side_m: int = SIDE_M) -> dict[str, Load]:
    folder = Path(tempfile.mkdtemp(prefix="wold_farm_"))
    try:
        scene, out = write_scene(folder, frames, side_m), folder / "out"
        options = ["--out", str(out), "--passes", "depth", "--quiet"]

        def task(stage: str, index: int) -> list[str]:
            return [wold, "task", str(scene), stage, str(index), *options]

        for stage in ("texels", "passes", "scenes", "povray"):
            subprocess.run(task(stage, 1), check=True)
        fill(out, frames)
        loads = {
            f"{stage} {index}": load_of(task(stage, index), out, folder)
            for stage, index in (("passes", 2), ("scenes", 2), ("povray", 2), ("povray", 1))
        }
        loads["texels 1"] = load_of(task("texels", 1), out, folder)
        return loads
    finally:
        shutil.rmtree(folder)


def print_table(what: str, loads: dict[str, Load]) -> None:
    print(f"{what}\n{'task':10}" + "".join(f"{column:>11}" for column in COLUMNS))
    for task, load in loads.items():
        print(f"{task:10}" + "".join(f"{load[column]:11}" for column in COLUMNS))


def grown(of: str, few: Load, many: Load, more: int) -> list[str]:
    return [
        f"{of}: {column} {few[column]} -> {many[column]}"
        for column in COUNTS
        if many[column] > few[column] + more
    ]


def main() -> int:
    wold = sys.argv[1]
    lengths = [int(word) for word in sys.argv[2:]] or [20, 400]
    if not (shutil.which("strace") and shutil.which("povray")):
        print("skipped: strace or POV-Ray is not installed")
        return 77
    films = {frames: measure(wold, frames) for frames in lengths}
    for frames, loads in films.items():
        print_table(f"{frames} frames", loads)
    shortest, longest = films[min(films)], films[max(films)]
    wide = measure(wold, min(films), WIDE_SIDE_M)
    print_table("four times as much land", wide)
    faults = [
        fault for task, load in longest.items() for fault in grown(task, shortest[task], load, 2)
    ]
    faults += grown("wide land, povray 2", shortest["povray 2"], wide["povray 2"], FEW_MORE_CALLS)
    print("\n".join(["grows:", *faults]) if faults else "no task grows with the film or the land")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
