"""Tries the faults of tests/mutants/*.toml in a copy; see tests/mutants.sh, which makes it."""

import argparse
import dataclasses
import re
import subprocess
import sys
import time
from pathlib import Path

import tomllib

LEAST_CAUGHT = 0.95
MOST_SECONDS = 900  # for one program's tests, which take a tenth of it without a fault
HERE = Path(__file__).resolve().parent
NO_END = f"no end after {MOST_SECONDS} s"
FAULT_KEYS = {"name", "file", "find", "replace", "breaks"}


@dataclasses.dataclass(frozen=True)
class Mutant:
    """A fault: `find`, which is once in `file`, is replaced.

    `programs` are the test programs that may see it, the likeliest first. They are built and run
    one after the other until one has seen it. `tests` is a filter of GoogleTest for them.
    """

    room: str
    name: str
    file: str
    find: str
    replace: str
    breaks: str
    tests: str
    programs: tuple[str, ...]

    @property
    def full_name(self):
        return f"{self.room}.{self.name}"


def read_room(path):
    table = tomllib.loads(path.read_text())
    room_tests = table.get("tests", "*")
    programs = tuple(table.get("programs", [path.stem]))
    mutants = []
    for fault in table["mutant"]:
        wrong = FAULT_KEYS - fault.keys() or fault.keys() - FAULT_KEYS - {"tests"}
        if wrong:
            sys.exit(f"error: {path}: {fault.get('name')}: missing or unknown {sorted(wrong)}")
        mutants.append(Mutant(room=path.stem, programs=programs, **{"tests": room_tests, **fault}))
    return mutants


def read_mutants():
    mutants = [mutant for path in sorted(HERE.glob("*.toml")) for mutant in read_room(path)]
    names = [mutant.full_name for mutant in mutants]
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        sys.exit(f"error: faults with the same name: {', '.join(twice)}")
    return mutants


def chosen(mutants, wanted):
    """Those of these rooms and names, all without any."""
    known = {name for mutant in mutants for name in (mutant.room, mutant.full_name)}
    unknown = [name for name in wanted if name not in known]
    if unknown:
        rooms = ", ".join(sorted({mutant.room for mutant in mutants}))
        sys.exit(
            f"error: no room or fault is called {', '.join(unknown)}; there are the rooms {rooms}, "
            "and tests/mutants.sh --list has the faults"
        )
    return [m for m in mutants if not wanted or m.room in wanted or m.full_name in wanted]


class Copy:
    """A tree that faults are put into, and its build."""

    def __init__(self, folder, jobs):
        self.tree = folder / "tree"
        self.build_folder = folder / "build"
        self.jobs = jobs

    def build(self, programs):
        targets = [f"test_{program}" for program in sorted(programs)]
        command = ["ninja", "-C", self.build_folder, f"-j{self.jobs}", *targets]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        return done.returncode == 0, done.stdout

    def test(self, program, tests):
        """The first test that fails, NO_END when they do not end, "" when none fails."""
        command = [
            self.build_folder / f"test_{program}",
            f"--gtest_filter={tests}",
            "--gtest_fail_fast",
            "--gtest_brief=1",
        ]
        try:
            done = subprocess.run(
                command,
                cwd=self.build_folder / "tests",
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                timeout=MOST_SECONDS,
            )
        except subprocess.TimeoutExpired:
            return NO_END
        if done.returncode == 0:
            return ""
        failed = re.search(r"\[  FAILED  \] ([^\s,]+)", done.stdout.decode(errors="replace"))
        return failed.group(1) if failed else f"exit status {done.returncode}"


def find_place(tree, mutant):
    """The text of its file, and what is wrong with its place there: "" when it is there once."""
    path = tree / mutant.file
    text = path.read_text() if path.exists() else ""
    count = text.count(mutant.find)
    return text, "" if count == 1 else f"its text is {count} times in {mutant.file}, expected once"


def check_places(tree, mutants):
    """Whether each has its place in the code: says which have not."""
    wrong = [(mutant, why) for mutant in mutants if (why := find_place(tree, mutant)[1])]
    for mutant, why in wrong:
        print(f"error: tests/mutants/{mutant.room}.toml: {mutant.name}: {why}", file=sys.stderr)
    return not wrong


