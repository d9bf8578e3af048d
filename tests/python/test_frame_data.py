"""Reading what was exported: what is damaged is told, and no name leads out of the folder."""

import json
import os
import pathlib
import struct
import sys
import tempfile
import unittest
import unittest.mock

import stand_in  # noqa: F401
from wold_blender import frame_data
from wold_blender.frame_data import DataError, Frame, Moment


class ExportedFolder(unittest.TestCase):
    """A folder "blender" with one frame in it."""

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.scratch = pathlib.Path(scratch.name).resolve()
        self.folder = self.scratch / "blender"
        self.write_frame(1, {})

    def frame_folder(self, number):
        return self.folder / "data" / f"frame_{number:04d}"

    def write_frame(self, number, values):
        whole = {"format": frame_data.NEWEST_FORMAT, "weathering": 0.0, "time_s": 0.0, **values}
        self.write_json(number, json.dumps(whole))

    def write_json(self, number, text):
        self.frame_folder(number).mkdir(parents=True, exist_ok=True)
        (self.frame_folder(number) / "frame.json").write_text(text)

    def frame(self, number=1):
        return Frame(number, str(self.folder))

    def fails(self, words, call, *arguments):
        with self.assertRaises(DataError) as caught:
            call(*arguments)
        self.assertIn(words, str(caught.exception))


class FrameJson(ExportedFolder):
    def test_values_are_found_by_name(self):
        self.write_frame(1, {"samples": 7})
        self.assertEqual(self.frame()["samples"], 7)

    def test_a_missing_value_is_named(self):
        self.fails('frame.json has no "samples"', lambda: self.frame()["samples"])

    def test_light_has_maps_by_number(self):
        self.write_frame(1, {"light": {"samples": 3}, "light_details": [{"light": {"samples": 5}}]})
        self.assertEqual(self.frame().light_map("light", 0), {"samples": 3})
        self.assertEqual(self.frame().light_map("light", 1), {"samples": 5})
        for name, number in (("light", 2), ("standing_light", 1)):
            self.fails(f"has no {name} {number}", self.frame().light_map, name, number)
        self.assertEqual(frame_data.light_map_of({"light_map": 2}), 2)
        self.assertEqual(frame_data.light_map_of({}), 0)  # of an older frame

    def test_a_missing_frame_is_an_error_that_says_what_to_do(self):
        self.fails("frame_0002/frame.json", self.frame, 2)
        self.fails("run `wold generate` again", self.frame, 2)

    def test_damaged_json_is_an_error(self):
        for text in ("", '{"format": 5', "[" * 100000):
            self.write_json(1, text)
            self.fails("cannot read", self.frame)

    def test_bytes_that_are_no_text_are_an_error(self):
        (self.frame_folder(1) / "frame.json").write_bytes(b'{"format": "\xff\xfe"}')
        self.fails("cannot read", self.frame)

    def test_another_format_is_an_error_that_names_both(self):
        self.write_frame(1, {"format": 4})
        self.fails(f"has format 4, {frame_data.NEWEST_FORMAT} was expected", self.frame)

    def test_json_that_is_no_frame_has_no_format(self):
        for text in ("[]", "5", '"frame"', "null", "{}"):
            self.write_json(1, text)
            self.fails("has format None", self.frame)


class NamesOfFiles(ExportedFolder):
    def outside(self, name):
        self.fails("which is outside", self.frame().path, name)

    def test_files_of_the_frame_and_of_other_frames_are_found(self):
        data = self.folder / "data"
        self.assertEqual(self.frame().path("sky.png"), str(data / "frame_0001" / "sky.png"))
        self.assertEqual(self.frame().path("../volumes/a.vdb"), str(data / "volumes" / "a.vdb"))

    def test_no_name_leads_out_by_dots(self):
        self.outside("../../secret")
        self.outside("../../../blender/data_of_another/secret")
        self.outside("../..")

    def test_a_folder_whose_name_only_begins_like_the_data_s_is_outside(self):
        (self.folder / "data2").mkdir()
        self.outside("../../data2/secret")

    def test_no_name_is_absolute(self):
        self.outside("/etc/passwd")

    def test_no_symbolic_link_leads_out(self):
        secret = self.scratch / "secret"
        secret.write_bytes(bytes(4))
        (self.frame_folder(1) / "heights").symlink_to(secret)
        (self.frame_folder(1) / "up").symlink_to(self.scratch)
        self.outside("heights")
        self.outside("up/secret")
        self.fails("which is outside", self.frame().numbers, "heights", "f", 1)

    def test_the_exported_folder_may_be_a_link_itself(self):
        link = self.scratch / "link"
        link.symlink_to(self.folder)
        found = Frame(1, str(link)).path("sky.png")
        self.assertEqual(found, str(self.frame_folder(1) / "sky.png"))


