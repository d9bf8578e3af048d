"""Writes the page of pictures: each of examples/pictures, below it the command that makes its
frames, both from the lines of examples/pictures/make.sh.

    python3 docs/site/gallery.py >gallery.md          run in docs/ of the site's source
"""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PICTURES = ROOT / "examples/pictures"
MADE = re.compile(r"^make (\w+) (\w+) (\d+x\d+) (beside|above) ([\d ]+)$", re.MULTILINE)
MADE_OF_PLACE = re.compile(
    r'^make (\w+) "\$\(scene_of (\w+) "\$here/(\S+)"\)" (\d+x\d+) (beside|above) ([\d ]+)$', re.MULTILINE
)


def title_of(scene: str) -> str:
    """A scene begins with a comment, whose first clause says what it shows."""
    text = (ROOT / f"examples/{scene}.toml").read_text(encoding="utf-8")
    comment = re.match(r"(# .*\n)+", text)
    assert comment, f"examples/{scene}.toml does not begin with a comment"
    return re.split(r"[:.,]", " ".join(comment.group().split("\n# ")).removeprefix("# "))[0].strip()


def entry(name: str, title: str, commands: list[str], arrangement: str) -> str:
    places = "on the left" if arrangement == "beside" else "above"
    return (
        f"## {name.capitalize()}\n\n{title}. Blender {places}.\n\n"
        f"![{title}](../examples/pictures/{name}.jpg)\n\n"
        + "".join(f"    {command}\n" for command in commands)
    )


def render(scene: str, size: str, frames: str) -> str:
    return f"wold render {scene} --frames {','.join(frames.split())} --size {size} --renderer both"


def entry_of_example(name: str, scene: str, size: str, arrangement: str, frames: str) -> str:
    return entry(name, title_of(scene), [render(f"examples/{scene}.toml", size, frames)], arrangement)


def entry_of_place(name: str, scene: str, model: str, size: str, arrangement: str, frames: str) -> str:
    commands = [f"wold new {scene} --terrain {model}", render(f"{scene}.toml", size, frames)]
    return entry(name, "What wold new writes for a real place", commands, arrangement)


def main() -> None:
    makes = (PICTURES / "make.sh").read_text(encoding="utf-8")
    entries = {made[0]: entry_of_example(*made) for made in MADE.findall(makes)}
    entries |= {made[0]: entry_of_place(*made) for made in MADE_OF_PLACE.findall(makes)}
    without = {picture.stem for picture in PICTURES.glob("*.jpg")} - entries.keys()
    if without:
        raise SystemExit(f"error: examples/pictures/make.sh does not make {', '.join(without)}")
    print("# Gallery\n\nWhat the examples show. Each command makes the frames again.\n")
    print("\n".join(entries.values()))


if __name__ == "__main__":
    main()
