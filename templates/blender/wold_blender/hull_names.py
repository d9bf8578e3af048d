"""Names of volumes for which Cycles leaves their hulls where they are."""

from __future__ import annotations

import itertools


def hash_share(name: str) -> float:
    """A number in [0, 1]: Jenkins' hash, the final mix of lookup3.

    Until Blender 5.1 Cycles moves a volume's hull, to keep hulls of different volumes apart. The
    hull is moved by a tenth of a metre times this number, divided by the count of active voxels
    along a side."""
    bits = 0xFFFFFFFF

    def turned(word: int, by: int) -> int:
        return (word << by | word >> (32 - by)) & bits

    word = 0
    for letter in name.encode():
        word = (37 * word + letter) & bits
    words = [(0xDEADBF00 + word) & bits, 0xDEADBF00, 0xDEADBF00]
    into = 2
    for by in (14, 11, 25, 16, 4, 14, 24):
        source = words[(into + 2) % 3]
        words[into] = ((words[into] ^ source) - turned(source, by)) & bits
        into = (into + 1) % 3
    return words[2] / bits


def name_of_volume(number: int) -> str:
    """Names in the order of the numbers, by which no hull is moved by more than a hundredth of what
    it may: quarters of a volume have to meet. Later versions take any name."""
    attempts = (f"{number:05d} {attempt}" for attempt in itertools.count())
    return next(name for name in attempts if hash_share(name) < 0.01)
