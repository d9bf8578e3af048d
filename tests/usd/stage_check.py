"""Whether USD's own library finds in stages what Blender's files of the same film say.

    stage_check.py FOLDER

FOLDER: an output folder in which both have been written. Prints what it compared; ends with 1 and
says what differs otherwise.
"""

from __future__ import annotations

import json
import math
import sys
from array import array
from pathlib import Path
from typing import Any

from pxr import Gf, Usd, UsdGeom, UsdLux, UsdShade, UsdUtils, UsdValidation, UsdVol


def check(holds: bool, what: str) -> None:
    if not holds:
        sys.exit(f"stage_check.py: {what}")


def near(got: Any, want: Any, within: float, what: str) -> None:
    for a, b in zip(got, want, strict=True):
        check(abs(a - b) <= within, f"{what}: found {tuple(got)}, expected {tuple(want)}")


def floats(path: Path) -> array[float]:
    values = array("f")
    values.frombytes(path.read_bytes())
    return values


def validate(stage: Any) -> None:
    """All that USD's validators know, except for files of frames that were not made."""
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    for error in UsdValidation.ValidationContext(validators).Validate(stage):
        check(False, f"{stage.GetRootLayer().identifier}: {error.GetName()}: {error.GetMessage()}")


def choose(stage: Any, light: str) -> None:
    stage.GetDefaultPrim().GetVariantSet("light").SetVariantSelection(light)


class FrameOfBlender:
    """A frame as Blender's exporter has written it."""

    def __init__(self, out: Path, frame: int) -> None:
        self.folder = out / "blender" / "data" / f"frame_{frame:04}"
        self.facts = json.loads((self.folder / "frame.json").read_text())

    def numbers(self, name: str) -> array[float]:
        return floats(self.folder / name)

    def matrices(self, cells: str) -> list[Any]:
        """Of its instances: turned, scaled and turned again, then moved; angles about x, y, z."""
        entry = self.facts[cells]
        rows = [
            self.numbers(entry[key])
            for key in ("positions", "first_turns", "scales", "second_turns")
        ]

        def turn(angles: Any) -> Any:
            result = Gf.Matrix4d(1.0)
            for axis, angle in zip(
                (Gf.Vec3d(1, 0, 0), Gf.Vec3d(0, 1, 0), Gf.Vec3d(0, 0, 1)), angles
            ):
                result *= Gf.Matrix4d().SetRotate(Gf.Rotation(axis, math.degrees(angle)))
            return result

        result = []
        for i in range(entry["count"]):
            position, first, scale, second = (row[3 * i : 3 * i + 3] for row in rows)
            scaled = Gf.Matrix4d().SetScale(Gf.Vec3d(*scale))
            moved = Gf.Matrix4d().SetTranslate(Gf.Vec3d(*position))
            result.append(turn(first) * scaled * turn(second) * moved)
        return result


def check_metadata(stage: Any, first: int, last: int) -> None:
    check(UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.z, "z is not up")
    check(UsdGeom.GetStageMetersPerUnit(stage) == 1.0, "a unit is not a metre")
    times = (stage.GetStartTimeCode(), stage.GetEndTimeCode())
    check(times == (first, last), f"found time codes {times}, expected {(first, last)}")
    check(stage.GetDefaultPrim().GetPath() == "/Landscape", "found another default prim")


def check_camera(stage: Any, path: str, time: float, blender: FrameOfBlender) -> None:
    camera = UsdGeom.Camera(stage.GetPrimAtPath(path)).GetCamera(time)
    want = blender.facts["camera"]
    angle = camera.GetFieldOfView(Gf.Camera.FOVHorizontal)
    near([angle], [want["field_of_view_deg"]], 1e-4, "field of view")
    width, height = blender.facts["size_px"]
    near([camera.aspectRatio], [width / height], 1e-6, "aspect")
    near(camera.frustum.GetPosition(), want["eye_m"], 1e-5, "eye")
    forward = (Gf.Vec3d(*want["target_m"]) - Gf.Vec3d(*want["eye_m"])).GetNormalized()
    near(camera.frustum.ComputeViewDirection(), forward, 1e-6, "line of sight")
    check(camera.frustum.ComputeUpVector()[2] > 0, "the camera stands on its head")


