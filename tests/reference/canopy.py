"""Traces paths through the canopy that canopy_leaves wrote, with Mitsuba 3, to the table on stdout.

    build/canopy_leaves FOLDER
    python3 tests/reference/canopy.py FOLDER >tests/data/light/canopy.csv

Each row is the mean radiance of the level meadow for a sun, a weathering degree and a view: all
orders of scattering between blades and ground. Radiance is divided by the irradiance of level
ground, times pi: a white card has 1. The Python needs mitsuba and numpy; DRJIT_LIBLLVM_PATH names
an LLVM where Mitsuba finds none.
"""

import argparse
import json
import math
import pathlib
import sys

import mitsuba as mi
import numpy as np

TEMPLATES = pathlib.Path(__file__).parents[2] / "templates" / "mitsuba"
# Patches on each side of the one that is looked at, which is as far as light comes from the side.
REACH = 7


def values(path: str):
    """Of a picture, (rows, columns, channels)."""
    return np.atleast_3d(np.array(mi.Bitmap(path))).astype(np.float32)


def picture(of) -> dict:
    return {
        "type": "bitmap",
        "bitmap": mi.Bitmap(np.ascontiguousarray(of)),
        "raw": True,
        "wrap_mode": "clamp",
        "filter_type": "nearest",
    }


def tiled(leaf: pathlib.Path, canopy: dict, bsdf: dict):
    """A patch's leaves beside themselves, as one mesh: instances would be as many shapes."""
    patch_m = canopy["patch_m"]
    one = mi.traverse(mi.load_dict({"type": "ply", "filename": f"{leaf}.ply"}))
    places = np.array(one["vertex_positions"]).reshape(-1, 3)
    faces = np.array(one["faces"]).reshape(-1, 3)
    cells = [(i, j) for i in range(-REACH, REACH + 1) for j in range(-REACH, REACH + 1)]
    mesh = mi.Mesh(
        "leaves",
        vertex_count=len(places) * len(cells),
        face_count=len(faces) * len(cells),
        has_vertex_texcoords=True,
        props=leaf_properties(bsdf),
    )
    parameters = mi.traverse(mesh)
    moved = [places + np.array([i * patch_m, j * patch_m, 0.0]) for i, j in cells]
    parameters["vertex_positions"] = np.concatenate(moved).astype(np.float32).ravel()
    numbered = [faces + k * len(places) for k in range(len(cells))]
    parameters["faces"] = np.concatenate(numbered).astype(np.uint32).ravel()
    texcoords = np.array(one["vertex_texcoords"])
    parameters["vertex_texcoords"] = np.tile(texcoords, len(cells))
    parameters.update()
    return mesh


def matte_leaf(leaf: pathlib.Path) -> dict:
    """Leaves whose reflected light goes to all sides alike, as four-stream theory has them."""
    return {
        "type": "bilambertian",
        "reflectance": picture(values(f"{leaf}_reflectance.exr")),
        "transmittance": picture(values(f"{leaf}_transmittance.exr")),
    }


def glossy_leaf(leaf: pathlib.Path, specular_exponent: float) -> dict:
    """Part of what leaves reflect is mirrored: rough mirrors, turned about the axes of blades by
    all angles, have a highlight whose width along the axis is that of cos^specular_exponent."""
    mirrored = values(f"{leaf}_mirrored.exr")
    reflectance = values(f"{leaf}_reflectance.exr")
    transmittance = values(f"{leaf}_transmittance.exr")
    diffuse = {
        "type": "bilambertian",
        "reflectance": picture(np.maximum(reflectance - mirrored, 0.0) / (1.0 - mirrored)),
        "transmittance": picture(transmittance / (1.0 - mirrored)),
    }
    slope = math.sqrt(0.5 / specular_exponent)
    mirror = {"type": "roughconductor", "material": "none", "alpha": slope}
    return {
        "type": "blendbsdf",
        "weight": picture(mirrored),
        "diffuse": diffuse,
        "mirror": {"type": "twosided", "nested": mirror},
    }


def leaf_properties(bsdf: dict):
    properties = mi.Properties()
    properties["face_normals"] = True
    properties["bsdf"] = mi.load_dict(bsdf)
    return properties


