#!/usr/bin/env python3
"""Holds pictures of scenes against those that somebody has found right, for continuous integration:

    golden.py shots/*.toml --golden golden --frames 1 --size 480x270
    golden.py shots/*.toml --golden golden --frames 1 --size 480x270 --update

The first compares with golden/<scene>/<renderer>/0001.png and ends with 1 when a picture differs or
has no golden one; DIR/differences has pages that show how. --junit writes the result in the form
that CI servers read. The second replaces the golden pictures by those of now. When wold fails, its
exit code is this program's. Options that are not listed below go to `wold render`.
"""

from __future__ import annotations

import argparse
import os
import pathlib
import shutil
import sys
import xml.etree.ElementTree as xml
from typing import NamedTuple

from wold_program import Wold, add_wold_option, write_whole


class Picture(NamedTuple):
    """One that has been made, and the golden one that it should equal."""

    name: str
    got: pathlib.Path
    want: pathlib.Path


def parse_arguments() -> tuple[argparse.Namespace, list[str]]:
    """This program's own arguments, and those for `wold`."""
    parser = argparse.ArgumentParser(
        description=__doc__,
        allow_abbrev=False,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("scenes", nargs="+", type=pathlib.Path, help="the scene files")
    parser.add_argument("--golden", type=pathlib.Path, required=True, metavar="DIR")
    parser.add_argument(
        "--out",
        type=pathlib.Path,
        default=pathlib.Path("out/golden"),
        metavar="DIR",
        help="where pictures are made; out/golden without it",
    )
    parser.add_argument("--update", action="store_true", help="replace the golden pictures")
    parser.add_argument("--junit", type=pathlib.Path, metavar="FILE.xml")
    add_wold_option(parser)
    return parser.parse_known_args()


def rendered(
    wold: Wold, scene: pathlib.Path, options: list[str], arguments: argparse.Namespace
) -> list[Picture]:
    """Makes a scene's pictures; those that are there and right are kept."""
    folder = arguments.out / scene.stem
    made = wold.json("render", scene, *options, "--out", folder, "--json", "--quiet")
    pictures = []
    for frame in made["frames"]:
        for renderer, picture in frame["pictures"].items():
            name = f"{scene.stem}/{renderer}/{frame['frame']:04}"
            want = arguments.golden / f"{name}.png"
            pictures.append(Picture(name, pathlib.Path(picture), want))
    return pictures


def fault(wold: Wold, picture: Picture, report: pathlib.Path) -> str:
    """How a picture differs; empty when it does not."""
    if not picture.want.exists():
        return f"{picture.want} is missing; --update makes it"
    verdict = wold.json("compare", picture.got, picture.want, "--report", report, allowed=(0, 1))
    return "; ".join(verdict["reasons"])


def write_junit(path: pathlib.Path, faults: dict[str, str]) -> None:
    failed = sum(map(bool, faults.values()))
    suite = xml.Element("testsuite", name="wold", tests=str(len(faults)), failures=str(failed))
    for name, text in faults.items():
        case = xml.SubElement(suite, "testcase", classname="golden", name=name)
        if text:
            xml.SubElement(case, "failure", message=text)
    write_whole(path, xml.tostring(suite, encoding="unicode") + "\n")


def replace(picture: Picture) -> None:
    picture.want.parent.mkdir(parents=True, exist_ok=True)
    unfinished = picture.want.with_name(f".{picture.want.name}.{os.getpid()}")
    shutil.copyfile(picture.got, unfinished)
    unfinished.replace(picture.want)


def main() -> None:
    arguments, options = parse_arguments()
    stems = [scene.stem for scene in arguments.scenes]
    if len(set(stems)) < len(stems):
        sys.exit("error: found scenes of one name, expected a name of its own for each")
    wold = Wold(arguments.wold)
    pictures = [
        picture
        for scene in arguments.scenes
        for picture in rendered(wold, scene, options, arguments)
    ]
    if arguments.update:
        for picture in pictures:
            replace(picture)
            print(picture.want)
        return
    differences = arguments.out / "differences"
    faults = {
        picture.name: fault(wold, picture, differences / picture.name) for picture in pictures
    }
    for name, text in faults.items():
        print(f"{name}: {text or 'same'}")
    if arguments.junit:
        write_junit(arguments.junit, faults)
    sys.exit(any(faults.values()))


if __name__ == "__main__":
    main()