class Numbers(ExportedFolder):
    def write(self, packed):
        (self.frame_folder(1) / "n").write_bytes(packed)

    def test_numbers_are_little_endian(self):
        self.write(struct.pack("<3f", 0.5, -2.0, 1e10))
        self.assertSequenceEqual(self.frame().numbers("n", "f", 3), [0.5, -2.0, 1e10])
        self.write(struct.pack("<2i", 1, -(2**31)))
        self.assertSequenceEqual(self.frame().numbers("n", "i", 2), [1, -(2**31)])

    def test_a_big_endian_machine_turns_the_bytes_round(self):
        turned = ">2i" if sys.byteorder == "little" else "<2i"
        self.write(struct.pack(turned, 1, -7))
        with unittest.mock.patch.object(sys, "byteorder", "big"):
            self.assertSequenceEqual(self.frame().numbers("n", "i", 2), [1, -7])

    def test_a_missing_file_is_named(self):
        self.fails("frame_0001/n is missing", self.frame().numbers, "n", "f", 1)
        (self.frame_folder(1) / "n").mkdir()
        self.fails("frame_0001/n is missing", self.frame().numbers, "n", "f", 1)

    def test_a_file_that_is_cut_or_too_long_is_damaged(self):
        for size in (0, 11, 13):
            self.write(bytes(size))
            message = f"is damaged: it has {size} bytes, 12 were expected"
            self.fails(message, self.frame().numbers, "n", "f", 3)


class Moments(ExportedFolder):
    def test_frames_are_in_the_order_of_their_numbers(self):
        for number in (10000, 9, 9999):
            self.write_frame(number, {"weathering": 0.25, "time_s": 2 * number})
        self.frame_folder(11).mkdir()  # without a frame.json
        (self.folder / "data" / "frame_x").mkdir()
        self.assertEqual(
            frame_data.moments(str(self.folder)),
            [
                Moment(0.0, 0.0, 1),
                Moment(0.25, 18.0, 9),
                Moment(0.25, 19998.0, 9999),
                Moment(0.25, 20000.0, 10000),
            ],
        )

    def test_a_folder_without_frames_is_an_error_that_says_what_to_choose(self):
        os.remove(self.frame_folder(1) / "frame.json")
        self.fails('choose the folder "blender"', frame_data.moments, str(self.folder))
        self.fails("has no frames", frame_data.moments, str(self.scratch))

    def test_a_frame_of_another_format_or_without_a_moment_is_an_error(self):
        self.write_frame(2, {"format": 4})
        self.fails("has format 4", frame_data.moments, str(self.folder))
        for wrong in (None, "dawn", []):
            self.write_frame(2, {"time_s": wrong})
            self.fails("cannot read", frame_data.moments, str(self.folder))


class Nearest(unittest.TestCase):
    frames = (Moment(0.0, 0.0, 1), Moment(0.5, 10.0, 2), Moment(0.5, 20.0, 4), Moment(1.0, 30.0, 7))

    def test_degree_counts_before_time(self):
        picked = [
            frame_data.nearest_in_degree(self.frames, *wanted)
            for wanted in ((0.1, 30.0), (0.4, 0.0), (0.4, 16.0), (0.9, 0.0))
        ]
        self.assertEqual(picked, [1, 2, 4, 7])

    def test_ends_are_held_and_of_equally_near_numbers_the_earlier_is_taken(self):
        wanted = (-5, 1, 3, 5, 6, 250)
        picked = [frame_data.nearest_in_number(self.frames, number) for number in wanted]
        self.assertEqual(picked, [1, 1, 2, 4, 7, 7])
        backwards = tuple(reversed(self.frames))
        self.assertEqual(frame_data.nearest_in_number(backwards, 3), 2)
