"""How green pictures of a meadow are through two years, beside what cameras over grassland saw.

    python3 tests/reference/season_colour.py WOLD FOLDER [--every DAYS] [--place NAME]

Renders the default meadow under the measured weather of each grassland of tests/data/weather, every
so many days, with Blender, and takes the green chromatic coordinate G / (R + G + B) of the mean of
the lower half of each picture, as cameras' pictures give it (gamma-encoded). The coordinates of a
place are scaled from 0, the least of the days, to 1, the greatest, as the tables are, and held
against them: Nash and Sutcliffe's efficiency of the days that were measured within two days.
FOLDER keeps the pictures and a table a place. The Python needs numpy and pillow.
"""

import argparse
import csv
import datetime
import pathlib
import subprocess
import sys

import numpy as np
from PIL import Image

TABLES = pathlib.Path(__file__).parents[1] / "data" / "weather"
# Latitude and longitude of each camera, degrees.
PLACES = {
    "freemangrass_grass": (29.93, -98.01),
    "lethbridge_grassland": (49.70, -112.94),
    "marena_canopy": (36.06, -97.21),
    "vaira_grass": (38.41, -120.95),
}
# The greenness of the days was fitted to the second year, not to the first.
YEARS = (2012, 2013)
SCENE = """
name = "{name}"
seed = 7

[grass]
levels = [62, 30]
variants = 2

[season]
first = [{first:%Y, %-m, %-d}]
last = [{last:%Y, %-m, %-d}]
frames = {frames}
table = '{table}'

[sun]
time = {noon:.2f}  # noon there
latitude = {latitude}
longitude = {longitude}

[camera]
eye = [21, 1.5]
target = [21, 15]
target_height = 0
field_of_view = 52

[render]
size = [192, 108]
samples = 4
renderer = "blender"
"""


def measured(place: str) -> dict[datetime.date, float]:
    with open(TABLES / f"phenocam_{place}.csv", encoding="utf-8") as table:
        rows = csv.DictReader(line for line in table if not line.startswith("#"))
        return {
            datetime.date.fromisoformat(row["date"]): float(row["greenness"])
            for row in rows
            if row["greenness"]
        }


def days(year: int, every: int) -> list[datetime.date]:
    return [datetime.date(year, 1, 1) + datetime.timedelta(days=i) for i in range(0, 365, every)]


def render(wold: str, folder: pathlib.Path, place: str, dates: list[datetime.date]) -> None:
    latitude, longitude = PLACES[place]
    name = f"{place}_{dates[0].year}"
    scene = folder / f"{name}.toml"
    scene.write_text(
        SCENE.format(
            name=name,
            first=dates[0],
            last=dates[-1],
            frames=len(dates),
            table=TABLES / f"phenocam_{place}.csv",
            noon=12.0 - longitude / 15.0,
            latitude=latitude,
            longitude=longitude,
        ),
        encoding="utf-8",
    )
    subprocess.run([wold, "render", scene, "--out", folder / name, "--quiet"], check=True)


def green_coordinate(picture: pathlib.Path) -> float:
    pixels = np.asarray(Image.open(picture).convert("RGB"), dtype=float)
    mean = pixels[pixels.shape[0] // 2 :].mean(axis=(0, 1))
    return mean[1] / mean.sum()


def near(values: dict[datetime.date, float], date: datetime.date) -> float:
    for off in (0, 1, -1, 2, -2):
        value = values.get(date + datetime.timedelta(days=off))
        if value is not None:
            return value
    return np.nan


def efficiency(modelled: np.ndarray, wanted: np.ndarray) -> float:
    return 1.0 - np.sum((modelled - wanted) ** 2) / np.sum((wanted - wanted.mean()) ** 2)


def pictures(folder: pathlib.Path, place: str, dates: list[datetime.date]) -> list[pathlib.Path]:
    frames = folder / f"{place}_{dates[0].year}" / "frames" / "blender"
    return [frames / f"{i + 1:04}.png" for i in range(len(dates))]


def judge(folder: pathlib.Path, place: str, years: list[list[datetime.date]]) -> None:
    green = np.array(
        [green_coordinate(p) for dates in years for p in pictures(folder, place, dates)]
    )
    scaled = (green - green.min()) / (green.max() - green.min())
    seen = measured(place)
    dates = [date for dates in years for date in dates]
    wanted = np.array([near(seen, date) for date in dates])
    with open(folder / f"{place}.csv", "w", encoding="utf-8") as table:
        print("date,green,scaled,measured", file=table)
        for row in zip(dates, green, scaled, wanted, strict=True):
            print("{},{:.4f},{:.3f},{:.3f}".format(*row), file=table)
    print(f"{place:22} coordinate {green.min():.3f} to {green.max():.3f}", end="")
    for year in YEARS:
        known = ~np.isnan(wanted) & np.array([date.year == year for date in dates])
        value = efficiency(scaled[known], wanted[known])
        print(f"   {year}: {known.sum()} days, efficiency {value:.2f}", end="")
    print(flush=True)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("wold", help="the program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--every", type=int, default=9, help="days between pictures")
    parser.add_argument("--place", choices=PLACES, action="append", help="all without it")
    parser.add_argument("--judge-only", action="store_true", help="pictures are there")
    chosen = parser.parse_args()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    years = [days(year, chosen.every) for year in YEARS]
    for place in chosen.place or PLACES:
        for dates in years if not chosen.judge_only else []:
            render(chosen.wold, chosen.folder, place, dates)
        judge(chosen.folder, place, years)
    return 0


if __name__ == "__main__":
    sys.exit(main())
