#!/usr/bin/env python3
"""Makes pictures of which everything is known, for training or testing other programs: each frame
with its passes (docs/passes.md), and a table of the parameters behind it.

    data_set.py moor.toml --out set --worlds 10 --frames 10 --range sun.elevation 8 60

A world is a landscape of its own: `seed`, and a value within each --range, are drawn for it by
chance. Its frames have weathering degrees drawn by chance. DIR/frames.csv has a row a frame: world,
frame, picture, passes, and the parameters as wold has taken them. The same command makes the same
set, and goes on where it was stopped. Options that are not listed below go to `wold render`, such
as --size.
"""

from __future__ import annotations

import argparse
import csv
import io
import pathlib
import random
import sys
from typing import Any

from wold_program import Wold, add_wold_option, write_whole

Row = dict[str, object]


def parse_arguments() -> tuple[argparse.Namespace, list[str]]:
    """This program's own arguments, and those for `wold`."""
    parser = argparse.ArgumentParser(
        description=__doc__,
        allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("scene", help="the scene file")
    parser.add_argument("--out", type=pathlib.Path, required=True, metavar="DIR")
    parser.add_argument("--worlds", type=int, default=10, metavar="N", help="landscapes; 10")
    parser.add_argument("--frames", type=int, default=10, metavar="N", help="of each; 10")
    parser.add_argument("--seed", type=int, default=1, metavar="N", help="another draws others; 1")
    parser.add_argument("--passes", default="all", metavar="LIST", help="all without it")
    parser.add_argument(
        "--range",
        action="append",
        nargs=3,
        default=[],
        metavar=("KEY", "FROM", "TO"),
        help="a key of one number that is drawn for each world; may be repeated",
    )
    add_wold_option(parser)
    parser.set_defaults(limits={})
    arguments, options = parser.parse_known_args()
    if min(arguments.worlds, arguments.frames) < 1:
        parser.error("found no worlds or no frames, expected 1 or more of each")
    for key, *limits in arguments.range:
        try:
            arguments.limits[key] = [float(limit) for limit in limits]
        except ValueError:
            parser.error(f"--range {key}: found {' '.join(limits)}, expected two numbers")
    return arguments, options


def drawn(arguments: argparse.Namespace, world: int) -> list[str]:
    """What a world sets: the same in every run, whatever other worlds and keys there are."""

    def chance(key: str) -> random.Random:
        return random.Random(f"{arguments.seed} {world} {key}")

    degrees = chance("ageing.frames")
    weathering = [round(degrees.uniform(0.0, 1.0), 3) for _ in range(arguments.frames)]
    changes = [f"seed={chance('seed').randrange(2**31)}", f"ageing.frames={weathering}"]
    for key, limits in arguments.limits.items():
        changes.append(f"{key}={round(chance(key).uniform(*limits), 4)}")
    return [f"--set={change}" for change in changes]


def value_of(scene: dict[str, Any], key: str) -> object:
    table, _, name = key.rpartition(".")
    return scene[table][name] if table else scene[name]


def rows_of(wold: Wold, arguments: argparse.Namespace, options: list[str], world: int) -> list[Row]:
    """Makes the frames of a world, and says what they show."""
    folder = arguments.out / f"world_{world:03}"
    scene_with = [arguments.scene, *options, *drawn(arguments, world)]
    kept = ["--passes", arguments.passes, "--keep", "scenes", "--out", folder]
    made = wold.json("render", *scene_with, *kept, "--json", "--quiet")
    scene = wold.json("check", folder / "scene.toml", "--json")["scene"]
    parameters = {key: value_of(scene, key) for key in ["seed", *arguments.limits]}
    rows: list[Row] = []
    for frame in made["frames"]:
        number = frame["frame"]
        row: Row = {"world": world, "frame": number}
        for name, file in {**frame["pictures"], "passes": frame["passes"]}.items():
            row[name] = pathlib.Path(file).relative_to(arguments.out).as_posix()
        row["weathering"] = scene["ageing"]["frames"][number - 1]
        rows.append(row | parameters)
    return rows


def table_of(rows: list[Row]) -> str:
    text = io.StringIO()
    writer = csv.DictWriter(text, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def main() -> None:
    arguments, options = parse_arguments()
    wold = Wold(arguments.wold)
    # Whatever is wrong is said before anything is made.
    wold.run("check", arguments.scene, *drawn(arguments, 1))
    rows: list[Row] = []
    for world in range(1, arguments.worlds + 1):
        print(f"world {world} of {arguments.worlds}", file=sys.stderr)
        rows += rows_of(wold, arguments, options, world)
    table = arguments.out / "frames.csv"
    write_whole(table, table_of(rows))
    print(table)


if __name__ == "__main__":
    main()