def check_ground(stage: Any, blender: FrameOfBlender) -> None:
    terrain = blender.facts["terrain"]
    samples, size_m = terrain["samples"], terrain["size_m"]
    heights_m = blender.numbers(terrain["heights"])
    mesh = UsdGeom.Mesh(stage.GetPrimAtPath("/Landscape/ground"))
    points = mesh.GetPointsAttr().Get()
    st = UsdGeom.PrimvarsAPI(mesh).GetPrimvar("st").Get()
    normals = mesh.GetNormalsAttr().Get()
    found = 0
    for point, at, normal in zip(points, st, normals, strict=True):
        column, row = point[0] / size_m * (samples - 1), point[1] / size_m * (samples - 1)
        i, j = round(column), round(row)
        near(at, (point[0] / size_m, point[1] / size_m), 1e-4, "place in the ground's picture")
        check(normal[2] > 0, "the ground's normal looks down")
        if abs(column - i) < 1e-2 and abs(row - j) < 1e-2:
            near([point[2]], [heights_m[j * samples + i]], 1e-4, f"height at {tuple(point)}")
            found += 1
    check(found == samples * samples, f"found {found} heights, expected {samples**2}")
    first = mesh.GetFaceVertexIndicesAttr().Get()[:4]
    a, b, c = (Gf.Vec3d(*points[i]) for i in list(first)[:3])
    check(Gf.Cross(b - a, c - a)[2] > 0, "the ground's faces look down")


def whole_cells(matrices: list[Any]) -> list[list[Any]]:
    """How the parts of each cell lie: they have its corner and turn in common, but for a nudge."""
    cells: dict[tuple[int, ...], list[Any]] = {}
    for matrix in matrices:
        corner, east = matrix.GetRow(3), matrix.GetRow(0)
        key = (20 * corner[0], 20 * corner[1], east[0], east[1])
        cells.setdefault(tuple(round(value) for value in key), []).append(matrix)
    return list(cells.values())


def check_instances(stage: Any, blender: FrameOfBlender) -> int:
    """Every cell is where it is in Blender, sheared alike; one in parts lies among them."""
    cache = UsdGeom.XformCache(stage.GetStartTimeCode())
    instances = [prim for prim in Usd.PrimRange(stage.GetDefaultPrim()) if prim.IsInstance()]
    want = [[matrix] for matrix in blender.matrices("blade_cells")]
    want += whole_cells(blender.matrices("cells"))
    check(len(instances) == len(want), f"found {len(instances)} instances, expected {len(want)}")
    for prim, parts in zip(instances, want):
        got = cache.GetLocalToWorldTransform(prim)
        check(got.GetDeterminant() > 0, f"{prim.GetPath()} is mirrored")
        for row in range(4):
            for column in range(4):
                values = [matrix[row, column] for matrix in parts]
                inside = min(values) - 2e-3 <= got[row, column] <= max(values) + 2e-3
                check(inside, f"{prim.GetPath()}: found {got}, expected {parts[0]}")
    for prototype in stage.GetPrototypes():
        for prim in Usd.PrimRange(prototype):
            check_shape(prim)
    return len(instances)


def check_shape(prim: Any) -> None:
    if prim.IsA(UsdGeom.Mesh):
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        check(bool(material), f"{prim.GetPath()} has no material")
        check(
            material.ComputeSurfaceSource()[0].GetIdAttr().Get() == "UsdPreviewSurface",
            "another surface",
        )
    if prim.IsA(UsdVol.Volume):
        for name, path in UsdVol.Volume(prim).GetFieldPaths().items():
            field = UsdVol.OpenVDBAsset(prim.GetStage().GetPrimAtPath(path))
            check(field.GetFieldNameAttr().Get() == name, f"{path} has another name")
            file = field.GetFilePathAttr().Get().resolvedPath
            check(Path(file).is_file(), f"{path} has no file")


