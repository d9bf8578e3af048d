#!/usr/bin/env python3
"""Whether every include of gen/ agrees with the table of libraries in gen/CMakeLists.txt.

    tests/layers.py [GEN]

A library may include itself, what its line of the table names, and what that hands on PUBLIC. A
header may include only what its own library hands on PUBLIC. The arrows of the table make no
circle, and there is none that no include needs, but for those to core, which every library has.
No function of physics takes the whole scene: it takes a part (scene/parts.h).
Prints each line that breaks a rule; the exit status is 1 when there is one.
"""

import pathlib
import re
import sys
from dataclasses import dataclass, field

# What the libraries of others are called in the table, by how their headers' names begin. Headers
# of the language, of the system and of what every library may use (glm, fmt) are not listed.
FOREIGN = {
    "CLI/": "CLI11::CLI11",
    "OpenImageIO/": "${OPENIMAGEIO_LIBRARY}",
    "cpl_": "GDAL::GDAL",
    "gdal": "GDAL::GDAL",
    "nanovdb/": "${OPENVDB_LIBRARY}",
    "nlohmann/": "nlohmann_json::nlohmann_json",
    "ogr_": "GDAL::GDAL",
    "openvdb/": "${OPENVDB_LIBRARY}",
    "tbb/": "TBB::tbb",
    "toml++/": "tomlplusplus::tomlplusplus",
    "xxhash.h": "${XXHASH_LIBRARY}",
    "zip.h": "${ZIP_LIBRARY}",
}
# Phenomena by themselves: what they know of a scene is in their signatures.
PHYSICS = ("weather", "snowpack", "phenology", "light", "terrain", "grass", "cloud", "snow", "wind")
WHOLE_SCENE = re.compile(r"\bscene::Scene\s*&")
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]', re.MULTILINE)


@dataclass
class Library:
    """A line of the table: what a library is linked to, by the names of the targets."""

    public: list[str] = field(default_factory=list)
    private: list[str] = field(default_factory=list)


def read_table(cmake: str) -> dict[str, Library]:
    """The lines wold_library(name PUBLIC targets... PRIVATE targets...), by name.

    An exporter's line, wold_exporter(name ...), is that of a library which hands on exporter;
    ${exporters} are all of these.
    """
    table = {}
    text = re.sub(r"#.*", "", cmake)
    lines = re.findall(r"^wold_(library|exporter)\((\w+)([^)]*)\)", text, re.MULTILINE)
    exporters = " ".join(f"wold_{name}" for kind, name, _ in lines if kind == "exporter")
    for kind, name, words in lines:
        library = table[name] = Library()
        if kind == "exporter":
            library.public.append("exporter")
        words = words.replace("${exporters}", exporters)
        links = library.public
        for word in words.split():
            if word in ("PUBLIC", "PRIVATE"):
                links = library.public if word == "PUBLIC" else library.private
            else:
                links.append(word.removeprefix("wold_"))
    return table


def handed_on(table: dict[str, Library], links: list[str]) -> set[str]:
    """These targets and all that they hand on PUBLIC."""
    seen: set[str] = set()
    rest = list(links)
    while rest:
        link = rest.pop()
        if link not in seen:
            seen.add(link)
            rest += table[link].public if link in table else []
    return seen


def target_of(header: str, table: dict[str, Library]) -> str | None:
    """The target that has an included header; None where any library may include it."""
    room = header.split("/")[0]
    if "/" in header and room in table:
        return room
    return next((t for start, t in FOREIGN.items() if header.startswith(start)), None)


def circles(table: dict[str, Library]) -> list[str]:
    """Libraries that can be reached from themselves."""
    faults = []
    for name in table:
        seen: set[str] = set()
        rest = [name]
        while rest:
            library = table.get(rest.pop(), Library())
            new = set(library.public + library.private) - seen
            seen |= new
            rest += new
        if name in seen:
            faults.append(f"CMakeLists.txt: {name} is linked to itself in a circle")
    return faults


def faults_of_library(gen: pathlib.Path, name: str, table: dict[str, Library]) -> list[str]:
    """Includes of one library that the table does not allow, and arrows that none needs."""
    library = table[name]
    allowed = {
        ".h": handed_on(table, library.public),
        ".cpp": handed_on(table, library.public + library.private),
    }
    faults = []
    needed = {".h": set(), ".cpp": set()}
    for path in sorted((gen / name).rglob("*")):
        if path.suffix not in allowed or path.name == "main.cpp":
            continue
        for header in INCLUDE.findall(path.read_text()):
            target = target_of(header, table)
            if target in (None, name):
                continue
            needed[path.suffix].add(target)
            if target not in allowed[path.suffix]:
                links = "PUBLIC links" if path.suffix == ".h" else "links"
                faults.append(f'{path.relative_to(gen)}: "{header}": not in the {links} of {name}')
    return faults + superfluous(name, table, needed)


def superfluous(name: str, table: dict[str, Library], needed: dict[str, set[str]]) -> list[str]:
    """Arrows between libraries of gen/ that could be left out, or be PRIVATE."""
    library = table[name]
    faults = [
        f"CMakeLists.txt: no header of {name} includes {link}; its link need not be PUBLIC"
        for link in library.public
        if link in table and link not in needed[".h"] and link != "core"
    ]
    return faults + [
        f"CMakeLists.txt: no file of {name} includes {link}, which it is linked to"
        for link in library.private
        if link in table and link not in needed[".cpp"]
    ]


def takers_of_whole_scenes(gen: pathlib.Path) -> list[str]:
    """Lines of physics that take a whole scene."""
    return [
        f"{path.relative_to(gen)}:{number}: takes the whole scene"
        for room in PHYSICS
        for path in sorted((gen / room).rglob("*"))
        if path.suffix in (".h", ".cpp")
        for number, line in enumerate(path.read_text().splitlines(), 1)
        if WHOLE_SCENE.search(line)
    ]


def faults(gen: pathlib.Path) -> list[str]:
    """All that breaks a rule in a folder of libraries."""
    table = read_table((gen / "CMakeLists.txt").read_text())
    found = circles(table) + takers_of_whole_scenes(gen)
    for folder in sorted(path.name for path in gen.iterdir() if path.is_dir()):
        if folder not in table:
            found.append(f"{folder}: not in the table")
    for name in table:
        found += faults_of_library(gen, name, table)
    return found


def main(arguments: list[str]) -> int:
    gen = pathlib.Path(arguments[0] if arguments else pathlib.Path(__file__).parents[1] / "gen")
    found = faults(gen)
    for fault in found:
        print(f"error: {fault}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
