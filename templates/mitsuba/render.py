"""Renders a frame that `wold generate --renderer mitsuba` has written, with Mitsuba 3.

    python3 render.py out/hillside/mitsuba/data/frame_0001/scene.xml --out picture.png
    python3 render.py SCENE --samples 256 --out picture.exr

The Python needs the package mitsuba (3.5 or later). SCENE holds data only, nothing in it is run.
EXR pictures are linear radiance as Mitsuba has it; others are exposed as wold exposes the frame
and encoded as sRGB, so that they compare with those of other renderers. llvm_ad_rgb needs a newer
LLVM than some systems have (DRJIT_LIBLLVM_PATH names one) and minutes to begin with where a scene
has many meshes of leaves or cells of texels; scalar_rgb needs neither.
"""

import argparse
import sys
import xml.etree.ElementTree as ElementTree


def exposure_gain(scene: str) -> float:
    """The factor on radiance before it is encoded."""
    for default in ElementTree.parse(scene).getroot().iter("default"):
        if default.get("name") == "exposure_gain":
            return float(default.get("value", "1"))
    sys.exit(f"wold: error {scene} has no exposure_gain: it is no scene of wold's")


def main() -> None:
    parser = argparse.ArgumentParser(description="Renders a frame with Mitsuba 3.")
    parser.add_argument("scene", help="a frame's scene.xml")
    parser.add_argument("--out", required=True, help="the picture: .exr, .png or .jpg")
    parser.add_argument("--samples", type=int, default=0, help="per pixel; as the scene has it")
    parser.add_argument("--variant", default="scalar_rgb", help="of Mitsuba: scalar_rgb ...")
    parser.add_argument("--seed", type=int, default=0)
    chosen = parser.parse_args()
    gain = exposure_gain(chosen.scene)

    import mitsuba

    mitsuba.set_variant(chosen.variant)
    import bilambertian

    bilambertian.register()
    scene = mitsuba.load_file(chosen.scene)
    picture = mitsuba.render(scene, spp=chosen.samples, seed=chosen.seed)
    if chosen.out.endswith(".exr"):
        mitsuba.Bitmap(picture).write(chosen.out)
    else:
        mitsuba.util.write_bitmap(chosen.out, picture * gain, write_async=False)


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    main()