def check_lights(stage: Any, blender: FrameOfBlender) -> None:
    sun = UsdLux.DistantLight(stage.GetPrimAtPath("/Landscape/sun"))
    world = UsdGeom.Xformable(sun).ComputeLocalToWorldTransform(stage.GetStartTimeCode())
    to_sun = world.TransformDir(Gf.Vec3d(0, 0, 1))
    near(to_sun, blender.facts["daylight"]["to_sun"], 1e-6, "direction to the sun")
    colour, intensity = sun.GetColorAttr().Get(), sun.GetIntensityAttr().Get()
    check(sun.GetNormalizeAttr().Get(), "the sun's intensity is not what a plane receives")
    gain = blender.facts["exposure_gain"]
    irradiance = [gain * value for value in blender.facts["daylight"]["sun_irradiance"]]
    near([intensity * value for value in colour], irradiance, 1e-3 * max(irradiance), "sunlight")
    dome = UsdLux.DomeLight(stage.GetPrimAtPath("/Landscape/sky"))
    world = UsdGeom.Xformable(dome).ComputeLocalToWorldTransform(0)
    near(world.TransformDir(Gf.Vec3d(0, 1, 0)), (0, 0, 1), 1e-6, "the dome's pole")
    # The picture's middle is the dome's z, a quarter to the left its x.
    near(world.TransformDir(Gf.Vec3d(0, 0, 1)), (0, -1, 0), 1e-6, "the dome's middle")
    near(world.TransformDir(Gf.Vec3d(1, 0, 0)), (1, 0, 0), 1e-6, "a quarter left of it")
    check(Path(dome.GetTextureFileAttr().Get().resolvedPath).is_file(), "the sky has no picture")


def check_bounds(stage: Any, blender: FrameOfBlender) -> None:
    cache = UsdGeom.BBoxCache(stage.GetStartTimeCode(), [UsdGeom.Tokens.default_])
    box = cache.ComputeWorldBound(stage.GetPrimAtPath("/Landscape/Grass")).ComputeAlignedRange()
    size_m = blender.facts["terrain"]["size_m"]
    low, high = min(blender.numbers("heights_m.f32")), max(blender.numbers("heights_m.f32"))
    check(
        box.GetMin()[0] > -1.0 and box.GetMax()[0] < size_m + 1.0, f"grass beside the ground: {box}"
    )
    check(
        box.GetMin()[2] > low - 0.5 and box.GetMax()[2] < high + 1.0, f"grass off the ground: {box}"
    )
    check(box.GetMax()[2] > low + 0.02, f"grass in the ground: {box}")


def check_film(out: Path, frames: int) -> None:
    stage = Usd.Stage.Open(str(out / "usd" / "scene.usda"))
    validate(stage)
    check_metadata(stage, 1, frames)
    for frame in range(1, frames + 1):
        check_camera(stage, "/Landscape/camera", frame, FrameOfBlender(out, frame))
        for other in range(1, frames + 1):
            ground = UsdGeom.Imageable(stage.GetPrimAtPath(f"/Landscape/frame_{other:04}/ground"))
            visible = ground.ComputeVisibility(frame) != UsdGeom.Tokens.invisible
            check(visible == (other == frame), f"frame {other} at time code {frame}")
    choose(stage, "lit")
    prim = stage.GetPrimAtPath("/Landscape/frame_0001")
    check(prim.GetVariantSet("light").GetVariantSelection() == "lit", "light of the frames")


def check_frame(out: Path, frame: int) -> int:
    """Returns the number of its instances."""
    blender = FrameOfBlender(out, frame)
    stage = Usd.Stage.Open(str(out / "usd" / f"frame.{frame:04}.usda"))
    for light in ("lit", "baked"):
        choose(stage, light)
        validate(stage)
        check_lights(stage, blender)
        material, _ = UsdShade.MaterialBindingAPI(
            stage.GetPrimAtPath("/Landscape/ground")
        ).ComputeBoundMaterial()
        surface = material.ComputeSurfaceSource()[0]
        input_name = "emissiveColor" if light == "baked" else "diffuseColor"
        check(surface.GetInput(input_name).HasConnectedSource(), f"{light}: the ground's material")
    check_metadata(stage, frame, frame)
    check_camera(stage, "/Landscape/camera", frame, blender)
    check_ground(stage, blender)
    instances = check_instances(stage, blender)
    check_bounds(stage, blender)
    _, _, missing = UsdUtils.ComputeAllDependencies(stage.GetRootLayer().identifier)
    check(not missing, f"found no {missing}")
    return instances


def main() -> None:
    out = Path(sys.argv[1])
    frames = len(list((out / "usd").glob("frame.*.usda")))
    check(frames > 0, f"found no frames in {out}")
    for frame in range(1, frames + 1):
        print(f"{out.name}, frame {frame}: {check_frame(out, frame)} instances as in Blender")
    check_film(out, frames)


main()
