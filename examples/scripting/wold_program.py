"""Runs `wold` for the examples in this folder: what it says on stderr goes on to the user, and when
it fails the script ends with its exit code."""

from __future__ import annotations

import argparse
import json
import os
import pathlib
import shutil
import subprocess
import sys
from typing import Any

here = pathlib.Path(__file__).resolve().parent


def find_wold() -> str | None:
    beside = [here / "../../build/wold", here / "../../../../bin/wold"]  # built, installed
    return next(
        (str(program.resolve()) for program in beside if program.exists()), shutil.which("wold")
    )


def add_wold_option(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--wold",
        default=find_wold(),
        metavar="PROGRAM",
        help="wold; the one that was built or installed beside this script, or the PATH's",
    )


class Wold:
    """A program that speaks version 1 of what docs/scripting.md says."""

    def __init__(self, program: str | None) -> None:
        if not program:
            sys.exit(
                "error: wold is neither beside this script nor on the PATH; expected it there, or"
                " --wold PROGRAM"
            )
        self.program = program

    def run(self, *arguments: str | pathlib.Path, allowed: tuple[int, ...] = (0,)) -> str:
        """What a command prints. Ends this script when the exit code is not one of `allowed`."""
        try:
            result = subprocess.run(
                [self.program, *map(str, arguments)], stdout=subprocess.PIPE, text=True
            )
        except OSError as error:
            sys.exit(f"error: cannot run {self.program}: {error.strerror}")
        except KeyboardInterrupt:
            sys.exit(130)
        if result.returncode not in allowed:
            sys.exit(result.returncode)
        return result.stdout

    def json(self, *arguments: str | pathlib.Path, allowed: tuple[int, ...] = (0,)) -> Any:
        answer = json.loads(self.run(*arguments, allowed=allowed))
        if answer["version"] != 1:
            sys.exit(f"error: {self.program} answers in version {answer['version']}, expected 1")
        return answer


def write_whole(path: pathlib.Path, text: str) -> None:
    """Writes a file under another name first, so that it is whole or not there."""
    path.parent.mkdir(parents=True, exist_ok=True)
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        # As it is: the lines of a CSV have ends of their own.
        unfinished.write_text(text, encoding="utf-8", newline="")
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
