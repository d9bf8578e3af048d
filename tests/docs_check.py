"""Whether the docs say what is there: links, files, commands, options, keys, citations, versions.

    python3 tests/docs_check.py WOLD

Prints what is wrong, a line each; exit code 1 when there is something.
"""

import re
import subprocess
import sys
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LONGEST_README = 150
PAGES = sorted(
    [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "gen").glob("*/README.md")]
    + [ROOT / "examples/guide.md"]
)
CITATION = re.compile(r"\[((?:[A-Z][a-z]+(?:19|20|18)\d\d)|TVT)\](?!\()")


def read(path: Path) -> str:
    return path.read_text(encoding="utf-8")


def without_code(text: str) -> str:
    return re.sub(r"^    .*$|`[^`\n]*`", "", text, flags=re.MULTILINE)


def code_of(text: str) -> list[str]:
    """Lines of code: what stands in backticks, and indented lines."""
    return re.findall(r"`([^`\n]+)`", text) + re.findall(r"^    (.*)$", text, flags=re.MULTILINE)


def anchors(text: str) -> set[str]:
    headings = re.findall(r"^#+ (.*)$", text, flags=re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def bad_links(page: Path, text: str) -> list[str]:
    bad = []
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(text)):
        if "://" in target:
            continue
        name, _, anchor = target.partition("#")
        path = page.parent / name if name else page
        if not path.exists() or (anchor and anchor not in anchors(read(path))):
            bad.append(f"no such link: {target}")
    return bad


def bad_paths(text: str) -> list[str]:
    """Paths from the root that name nothing."""
    folders = "gen|tests|docs|examples|templates|models"
    paths = re.findall(rf"(?<![\w/.<])((?:{folders})/[\w./*-]*[\w/*])", "\n".join(code_of(text)))
    return [
        f"no such file: {path}"
        for path in paths
        if not any(ROOT.glob(path.rstrip("/"))) and "NAME" not in path
    ]


def bad_headers(page: Path, text: str) -> list[str]:
    """Headers in a room's README that neither the room nor another one has."""
    if page.parent.parent != ROOT / "gen":
        return []
    return [
        f"no such header: {name}"
        for name in re.findall(r"`([\w/]+\.h)`", text)
        if not any(page.parent.rglob(name)) and not (ROOT / "gen" / name).exists()
    ]


@cache
def help_of(wold: str, command: str) -> str:
    words = [wold, command, "--help"] if command else [wold, "--help"]
    return subprocess.run(words, capture_output=True, text=True, check=True).stdout


@cache
def commands_of(wold: str) -> frozenset[str]:
    listed = help_of(wold, "").partition("Subcommands:")[2]
    return frozenset(re.findall(r"^  (\w+) ", listed, flags=re.MULTILINE))


def bad_commands(wold: str, text: str) -> list[str]:
    """Commands, and options on their lines, that the program does not have."""
    bad = []
    for line in code_of(text):
        for command, rest in re.findall(r"(?:^|\bbuild/|\| )wold ([a-z]+)\b([^#|]*)", line):
            if command not in commands_of(wold):
                bad.append(f"no such command: wold {command}")
                continue
            for option in re.findall(r"(?<!\S)(--[a-z-]+)", rest):
                if option not in help_of(wold, command):
                    bad.append(f"no such option: wold {command} {option}")
    return bad


@cache
def known_keys() -> frozenset[str]:
    return frozenset(re.findall(r"^\| `([\w.]+)` \|", read(ROOT / "docs/keys.md"), re.MULTILINE))


@cache
def old_keys() -> frozenset[str]:
    """Names that keys had, which the scene file still accepts."""
    return frozenset(re.findall(r'OldName\{"([\w.]+)"', read(ROOT / "gen/scene/old_names.cpp")))


