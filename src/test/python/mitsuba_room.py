"""Renders a room with Mitsuba 3, as truth that is independent of Lightning.

    mitsuba_room.py scene.jen picture.exr [--samples 16384] [--seed 0] [--direct] [--environment sky.hdr] [--variant scalar_rgb]

It reads the part of the format that the rooms of src/test/rooms use: no groups, diffuse materials without images, and lights with inverse-square
falloff. A room under a uniform sky gets the sky's light through its portals, which its comments name: the path tracer finds these more easily.
"""

import argparse
import pathlib
import re
import sys

import mitsuba as mi
import numpy as np

SIZE = (96, 54)
BATCH = 1024
"""Samples per pixel of a batch; the noise follows from the differences of batches."""
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
KINDS = ("picture", "camera", "world", "material", "plane", "mesh", "sphere", "cylinder", "light", "portal")


class Block(dict):
    """Properties of a block, each a list of words: numbers, names and strings without quotes."""

    def numbers(self, name: str, default: str) -> list[float]:
        return [float(word) for word in self.get(name, default.split())]


def read(file: pathlib.Path) -> list[Block]:
    """Returns the blocks of a file; comments with a portal count as blocks."""
    text = re.sub(r"^# (?=portal \{)", "", file.read_text(encoding="utf-8"), flags=re.M)
    words = re.findall(r'"[^"]*"|[{}]|[^\s{}"]+', re.sub(r"#.*", "", text))
    words = words[2:]
    blocks = []
    while words:
        start = words.index("{")
        head, words = words[:start], words[start + 1:]
        assert head[0] in KINDS, head
        block = Block(kind=head[0], head=head[1:])
        name = ""
        while (word := words.pop(0)) != "}":
            if word == "{":
                block["bounces"] = ["2"]
                while (word := words.pop(0)) != "}":
                    assert word == "bounces", word
                    block["bounces"] = [words.pop(0)]
            elif re.match(r"[A-Za-z_]", word) and name not in ("material", "file", "falloff", "environment", "visible") or not name:
                name = word
                block[name] = []
            else:
                block[name].append(word.strip('"'))
                if name in ("material", "file", "falloff", "environment", "visible"):
                    name = ""
        blocks.append(block)
    return blocks


def place(block: Block):
    """Returns the transformation of a shape: scaled, rotated about x, y and z, and moved."""
    transform = mi.ScalarTransform4f
    x, y, z = block.numbers("rotate", "0 0 0")
    return (transform().translate(block.numbers("at", "0 0 0")).rotate([0, 0, 1], z).rotate([0, 1, 0], y).rotate([1, 0, 0], x)
            .scale(block.numbers("scale", "1 1 1")))


def square():
    """Returns the transformation of Mitsuba's rectangle to a plane of side 1 that faces y."""
    return mi.ScalarTransform4f().rotate([1, 0, 0], -90).scale([0.5, 0.5, 1])


def rgb(values) -> dict:
    return {"type": "rgb", "value": [float(v) for v in values]}


BLACK = {"type": "diffuse", "reflectance": {"type": "rgb", "value": 0}}


def area(radiance) -> dict:
    return {"type": "area", "radiance": rgb(radiance)}


def parts(block: Block, folder: pathlib.Path) -> list[dict]:
    """Returns Mitsuba's shapes for a shape, with normals outward."""
    to_world = place(block)
    if block["kind"] == "plane":
        return [{"type": "rectangle", "to_world": to_world @ square()}]
    if block["kind"] == "sphere":
        return [{"type": "sphere", "to_world": to_world}]
    if block["kind"] == "mesh":
        return [{"type": "obj", "filename": str(folder / block["file"][0]), "face_normals": True, "to_world": to_world}]
    up = mi.ScalarTransform4f().rotate([1, 0, 0], -90)
    top = mi.ScalarTransform4f().translate([0, 1, 0])
    down = mi.ScalarTransform4f().rotate([1, 0, 0], 90)
    return [{"type": "cylinder", "to_world": to_world @ up}, {"type": "disk", "to_world": to_world @ top @ up},
            {"type": "disk", "to_world": to_world @ down}]


def light(block: Block) -> dict:
    """Returns Mitsuba's emitter or shape for a light. Intensity I at distance d makes the irradiance π I / d²."""
    assert block["falloff"] == ["inverse_square"], block
    power = np.pi * np.array(block.numbers("color", "1 1 1")) * block.numbers("intensity", "1")[0]
    at = block.numbers("at", "0 0 0")
    radius = block.numbers("radius", "0")[0]
    if block["head"][1] == "point" and radius == 0:
        return {"type": "point", "position": at, "intensity": rgb(power)}
    if block["head"][1] == "point":
        return {"type": "sphere", "center": at, "radius": radius, "bsdf": BLACK, "emitter": area(power / (np.pi * radius ** 2))}
    assert block["head"][1] == "rect", block
    width, height = block.numbers("width", "1")[0], block.numbers("height", "1")[0]
    target = np.array(at) + block.numbers("direction", "0 -1 0")
    to_world = mi.ScalarTransform4f().look_at(origin=at, target=list(target), up=block.numbers("up", "0 1 0")).scale([width / 2, height / 2, 1])
    return {"type": "rectangle", "to_world": to_world, "bsdf": BLACK, "emitter": area(power / (width * height))}


