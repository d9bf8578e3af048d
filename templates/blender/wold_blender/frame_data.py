"""What `wold generate` has written for one frame: frame.json and the files that it names.

The folder holds data only. Nothing in it is run, and no name in it may lead out of it.
"""

from __future__ import annotations

import array
import json
import os
import re
import sys
from typing import Any, NamedTuple

# Of the folder; gen/blender/frame_data.cpp writes the newest one where a frame needs it.
OLDEST_FORMAT, NEWEST_FORMAT = 7, 9


class DataError(Exception):
    """A file of the frame is missing, damaged or of another version of Wold."""


def read_json(path: str) -> Any:
    try:
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    except (OSError, ValueError, RecursionError) as error:
        raise DataError(f"cannot read {path}: {error}; run `wold generate` again") from error


def check_format(frame: Any, path: str) -> None:
    found = frame.get("format") if isinstance(frame, dict) else None
    if not isinstance(found, int) or not OLDEST_FORMAT <= found <= NEWEST_FORMAT:
        raise DataError(
            f"{path} has format {found}, {NEWEST_FORMAT} was expected: generate the scene and"
            " render it with the same version of Wold"
        )


def check_size(path: str, expected: int) -> None:
    if not os.path.isfile(path):
        raise DataError(f"{path} is missing")
    found = os.path.getsize(path)
    if found != expected:
        raise DataError(f"{path} is damaged: it has {found} bytes, {expected} were expected")


class Frame:
    """frame.json and the files it names. `folder` is the exported folder, which holds `data`."""

    def __init__(self, number: int, folder: str) -> None:
        self.number = number
        self.home = os.path.realpath(os.path.join(folder, "data"))
        self.folder = os.path.join(self.home, f"frame_{number:04d}")
        self.json_path = os.path.join(self.folder, "frame.json")
        self.data = read_json(self.json_path)
        check_format(self.data, self.json_path)

    def __getitem__(self, key: str) -> Any:
        try:
            return self.data[key]
        except KeyError:
            raise DataError(f'{self.json_path} has no "{key}"; run `wold generate` again') from None

    def light_map(self, name: str, number: int) -> dict[str, Any]:
        """The map `name`, "light" or "standing_light", of that number: 0 is the coarsest, from 1
        on they are finer and nearer to the eye. Throws DataError."""
        if number <= 0:
            return dict(self[name])
        try:
            return dict(self["light_details"][number - 1][name])
        except (IndexError, KeyError, TypeError):
            raise DataError(f"{self.json_path} is damaged: it has no {name} {number}") from None

    def path(self, name: str) -> str:
        """The absolute path of a file that frame.json names. Throws DataError for one that is
        outside the folder `data`."""
        path = os.path.realpath(os.path.join(self.folder, name))
        if not path.startswith(self.home + os.sep):
            raise DataError(f"{self.json_path} names {name}, which is outside {self.home}")
        return path

    def numbers(self, name: str, typecode: str, count: int) -> array.array[Any]:
        """A raw little-endian array ("f" float32, "i" int32) of `count` numbers."""
        values = array.array(typecode)
        check_size(self.path(name), count * values.itemsize)
        with open(self.path(name), "rb") as file:
            values.frombytes(file.read())
        if sys.byteorder == "big":
            values.byteswap()
        return values


def light_map_of(entry: dict[str, Any]) -> int:
    """The number of the map of the light on a frame's volume or blades; older frames have one."""
    return int(entry.get("light_map", 0))


class Moment(NamedTuple):
    """When a frame is: its weathering degree in [0, 1] and its time in seconds."""

    degree: float
    time_s: float
    number: int


def moment(path: str, number: int) -> Moment:
    frame = read_json(path)
    check_format(frame, path)
    try:
        return Moment(float(frame["weathering"]), float(frame["time_s"]), number)
    except (KeyError, TypeError, ValueError) as error:
        raise DataError(f"cannot read {path}: {error}; run `wold generate` again") from error


def moments(folder: str) -> list[Moment]:
    """Every frame of an exported folder, by number."""
    data = os.path.join(folder, "data")
    found = []
    for name in sorted(os.listdir(data)) if os.path.isdir(data) else ():
        number = re.fullmatch(r"frame_(\d+)", name)
        path = os.path.join(data, name, "frame.json")
        if number and os.path.isfile(path):
            found.append(moment(path, int(number.group(1))))
    if not found:
        raise DataError(
            f'{data} has no frames: choose the folder "blender" that `wold generate` has written'
        )
    return sorted(found, key=lambda each: each.number)


def nearest_in_degree(frames: list[Moment], degree: float, time_s: float) -> int:
    """The number of the frame nearest in degree, of equally near ones that nearest in time."""
    return min(frames, key=lambda m: (abs(m.degree - degree), abs(m.time_s - time_s))).number


def nearest_in_number(frames: list[Moment], number: int) -> int:
    """The number of the frame nearest in number, of equally near ones the earlier."""
    return min(frames, key=lambda m: (abs(m.number - number), m.number)).number
