"""How a meadow's brightness waves move in a film whose camera stands still, by its pictures:

    wold render SCENE --passes position --frames ... --out DIR
    python3 tests/benchmark/moving_film.py DIR/passes/0001.exr PICTURES... [--fps 24] [--cell 1]

The first file says where in the world each pixel lies; pictures are in their order. Needs NumPy,
Pillow and OpenEXR from Python's registry. It prints
  contrast   standard deviation over time and places of the luminance of squares of the ground, over
             each square's own mean: what waves, without what stands,
  waves      velocity at which a picture of these waves fits the later ones best: speed and heading,
             and how well it fits (correlation) beside not moving at all,
  steps      change from a frame to the next, mean over blocks of 8 x 8 pixels in 255ths, and the
             largest over the median: popping,
  still      the same of what is not grass within the waves' reach: sky and distance.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
import OpenEXR
from numpy.typing import NDArray
from PIL import Image

Array = NDArray[np.float64]
BOX = 8  # pixels


def luminance(path: Path) -> Array:
    """Linear, of an sRGB picture."""
    srgb = np.asarray(Image.open(path).convert("RGB"), dtype=np.float64) / 255.0
    linear = np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)
    return np.asarray(linear @ np.array([0.2126, 0.7152, 0.0722]))


def positions(path: Path) -> tuple[Array, Array]:
    """East and north of what each pixel shows, metres."""
    with OpenEXR.File(str(path), separate_channels=True) as file:
        channels = file.channels()
        return tuple(np.asarray(channels[f"position.{c}"].pixels, np.float64) for c in "XY")


class Ground:
    """Squares of the ground that pixels are gathered in."""

    def __init__(self, east: Array, north: Array, cell_m: float, reach_m: float) -> None:
        self.seen = (np.abs(east) < 1e5) & (np.abs(north) < 1e5)
        middle = np.median(east[self.seen]), np.min(north[self.seen])
        self.seen &= (np.abs(east - middle[0]) < reach_m) & (north < middle[1] + 2.0 * reach_m)
        column = np.floor((east[self.seen] - middle[0] + reach_m) / cell_m).astype(int)
        row = np.floor((north[self.seen] - middle[1]) / cell_m).astype(int)
        self.side = int(2.0 * reach_m / cell_m) + 1
        self.number = row * self.side + column
        self.count = np.bincount(self.number, minlength=self.side**2)

    def means(self, picture: Array) -> Array:
        sums = np.bincount(self.number, picture[self.seen], minlength=self.side**2)
        with np.errstate(invalid="ignore", divide="ignore"):
            means = np.where(self.count >= 3, sums / self.count, np.nan)
        return means.reshape(self.side, self.side)


def moved(field: Array, rows: float, columns: float) -> Array:
    """The field as it is so many squares on: value at (r, c) is that of (r + rows, c + columns)."""
    r0, c0 = int(np.floor(rows)), int(np.floor(columns))
    fr, fc = rows - r0, columns - c0
    result = np.zeros_like(field)
    for dr, dc in ((0, 0), (0, 1), (1, 0), (1, 1)):
        weight = (fr if dr else 1.0 - fr) * (fc if dc else 1.0 - fc)
        shifted = np.full_like(field, np.nan)
        r, c = r0 + dr, c0 + dc
        rows_to = slice(max(0, -r), field.shape[0] - max(0, r))
        columns_to = slice(max(0, -c), field.shape[1] - max(0, c))
        rows_from = slice(max(0, r), field.shape[0] - max(0, -r))
        columns_from = slice(max(0, c), field.shape[1] - max(0, -c))
        shifted[rows_to, columns_to] = field[rows_from, columns_from]
        result += weight * shifted if weight > 0.0 else 0.0
    return result


def correlation(a: Array, b: Array) -> float:
    both = np.isfinite(a) & np.isfinite(b)
    if both.sum() < 50:
        return -1.0
    x, y = a[both], b[both]
    return float(np.sum(x * y) / np.sqrt(np.sum(x * x) * np.sum(y * y)))


def fit(waves: list[Array], lag: int, rows: float, columns: float) -> float:
    pairs = zip(waves[:-lag], waves[lag:])
    return float(np.mean([correlation(a, moved(b, rows, columns)) for a, b in pairs]))


def best_shift(waves: list[Array], lag: int, most: float) -> tuple[float, float, float]:
    """Rows and columns per `lag` frames that fit best, and the fit: a coarse search, then a fine
    one about its best."""
    steps = np.arange(-most, most + 0.5, 1.0)
    best = max((fit(waves, lag, r, c), r, c) for r in steps for c in steps)
    for step in (0.5, 0.25, 0.1):
        near = (-step, 0.0, step)
        best = max((fit(waves, lag, best[1] + r, best[2] + c), best[1] + r, best[2] + c)
                   for r in near for c in near)  # fmt: skip
    return best[1], best[2], best[0]


def blocks(picture: Array, mask: Array) -> Array:
    rows, columns = (n // BOX for n in picture.shape)
    cut = (slice(0, rows * BOX), slice(0, columns * BOX))

    def sums(values: Array) -> Array:
        return np.asarray(values[cut].reshape(rows, BOX, columns, BOX).sum(axis=(1, 3)))

    whole = sums(mask.astype(np.float64)) == BOX * BOX
    return sums(picture)[whole] / (BOX * BOX)


def step_line(name: str, pictures: list[Array], mask: Array) -> str:
    film = [255.0 * blocks(picture, mask) for picture in pictures]
    if film[0].size == 0:
        return f"{name}: none"
    steps = np.array([np.mean(np.abs(b - a)) for a, b in zip(film, film[1:])])
    most = steps.max() / max(float(np.median(steps)), 1e-9)
    return f"{name}: {steps.mean():.3f} on average, the largest {most:.2f} of the median"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("position", type=Path)
    parser.add_argument("pictures", type=Path, nargs="+")
    parser.add_argument("--fps", type=float, default=24.0)
    parser.add_argument("--cell", type=float, default=1.0, help="side of a square, metres")
    parser.add_argument(
        "--reach", type=float, default=14.0, help="half of the field's side, metres"
    )
    parser.add_argument("--lag", type=int, default=4, help="frames between pictures that are held")
    parser.add_argument("--fastest", type=float, default=16.0, help="m/s that are looked for")
    options = parser.parse_args()
    pictures = [luminance(path) for path in options.pictures]
    ground = Ground(*positions(options.position), options.cell, options.reach)
    film = np.array([ground.means(picture) for picture in pictures])
    waves = film / film.mean(axis=0) - 1.0
    print(f"contrast: {np.sqrt(np.nanmean(waves**2)):.4f}")
    later_s = options.lag / options.fps
    fields = list(waves)
    rows, columns, found = best_shift(
        fields, options.lag, np.ceil(options.fastest * later_s / options.cell)
    )
    north, east = (n * options.cell / later_s for n in (rows, columns))
    heading = np.degrees(np.arctan2(east, north)) % 360.0
    print(
        f"waves: {np.hypot(north, east):.2f} m/s to {heading:.0f} degrees,"
        f" fit {found:.2f}, not moving {fit(fields, options.lag, 0.0, 0.0):.2f}"
    )
    srgb = [np.clip(picture, 0.0, 1.0) ** (1.0 / 2.2) for picture in pictures]
    print(step_line("steps", srgb, ground.seen))
    print(step_line("still", srgb, ~ground.seen))


if __name__ == "__main__":
    main()