@dataclasses.dataclass(frozen=True)
class Outcome:
    """What became of a fault: `why` is the test that caught it, or what nobody saw."""

    mutant: Mutant
    state: str
    why: str
    program: str = ""


def try_mutant(copy, mutant):
    """Puts it in, builds and tests."""
    path = copy.tree / mutant.file
    text, wrong = find_place(copy.tree, mutant)
    if wrong:
        return Outcome(mutant, "not found", wrong)
    path.write_text(text.replace(mutant.find, mutant.replace))
    try:
        for program in mutant.programs:
            built, log = copy.build([program])
            if not built:
                errors = [line for line in log.splitlines() if "error" in line]
                return Outcome(mutant, "did not build", errors[0] if errors else log[-200:])
            by = copy.test(program, mutant.tests)
            if by:
                return Outcome(mutant, "caught", by, program)
    finally:
        path.write_text(text)
    return Outcome(mutant, "survived", mutant.breaks)


def catching_tests(outcomes):
    """By program a filter of all tests that caught a fault, one by one or all of a fault's."""
    filters = {}
    for outcome in outcomes:
        if outcome.state == "caught":
            one = outcome.mutant.tests if outcome.why == NO_END else outcome.why
            filters.setdefault(outcome.program, set()).add(one)
    return filters


def require_passing(copy, outcomes):
    """Tests that caught a fault have to pass without any."""
    filters = catching_tests(outcomes)
    built, log = copy.build(filters)
    if not built:
        sys.exit(f"error: the copy does not build without a fault:\n{log[-4000:]}")
    for program, tests in sorted(filters.items()):
        if failed := copy.test(program, ":".join(sorted(tests))):
            sys.exit(f"error: tests of {program} fail without a fault: {failed}")


def print_row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |", flush=True)


def print_sums(outcomes):
    """By room and of all; whether enough were caught and all could be tried."""
    states = [(outcome.mutant.room, outcome.state) for outcome in outcomes]
    kinds = ["caught", "survived", "did not build", "not found"]
    print()
    print_row("room", *kinds)
    print_row(*["---"] * (len(kinds) + 1))
    rooms = sorted({room for room, _ in states})
    for room in rooms:
        of_room = [state for its_room, state in states if its_room == room]
        print_row(room, *[of_room.count(kind) for kind in kinds])
    all_states = [state for _, state in states]
    print_row("all", *[all_states.count(kind) for kind in kinds])
    tried = all_states.count("caught") + all_states.count("survived")
    share = all_states.count("caught") / tried if tried else 0.0
    print(
        f"\n{100 * share:.1f} % of {tried} caught; at least {100 * LEAST_CAUGHT:.0f} % are wanted"
    )
    return share >= LEAST_CAUGHT and tried == len(states)


def try_all(copy, mutants):
    print_row("fault", "what became of it", "by, or what nobody saw", "seconds")
    print_row(*["---"] * 4)
    outcomes = []
    # Those of a file together: it is compiled once for each, and once more at the end.
    for mutant in sorted(mutants, key=lambda one: (one.room, one.file)):
        begin = time.monotonic()
        outcome = try_mutant(copy, mutant)
        print_row(mutant.full_name, outcome.state, outcome.why, round(time.monotonic() - begin))
        outcomes.append(outcome)
    require_passing(copy, outcomes)
    return print_sums(outcomes)


def main():
    parser = argparse.ArgumentParser(prog="tests/mutants.sh")
    parser.add_argument("--copy", type=Path, help=argparse.SUPPRESS)
    parser.add_argument("--jobs", type=int, default=2, help=argparse.SUPPRESS)
    parser.add_argument("--list", action="store_true", help="only say what there is")
    parser.add_argument("--places", action="store_true", help="only look for the faults' places")
    parser.add_argument("--every", type=int, default=1, metavar="K", help="try one of each K only")
    parser.add_argument("wanted", nargs="*", metavar="ROOM|ROOM.NAME")
    arguments = parser.parse_args()
    mutants = chosen(read_mutants(), arguments.wanted)[:: arguments.every]
    if arguments.list:
        for mutant in mutants:
            print(f"{mutant.full_name}: {mutant.breaks}")
        return 0
    if arguments.places:
        return 0 if check_places(HERE.parent.parent, mutants) else 1
    return 0 if try_all(Copy(arguments.copy, arguments.jobs), mutants) else 1


if __name__ == "__main__":
    sys.exit(main())
