"""Memory of the process."""

from __future__ import annotations

import ctypes
import sys

MMAP_THRESHOLD = -3  # number of the parameter in glibc's malloc.h
BLOCK_BYTES = 256 * 1024


def give_back_freed_blocks() -> None:
    """Makes glibc return large blocks to the system as soon as they are freed. By itself it keeps
    blocks of up to 32 MB once it has freed one of that size, and so half a gigabyte of the copies
    that Cycles makes of volumes. Does nothing where memory is another library's."""
    if sys.platform != "linux":
        return
    program = ctypes.CDLL(None)
    if hasattr(program, "mallopt"):
        program.mallopt(MMAP_THRESHOLD, BLOCK_BYTES)