def sky(world: Block, file: pathlib.Path, portals: list[Block]) -> list[dict]:
    """Returns the emitters of the environment. Lightning's image has −z at its center, Mitsuba's at its sides."""
    image = np.array(mi.Bitmap(str(file)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32, False))
    if portals and np.ptp(image, axis=(0, 1)).max() == 0:
        return [{"type": "rectangle", "to_world": place(p) @ square(), "bsdf": BLACK, "emitter": area(image[0, 0])} for p in portals]
    turn = mi.ScalarTransform4f().rotate([0, 1, 0], world.numbers("rotation", "0")[0] + 180)
    return [{"type": "envmap", "bitmap": mi.Bitmap(finer(image)), "to_world": turn}]


def finer(image: np.ndarray) -> np.ndarray:
    """Returns the image with four times as many lines and columns. Mitsuba's first and last lines are at the poles; Lightning's are half a line away."""
    height, width, _ = image.shape
    for axis, places in ((0, np.arange(4 * height) / (4 * height - 1) * height - 0.5), (1, (np.arange(4 * width) + 0.5) / 4 - 0.5)):
        low = np.floor(places).astype(int)
        part = (places - low).reshape((-1, 1, 1) if axis == 0 else (1, -1, 1))
        size = image.shape[axis]
        ends = [np.clip(low + i, 0, size - 1) if axis == 0 else (low + i) % size for i in (0, 1)]
        image = np.take(image, ends[0], axis) * (1 - part) + np.take(image, ends[1], axis) * part
    return image.astype(np.float32)


def scene(blocks: list[Block], folder: pathlib.Path, environment: pathlib.Path | None, glow: bool) -> dict:
    """Returns the scene with the light of glowing shapes only, or with all other light."""
    materials = {b["head"][0]: b for b in blocks if b["kind"] == "material"}
    by_kind = {b["kind"]: b for b in blocks}
    camera = by_kind["camera"]
    view = mi.ScalarTransform4f().look_at(origin=camera.numbers("from", "0 0 10"), target=camera.numbers("to", "0 0 0"), up=[0, 1, 0])
    result = {"type": "scene", "sensor": {
        "type": "perspective", "fov_axis": "y", "fov": camera.numbers("fov", "40")[0], "to_world": view, "near_clip": 0.001,
        "film": {"type": "hdrfilm", "width": SIZE[0], "height": SIZE[1], "rfilter": {"type": "box"}, "pixel_format": "rgb"},
        "sampler": {"type": "independent"}}}
    added = []
    for block in blocks:
        if block["kind"] in ("plane", "mesh", "sphere", "cylinder"):
            material = materials[block["material"][0]]
            for part in parts(block, folder):
                part["bsdf"] = {"type": "twosided", "bsdf": {"type": "diffuse", "reflectance": rgb(material.numbers("diffuse", "0.8 0.8 0.8"))}}
                if glow and "glow" in material:
                    part["emitter"] = area(material.numbers("glow", "0 0 0"))
                added.append(part)
        elif block["kind"] == "light" and not glow:
            added.append(light(block))
    if environment and not glow:
        added += sky(by_kind["world"], environment, [b for b in blocks if b["kind"] == "portal"])
    return result | {f"part_{i}": part for i, part in enumerate(added)}


def find(folder: pathlib.Path, name: str) -> pathlib.Path:
    """Returns a file of the scene's folder, or of the nearest folder of textures above it."""
    return next(f for f in [folder / name] + [p / "textures" / name for p in (folder.resolve(), *folder.resolve().parents)] if f.exists())


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("scene", type=pathlib.Path)
    parser.add_argument("picture")
    parser.add_argument("--samples", type=int, default=16 * BATCH)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--direct", action="store_true", help="without indirect light")
    parser.add_argument("--environment", help="another environment than the scene's")
    parser.add_argument("--variant", default="scalar_rgb")
    options = parser.parse_args()
    mi.set_variant(options.variant)
    blocks = read(options.scene)
    folder = options.scene.parent
    by_kind = {b["kind"]: b for b in blocks}
    name = options.environment or by_kind["world"].get("environment", [None])[0]
    bounces = 0 if options.direct else int(by_kind["picture"].get("bounces", ["2"])[0])
    # Light of lights is scattered once more than bounces say, at the surface that is seen. A glow is light that a surface sends.
    passes = [(scene(blocks, folder, name and find(folder, name), False), bounces + 2)]
    if any("glow" in b for b in blocks):
        passes.append((scene(blocks, folder, None, True), bounces + 1))
    batches = np.zeros((max(1, options.samples // BATCH), SIZE[1], SIZE[0], 3))
    for description, depth in passes:
        loaded = mi.load_dict(description)
        path = mi.load_dict({"type": "path", "max_depth": depth, "rr_depth": 1000})
        for i, batch in enumerate(batches):
            samples = min(BATCH, options.samples)
            batch += np.array(mi.render(loaded, integrator=path, spp=samples, seed=options.seed * 10000 + i))
    mean = batches.mean(axis=0)
    truth = mean @ LUMINANCE
    noise = (batches @ LUMINANCE).std(axis=0, ddof=1) / np.sqrt(len(batches)) if len(batches) > 1 else np.zeros(truth.shape)
    relative = noise / np.maximum(truth, truth.mean() / 20)
    print(f"mean {truth.mean():.5f}  noise {100 * relative.mean():.2f} %  95th percentile {100 * np.quantile(relative, 0.95):.2f} %")
    mi.Bitmap(mean.astype(np.float32)).convert(component_format=mi.Struct.Type.Float16).write(options.picture)


if __name__ == "__main__":
    sys.exit(main())
