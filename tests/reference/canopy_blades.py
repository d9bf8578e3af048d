"""Light on blades as Blender and POV-Ray show them, against paths traced through the same blades.

    python3 tests/reference/canopy_blades.py build/wold tests/data/light/canopy.csv FOLDER [OPTIONS]

Renders level ground under the default meadow with `--grass blades`, through a narrow lens, and
compares the mean of each picture with the row of the table for its sun, weathering degree and view.
Prints a row per picture and how far each renderer is off: half of all figures, all of them. FOLDER
keeps what was rendered. The Python needs numpy and Pillow. Exit status 1 when a figure is out of
its bounds.
"""

import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys

import numpy as np
from PIL import Image

# Where the camera looks to, east and north, and how high it flies, metres: so high that it sees
# twenty patches at least, whose variants are drawn by lot.
TARGET_M = (60.0, 60.0)
EYE_HEIGHT_M = 30.0
# A film whose camera flies over the target at equal steps has these views among its frames: they
# are at multiples of tan 30 degrees.
STEEPEST_DEG = 60
FRAMES = {1: -60, 3: -30, 4: 0, 5: 30, 7: 60}
LAST_FRAME = 7

SCENE = """
[terrain]
size = 120.0
hill_height = 0.0
relief = 0.0
streams = 0.0
samples = 65
[grass]
key_frames = {key_frames}
[ageing]
age_spread = 0.0
pigment_spread = 0.0
frames = {frames}
[wind]
lean = 0.0
waves = 0.0
[sky]
visual_range = 1000000.0
[sun]
elevation = {sun_deg}
azimuth = 180.0
[camera]
eye = [{eye[0]}, {eye[1]}]
eye_height = {height}
eye_end = [{end[0]}, {end[1]}, {height}]
target = [{target[0]}, {target[1]}]
target_height = 0.0
field_of_view = 5.0
[render]
exposure = -2.0
"""

# What a renderer may be off by at most: half of all figures, and all of them.
MEDIAN, WORST = 0.035, 0.12


def scene_text(sun_deg: float, weathering: float, plane: str) -> str:
    reach = EYE_HEIGHT_M * math.tan(math.radians(STEEPEST_DEG))
    axis = 1 if plane == "principal" else 0

    def eye(side: float) -> tuple[float, ...]:
        return tuple(at + side * reach * (i == axis) for i, at in enumerate(TARGET_M))

    return SCENE.format(
        key_frames=sorted({0.0, weathering, 1.0}),
        frames=[weathering] * LAST_FRAME,
        sun_deg=sun_deg,
        # The table's angles are positive where the eye is in the north or in the east.
        eye=eye(-1.0),
        end=eye(1.0),
        height=EYE_HEIGHT_M,
        target=TARGET_M,
    )


def linear(display):
    """Radiance of sRGB values in [0, 1]."""
    return np.where(display <= 0.04045, display / 12.92, ((display + 0.055) / 1.055) ** 2.4)


def seen(film: pathlib.Path, renderer: str, frame: int):
    """Mean radiance times pi."""
    data = film / "blender" / "data" / f"frame_{frame:04d}" / "frame.json"
    gain = json.loads(data.read_text())["exposure_gain"]
    picture = Image.open(film / "frames" / renderer / f"{frame:04d}.png").convert("RGB")
    return linear(np.asarray(picture) / 255.0).mean(axis=(0, 1)) * math.pi / gain


def read_table(path: pathlib.Path) -> dict:
    with path.open() as file:
        return {
            (
                float(row["sun_deg"]),
                float(row["weathering"]),
                row["plane"],
                float(row["view_deg"]),
            ): np.array([float(row[channel]) for channel in ("red", "green", "blue")])
            for row in csv.DictReader(file)
        }


def render(chosen: argparse.Namespace, sun_deg: float, weathering: float, plane: str):
    """A film's folder."""
    chosen.folder.mkdir(parents=True, exist_ok=True)
    film = chosen.folder / f"{sun_deg:g}_{weathering:g}_{plane}"
    scene = chosen.folder / f"{film.name}.toml"
    scene.write_text(scene_text(sun_deg, weathering, plane))
    command = [chosen.wold.resolve(), "render", scene, "--out", film, "--renderer", "both"]
    command += ["--frames", ",".join(map(str, FRAMES)), "--grass", chosen.grass, "--quiet"]
    command += ["--size", f"{chosen.pixels}x{chosen.pixels}", "--samples", "1"]
    subprocess.run(command, check=True)
    return film


def main() -> int:
    parser = argparse.ArgumentParser(description="Light on blades in pictures.")
    parser.add_argument("wold", type=pathlib.Path)
    parser.add_argument("table", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--suns", type=float, nargs="*", default=[20.0, 40.0, 60.0])
    parser.add_argument("--weathering", type=float, nargs="*", default=[0.0, 0.6])
    parser.add_argument("--planes", nargs="*", default=["principal", "across"])
    parser.add_argument("--grass", default="blades", help="or texels")
    # One sample each: POV-Ray takes more where neighbours differ, which favours what is even.
    parser.add_argument("--pixels", type=int, default=320)
    chosen = parser.parse_args()
    table = read_table(chosen.table)
    off: dict[str, list] = {"blender": [], "povray": []}
    print("renderer sun weathering plane view: red, green, blue over the table's")
    for sun_deg in chosen.suns:
        for weathering in chosen.weathering:
            for plane in chosen.planes:
                film = render(chosen, sun_deg, weathering, plane)
                for frame, view_deg in FRAMES.items():
                    for renderer, figures in off.items():
                        ratio = (
                            seen(film, renderer, frame)
                            / table[sun_deg, weathering, plane, view_deg]
                        )
                        red, green, blue = ratio
                        print(
                            f"{renderer:8} {sun_deg:g} {weathering:g} {plane:9} {view_deg:4}: "
                            f"{red:.3f} {green:.3f} {blue:.3f}",
                            flush=True,
                        )
                        figures.extend(np.abs(ratio - 1.0))
    for renderer, figures in off.items():
        print(f"{renderer}: median {np.median(figures):.3f}, worst {np.max(figures):.3f}")
    good = all(np.median(f) <= MEDIAN and np.max(f) <= WORST for f in off.values())
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