def meadow(folder: pathlib.Path, canopy: dict, sun: dict, leaf: pathlib.Path, bsdf: dict):
    """The patch's leaves, beside themselves on level ground, under a sun and its sky."""
    elevation = math.radians(sun["elevation_deg"])
    return mi.load_dict(
        {
            "type": "scene",
            "sky": {
                "type": "envmap",
                "filename": str(folder / f"sky_{sun['elevation_deg']:.0f}.exr"),
                "to_world": mi.ScalarTransform4f().rotate([1, 0, 0], 90),
            },
            "sun": {
                "type": "directional",
                "direction": [0.0, math.cos(elevation), -math.sin(elevation)],
                "irradiance": {"type": "rgb", "value": sun["irradiance"]},
            },
            "ground": {
                "type": "rectangle",
                "to_world": mi.ScalarTransform4f().scale(1000.0),
                "bsdf": {
                    "type": "diffuse",
                    "reflectance": {"type": "rgb", "value": canopy["ground_albedo"]},
                },
            },
            "leaves": tiled(leaf, canopy, bsdf),
        }
    )


def camera(patch_m: float, plane: str, view_deg: float, pixels: int):
    """Parallel rays that cover one patch of the ground, seen from view_deg off the vertical.

    "principal": from the north for positive angles, where one looks towards the sun.
    "across": from the east.
    """
    view = math.radians(view_deg)
    ahead, up = ([0, 1, 0], [0, 1, 0]) if plane == "principal" else ([1, 0, 0], [1, 0, 0])
    eye = [math.sin(view) * a * 50.0 for a in ahead]
    eye[2] = math.cos(view) * 50.0
    look = mi.ScalarTransform4f().look_at(origin=eye, target=[0, 0, 0], up=up)
    size = mi.ScalarTransform4f().scale([patch_m / 2, patch_m / 2 * math.cos(view), 1.0])
    return mi.load_dict(
        {
            "type": "orthographic",
            "to_world": look @ size,
            "near_clip": 0.01,
            "far_clip": 1000.0,
            "film": {
                "type": "hdrfilm",
                "width": pixels,
                "height": pixels,
                "rfilter": {"type": "box"},
                "pixel_format": "rgb",
                "component_format": "float32",
            },
            "sampler": {"type": "independent"},
        }
    )


def main() -> None:
    parser = argparse.ArgumentParser(description="Path-traced radiance of a canopy.")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--samples", type=int, default=64, help="per pixel")
    parser.add_argument("--pixels", type=int, default=40, help="along a patch")
    parser.add_argument("--depth", type=int, default=-1, help="of paths; -1: all orders")
    parser.add_argument("--variants", type=int, default=0, help="how many; 0: all")
    parser.add_argument("--weathering", type=float, nargs="*", help="only these degrees")
    parser.add_argument("--suns", type=float, nargs="*", help="only these, degrees")
    parser.add_argument("--matte", action="store_true", help="leaves without gloss")
    chosen = parser.parse_args()
    mi.set_variant("llvm_ad_rgb")
    sys.path.insert(0, str(TEMPLATES))
    import bilambertian

    bilambertian.register()
    canopy = json.loads((chosen.folder / "canopy.json").read_text())
    integrator = mi.load_dict({"type": "path", "max_depth": chosen.depth, "rr_depth": 12})
    variants = range(chosen.variants or canopy["variants"])

    def scene_of(sun: dict, weathering: float, variant: int):
        leaf = chosen.folder / f"w{weathering:.3f}_v{variant}"
        bsdf = matte_leaf(leaf) if chosen.matte else glossy_leaf(leaf, canopy["specular_exponent"])
        return meadow(chosen.folder, canopy, sun, leaf, bsdf)

    print("sun_deg,weathering,plane,view_deg,red,green,blue,error")
    for sun in canopy["suns"]:
        if chosen.suns and sun["elevation_deg"] not in chosen.suns:
            continue
        for weathering in chosen.weathering or canopy["weathering"]:
            scenes = [scene_of(sun, weathering, v) for v in variants]
            for plane in ("principal", "across"):
                for view_deg in canopy["views_deg"]:
                    sensor = camera(canopy["patch_m"], plane, view_deg, chosen.pixels)
                    means, errors = [], []
                    for seed, scene in enumerate(scenes):
                        image = np.array(
                            mi.render(
                                scene,
                                sensor=sensor,
                                integrator=integrator,
                                spp=chosen.samples,
                                seed=seed,
                            )
                        )
                        rows = image.reshape(-1, 3) * math.pi
                        means.append(rows.mean(axis=0))
                        errors.append(rows[:, 1].std() / math.sqrt(len(rows)))
                    red, green, blue = np.mean(means, axis=0)
                    error = float(np.sqrt(np.sum(np.square(errors)))) / len(errors)
                    print(
                        f"{sun['elevation_deg']:g},{weathering:g},{plane},{view_deg},"
                        f"{red:.5f},{green:.5f},{blue:.5f},{error:.5f}",
                        flush=True,
                    )


if __name__ == "__main__":
    main()
