#!/usr/bin/env python3
"""Renders a frame of a scene for every combination of some keys' values, and lays the pictures out
on one sheet:

    sweep.py moor.toml --vary sun.elevation 8 20 45 --vary sky.turbidity 2 4 --out sweep

DIR/sheet.html has all pictures in it, with what differs below each. Run the same command again to
go on where it was stopped. Options that are not listed below go to `wold render`, such as --size
and --set.
"""

from __future__ import annotations

import argparse
import base64
import html
import itertools
import pathlib
import sys
from collections.abc import Iterator

from wold_program import Wold, add_wold_option, write_whole

PAGE = """<!doctype html>
<html lang="en"><meta charset="utf-8"><title>{title}</title>
<style>
body {{ font: 15px sans-serif; margin: 24px; background: #f6f6f4; color: #222 }}
main {{ display: grid; gap: 16px; grid-template-columns: repeat({columns}, minmax(160px, 1fr)) }}
figure {{ margin: 0 }} img {{ width: 100% }} figcaption {{ font-family: monospace }}
</style>
<h1>{title}</h1>
<main>
{figures}
</main></html>
"""


def parse_arguments() -> tuple[argparse.Namespace, list[str]]:
    """This program's own arguments, and those for `wold`."""
    parser = argparse.ArgumentParser(
        description=__doc__,
        allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("scene", help="the scene file")
    parser.add_argument(
        "--vary",
        action="append",
        nargs="+",
        required=True,
        metavar=("KEY", "VALUE"),
        help="a key and its values; may be repeated",
    )
    parser.add_argument("--out", type=pathlib.Path, required=True, metavar="DIR")
    parser.add_argument("--frame", type=int, default=1, metavar="N", help="which one of the scene")
    add_wold_option(parser)
    return parser.parse_known_args()


def combinations(varied: list[list[str]]) -> Iterator[list[str]]:
    """All of them as key=value, the last key's values changing first."""
    values = [[f"{key}={value}" for value in values] for key, *values in varied]
    return (list(settings) for settings in itertools.product(*values))


def figure(picture: pathlib.Path, settings: list[str]) -> str:
    data = base64.b64encode(picture.read_bytes()).decode("ascii")
    caption = "<br>".join(html.escape(setting) for setting in settings)
    return (
        f'<figure><img alt="{html.escape(", ".join(settings))}" '
        f'src="data:image/png;base64,{data}"><figcaption>{caption}</figcaption></figure>'
    )


def main() -> None:
    arguments, options = parse_arguments()
    if any(len(varied) < 2 for varied in arguments.vary):
        sys.exit("error: --vary: found a key alone, expected KEY VALUE...")
    wold = Wold(arguments.wold)
    chosen = [[f"--set={setting}" for setting in one] for one in combinations(arguments.vary)]
    for changes in chosen:  # whatever is wrong is said before anything is made
        wold.run("check", arguments.scene, *changes)
    figures = []
    for number, changes in enumerate(chosen, 1):
        settings = [change.removeprefix("--set=") for change in changes]
        print(f"{number} of {len(chosen)}: {', '.join(settings)}", file=sys.stderr)
        folder = arguments.out / f"{number:03}"
        frame = ["--frames", str(arguments.frame), "--out", folder, "--json", "--quiet"]
        made = wold.json("render", arguments.scene, *options, *changes, *frame)
        for picture in made["frames"][0]["pictures"].values():
            figures.append(figure(pathlib.Path(picture), settings))
    sheet = arguments.out / "sheet.html"
    columns = len(arguments.vary[-1]) - 1
    title = html.escape(f"{pathlib.Path(arguments.scene).stem}, frame {arguments.frame}")
    write_whole(sheet, PAGE.format(title=title, columns=columns, figures="\n".join(figures)))
    print(sheet)


if __name__ == "__main__":
    main()