def bad_keys(path: Path, text: str) -> list[str]:
    tables = "|".join(sorted({key.split(".")[0] for key in known_keys() if "." in key}))
    used = re.findall(rf"(?<![\w/.-])((?:{tables})\.[a-z_]+)\b(?![/(.])", "\n".join(code_of(text)))
    files = ("toml", "h", "cpp", "md", "pov", "inc", "asc", "csv", "ini", "mp4", "png", "svg")
    return [
        f"no such key: {key}"
        for key in used
        if key not in known_keys()
        and key.split(".")[1] not in files
        and not (path.name == "CHANGELOG.md" and key in old_keys())
    ]


def bad_citations() -> list[str]:
    """Keys that are used and not defined, and sources that are not where they are said to be."""
    references = read(ROOT / "docs/REFERENCES.md")
    entries = re.findall(
        r"^- \*\*\[(\w+)\]\*\* (.*?)(?=^- |^#|\Z)", references, flags=re.MULTILINE | re.DOTALL
    )
    defined = {key for key, _ in entries}
    bad = []
    for file in [*PAGES, *(ROOT / "gen").rglob("*.h"), *(ROOT / "gen").rglob("*.cpp")]:
        bad += [
            f"{file.relative_to(ROOT)}: {key} is not in docs/REFERENCES.md"
            for key in CITATION.findall(read(file))
            if key not in defined
        ]
    for key, entry in entries:
        name = re.sub(r"\d", "", key)
        for path in re.findall(r"`((?:gen|models|tests)/[^`*]*\.\w+)`", entry):
            if (ROOT / path).is_file() and name not in read(ROOT / path):
                bad.append(f"docs/REFERENCES.md: {path} does not name {name}")
    return bad


def bad_rooms() -> list[str]:
    rooms = [folder for folder in (ROOT / "gen").iterdir() if folder.is_dir()]
    return [f"{room.relative_to(ROOT)}: no README.md" for room in rooms if not has_readme(room)]


def has_readme(room: Path) -> bool:
    return (room / "README.md").is_file()


def bad_versions(wold: str) -> list[str]:
    """Places that do not have the version of the top CMakeLists.txt."""
    project = re.search(r"project\(wold VERSION (\S+)", read(ROOT / "CMakeLists.txt"))
    wanted = project.group(1) if project else "none"
    add_on = ROOT / "templates/blender/wold_blender"
    found = {
        "wold --version": subprocess.run(
            [wold, "--version"], capture_output=True, text=True, check=True
        )
        .stdout.splitlines()[0]
        .removeprefix("wold "),
        "blender_manifest.toml": "".join(
            re.findall(r'^version = "(.*)"$', read(add_on / "blender_manifest.toml"), re.MULTILINE)
        ),
        "bl_info": ".".join(
            re.findall(r'"version": \((\d+), (\d+), (\d+)\)', read(add_on / "__init__.py"))[0]
        ),
        "CITATION.cff": "".join(
            re.findall(r"^version: (\S+)$", read(ROOT / "CITATION.cff"), re.MULTILINE)
        ),
        "CHANGELOG.md": "".join(
            re.findall(r"^## (\S+), ", read(ROOT / "CHANGELOG.md"), re.MULTILINE)[:1]
        ),
    }
    return [
        f"version of {place}: found {version}, expected {wanted}"
        for place, version in found.items()
        if version != wanted
    ]


def faults(wold: str) -> list[str]:
    bad = bad_citations() + bad_rooms() + bad_versions(wold)
    for page in PAGES:
        text = read(page)
        found = bad_links(page, text) + bad_paths(text) + bad_commands(wold, text)
        found += bad_keys(page, text) + bad_headers(page, text)
        bad += [f"{page.relative_to(ROOT)}: {fault}" for fault in found]
    lines = read(ROOT / "README.md").count("\n")
    if lines > LONGEST_README:
        bad.append(f"README.md: found {lines} lines, expected {LONGEST_README} at most")
    return bad


def main() -> int:
    found = faults(sys.argv[1])
    print("\n".join(found) if found else f"{len(PAGES)} pages: nothing wrong")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
