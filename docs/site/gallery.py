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


def title_of(scene: str) -> str:
    """A scene begins with a comment, whose first clause says what it shows."""
    text = (ROOT / f"examples/{scene}.toml").read_text(encoding="utf-8")
    comment = re.match(r"(# .*\n)+", text)
    assert comment, f"examples/{scene}.toml does not begin with a comment"
    return re.split(r"[:.,]", " ".join(comment.group().split("\n# ")).removeprefix("# "))[0].strip()


def entry(name: str, scene: str, size: str, arrangement: str, frames: str) -> str:
    places = "on the left" if arrangement == "beside" else "above"
    command = f"wold render examples/{scene}.toml --frames {','.join(frames.split())} --size {size} --renderer both"
    return (
        f"## {name.capitalize()}\n\n{title_of(scene)}. Blender {places}.\n\n"
        f"![{title_of(scene)}](../examples/pictures/{name}.jpg)\n\n    {command}\n"
    )


def main() -> None:
    made = MADE.findall((PICTURES / "make.sh").read_text(encoding="utf-8"))
    without = {picture.stem for picture in PICTURES.glob("*.jpg")} - {name for name, *_ in made}
    if without:
        raise SystemExit(f"error: examples/pictures/make.sh does not make {', '.join(without)}")
    print("# Gallery\n\nWhat the examples show. Each command makes the frames again.\n")
    print("\n".join(entry(*one) for one in made))


if __name__ == "__main__":
    main()
