"""Follows light through the cloud that cloud_grid wrote, with Mitsuba 3, to pictures in a folder.

    build/cloud_grid FOLDER
    python3 tests/reference/clouds.py FOLDER --out tests/data/light

One picture for each sun, linear radiance: every order of scattering by droplets that absorb
nothing, before the sky. The Python needs mitsuba and numpy; DRJIT_LIBLLVM_PATH names an LLVM where
Mitsuba finds none.
"""

import argparse
import json
import pathlib
import time

import mitsuba as mi
import numpy as np


def box(low_m: list, high_m: list):
    """From the unit cube to the grid's place."""
    size_m = [high - low for low, high in zip(low_m, high_m)]
    return mi.ScalarTransform4f().translate(low_m) @ mi.ScalarTransform4f().scale(size_m)


def droplets(folder: pathlib.Path, clouds: dict, place) -> dict:
    return {
        "type": "heterogeneous",
        "sigma_t": {
            "type": "gridvolume",
            "filename": str(folder / "cloud.vol"),
            "to_world": place,
            "raw": True,
        },
        "albedo": 1.0,
        "phase": {"type": "hg", "g": clouds["asymmetry"]},
    }


def camera(clouds: dict) -> dict:
    width, height = clouds["size_px"]
    return {
        "type": "perspective",
        "fov": clouds["field_of_view_deg"],
        "fov_axis": "x",
        "to_world": mi.ScalarTransform4f().look_at(
            origin=clouds["eye_m"], target=clouds["target_m"], up=[0, 0, 1]
        ),
        "film": {
            "type": "hdrfilm",
            "width": width,
            "height": height,
            "rfilter": {"type": "box"},
            "pixel_format": "rgb",
            "component_format": "float32",
        },
        "sampler": {"type": "independent"},
    }


def sky(folder: pathlib.Path, clouds: dict, sun: dict):
    """The cloud before the sky, in the sun."""
    place = box(clouds["low_m"], clouds["high_m"])
    unit = mi.ScalarTransform4f().translate([0.5, 0.5, 0.5]) @ mi.ScalarTransform4f().scale(0.5)
    return mi.load_dict(
        {
            "type": "scene",
            "sky": {
                "type": "envmap",
                "filename": str(folder / f"sky_{sun['name']}.exr"),
                "to_world": mi.ScalarTransform4f().rotate([1, 0, 0], 90),
            },
            "sun": {
                "type": "directional",
                "direction": [-x for x in sun["direction"]],
                "irradiance": {"type": "rgb", "value": sun["irradiance"]},
            },
            "cloud": {
                "type": "cube",
                "to_world": place @ unit,
                "bsdf": {"type": "null"},
                "interior": droplets(folder, clouds, place),
            },
            "camera": camera(clouds),
        }
    )


def picture(scene, integrator, samples: int, at_a_time: int) -> tuple[np.ndarray, float]:
    """The mean of passes, and how far off its own mean is by chance, as a fraction."""
    passes = [
        np.array(mi.render(scene, integrator=integrator, spp=at_a_time, seed=seed))
        for seed in range(max(2, samples // at_a_time))
    ]
    means = [one.mean() for one in passes]
    return np.mean(passes, axis=0), float(np.std(means) / np.mean(means) / len(means) ** 0.5)


def main() -> None:
    parser = argparse.ArgumentParser(description="Radiance of a cloud, all orders of scattering.")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--samples", type=int, default=4096, help="per pixel")
    parser.add_argument("--suns", nargs="*", help="only these: 20_towards ...")
    chosen = parser.parse_args()
    mi.set_variant("llvm_ad_rgb")
    clouds = json.loads((chosen.folder / "clouds.json").read_text())
    chosen.out.mkdir(parents=True, exist_ok=True)
    # No path ends by chance: all leave the cloud in the end.
    integrator = mi.load_dict({"type": "volpath", "max_depth": -1, "rr_depth": 100000})
    for sun in clouds["suns"]:
        if chosen.suns and sun["name"] not in chosen.suns:
            continue
        begin = time.time()
        image, error = picture(sky(chosen.folder, clouds, sun), integrator, chosen.samples, 64)
        mi.Bitmap(image.astype(np.float16)).write(str(chosen.out / f"cloud_{sun['name']}.exr"))
        print(f"{sun['name']}: +- {error:.4f} of the mean, {time.time() - begin:.0f} s", flush=True)


if __name__ == "__main__":
    main()
