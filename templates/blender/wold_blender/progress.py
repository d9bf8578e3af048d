"""Tells how far a render is."""

from __future__ import annotations

import contextlib
import os
import re
import threading
from collections.abc import Iterator


def pass_on(reading: int, stdout: int) -> None:
    """Copies Blender's output and adds a progress line to every count of samples in it."""
    with os.fdopen(reading, errors="replace") as lines:
        for line in lines:
            os.write(stdout, line.encode())
            sample = re.search(r"Sample (\d+)/(\d+)", line)
            if sample:
                fraction = int(sample.group(1)) / int(sample.group(2))
                os.write(stdout, f"wold: progress {fraction:.3f}\n".encode())


@contextlib.contextmanager
def progress_reported() -> Iterator[None]:
    """Blender tells how many samples are done on its standard output only: its handlers for
    statistics are called without any."""
    stdout = os.dup(1)
    reading, writing = os.pipe()
    os.dup2(writing, 1)
    os.close(writing)
    reader = threading.Thread(target=pass_on, args=(reading, stdout))
    reader.start()
    try:
        yield
    finally:
        os.dup2(stdout, 1)  # closes the pipe, which ends the reader
        reader.join()
        os.close(stdout)
