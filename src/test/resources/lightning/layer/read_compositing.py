"""Reads a picture with layers and mattes by OpenEXR's own library, and prints its header as JSON.

Checks that layers add up to the picture in every bit, that the ids of the manifests are the hashes of their names, and that the mattes
of all objects add up to the surfaces. The file must have one sample per pixel, so that a matte is the mask of its object.
"""

import json
import struct
import sys
from fractions import Fraction

import numpy
import OpenEXR


def hash_of(name: str) -> int:
    """Returns the 32-bit MurmurHash3 of a name with seed 0."""
    data = name.encode()
    mask = 0xFFFFFFFF
    h = 0
    for start in range(0, len(data), 4):
        block = data[start : start + 4]
        k = int.from_bytes(block, "little") * 0xCC9E2D51 & mask
        k = (k << 15 | k >> 17) & mask
        h ^= k * 0x1B873593 & mask
        if len(block) == 4:
            h = ((h << 13 | h >> 19) & mask) * 5 + 0xE6546B64 & mask
    h ^= len(data)
    h = (h ^ h >> 16) * 0x85EBCA6B & mask
    h = (h ^ h >> 13) * 0xC2B2AE35 & mask
    return h ^ h >> 16


def id_of(name: str) -> float:
    """Returns the float that stands for a name: its exponent is limited to 1 to 254."""
    h = hash_of(name)
    exponent = min(max(h >> 23 & 255, 1), 254)
    return struct.unpack("<f", struct.pack("<I", h & 0x807FFFFF | exponent << 23))[0]


def matte(pixels: dict, layer: str, number: float) -> numpy.ndarray:
    """Returns the coverage of an id: the sum over all ranks."""
    total = numpy.zeros_like(pixels["R"], numpy.float32)
    for rank in sorted(name[:-2] for name in pixels if name.startswith(layer) and name.endswith(".R")):
        for identity, coverage in (("R", "G"), ("B", "A")):
            total += numpy.where(pixels[f"{rank}.{identity}"] == numpy.float32(number), pixels[f"{rank}.{coverage}"], 0)
    return total


def plain(value: object) -> object:
    """Returns a header's value as JSON can write it."""
    if isinstance(value, Fraction):
        return [value.numerator, value.denominator]
    if isinstance(value, numpy.ndarray):
        return value.ravel().tolist()
    return list(value) if isinstance(value, tuple) else value


def main(path: str) -> None:
    file = OpenEXR.File(path, separate_channels=True)
    header = file.header()
    pixels = {name: channel.pixels for name, channel in file.channels().items()}
    for color in "RGB":
        total = sum(pixels[f"{layer}.{color}"] for layer in json.loads(header["lightning/sum"]))
        assert total.dtype == numpy.float32 and total.tobytes() == pixels[color].tobytes(), color
    hit = pixels["Z"] < 1e10
    for key in [key for key in header if key.startswith("cryptomatte/") and key.endswith("/name")]:
        layer = header[key]
        manifest = json.loads(header[key[:-4] + "manifest"])
        assert key == f"cryptomatte/{hash_of(layer):08x}"[:19] + "/name", key
        total = numpy.zeros_like(hit, numpy.float32)
        for name, digits in manifest.items():
            number = id_of(name)
            assert struct.pack(">f", number).hex() == digits, name
            mask = matte(pixels, layer, number)
            total += mask
            for names, channel in (("lightning/shapes", "shape.id"), ("lightning/materials", "material.id")):
                if (channel == "shape.id") == (layer == "CryptoObject") and layer != "CryptoAsset":
                    index = json.loads(header[names]).index(name) + 1
                    assert ((mask == 1) == (pixels[channel] == index)).all(), name
        assert (total == hit).all(), layer
    wanted = ("chromaticities", "framesPerSecond", "imageCounter", "worldToCamera", "worldToNDC", "whiteLuminance", "screenWindowWidth",
              "lightning/metersPerUnit")
    print(json.dumps({name: plain(header[name]) for name in wanted if name in header}))


if __name__ == "__main__":
    main(sys.argv[1])
