"""The list of what differs between versions of Blender, and when a function of it may go."""

import inspect
import re
import unittest

import stand_in
import wold_blender
from wold_blender import differences
from wold_blender.differences import DIFFERENCES, OLDEST


def named(version):
    return ".".join(map(str, version))


def functions():
    """Of differences.py, those that others may call."""
    return [
        function
        for name, function in inspect.getmembers(differences, inspect.isfunction)
        if function.__module__ == differences.__name__ and not name.startswith("_")
    ]


class Differences(unittest.TestCase):
    def test_the_oldest_version_still_needs_each(self):
        for each in DIFFERENCES:
            for version in (each.since, each.until):
                self.assertTrue(
                    version is None or version > OLDEST,
                    f"{each.holds.__name__} is the same in every version since {named(OLDEST)},"
                    " the oldest that is supported: take it out, and what asks it",
                )

    def test_each_begins_or_ends(self):
        for each in DIFFERENCES:
            self.assertTrue(each.since or each.until, each.holds.__name__)

    def test_each_fact_is_listed_once(self):
        facts = [f for f in functions() if inspect.signature(f).return_annotation == "bool"]
        listed = [each.holds for each in DIFFERENCES]
        self.assertCountEqual(listed, facts)

    def test_every_function_names_its_version(self):
        for function in functions():
            self.assertRegex(function.__doc__ or "", r"\b\d\.\d\b", function.__name__)

    def test_a_fact_s_sentence_names_the_version_of_the_list(self):
        for each in DIFFERENCES:
            for version in filter(None, (each.since, each.until)):
                words = f"(?i)\\b(since|until|before) {re.escape(named(version))}\\b"
                self.assertRegex(each.holds.__doc__, words, each.holds.__name__)

    def test_the_add_on_and_the_extension_name_versions_that_are_supported(self):
        self.assertEqual(wold_blender.bl_info["blender"][:2], OLDEST)
        manifest = stand_in.TEMPLATES / "blender/wold_blender/blender_manifest.toml"
        oldest = re.search(r'blender_version_min = "(\d+)\.(\d+)', manifest.read_text())
        self.assertGreaterEqual(tuple(map(int, oldest.groups())), OLDEST)
