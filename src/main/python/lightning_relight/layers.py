"""Layers of a picture as numpy arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Dict, List

if TYPE_CHECKING:
    import numpy


@dataclass(frozen=True)
class Layers:
    """Picture with its layers. Colors are ``float32[height, width, 3]``, linear.

    Attributes:
        picture: the picture, which is the sum of all color layers in every bit: see ``total``
        diffuse: direct diffuse light of each light, without mirrors; ``"environment"`` too
        specular: direct highlights of each light, without mirrors
        gathered: indirect light of each light, and what rough surfaces reflect of it; of ``"environment"`` all gathered light
        reflections: what mirrors and glass show of each light
        fog: light of each light in the fog
        others: all other color layers, such as ``"ambient"``, ``"indirect"`` (of glow and a background), ``"reflections"`` (of all
            but the lights) and ``"rounding"``
        order: names of all color layers in the order of the sum, as in an .exr with layers
        normals: ``float32[height, width, 3]``, 0 where the ray hits nothing
        positions: ``float32[height, width, 3]`` in the scene
        albedo: ``float32[height, width, 3]``: colors of surfaces without light, at most 1
        depth: ``float32[height, width]`` along the view; 1e10 where the ray hits nothing
        object_ids: ``int32[height, width]``: 1 is the first of ``objects``; 0 where the ray hits nothing
        material_ids: ``int32[height, width]``: 1 is the first of ``materials``
        objects: names of all objects
        materials: names of all materials
    """

    picture: "numpy.ndarray"
    diffuse: Dict[str, "numpy.ndarray"]
    specular: Dict[str, "numpy.ndarray"]
    gathered: Dict[str, "numpy.ndarray"]
    reflections: Dict[str, "numpy.ndarray"]
    fog: Dict[str, "numpy.ndarray"]
    others: Dict[str, "numpy.ndarray"]
    order: List[str]
    normals: "numpy.ndarray"
    positions: "numpy.ndarray"
    albedo: "numpy.ndarray"
    depth: "numpy.ndarray"
    object_ids: "numpy.ndarray"
    material_ids: "numpy.ndarray"
    objects: List[str]
    materials: List[str]
    _colors: Dict[str, "numpy.ndarray"]

    def light(self, name: str) -> "numpy.ndarray":
        """Returns all light of one light; ``"environment"`` too. KeyError if it has no layer: it is off, or there is none."""
        parts = [part[name] for part in (self.diffuse, self.specular, self.gathered, self.reflections, self.fog) if name in part]
        if not parts:
            raise KeyError(name)
        return sum(parts[1:], parts[0])

    def total(self) -> "numpy.ndarray":
        """Returns the sum of all color layers in their order: the picture in every bit."""
        import numpy

        total = numpy.zeros_like(self.picture)
        for name in self.order:
            total += self._colors[name]
        return total


def of(memory: Dict[str, Any], planes: "numpy.ndarray") -> Layers:
    """Returns the layers in an answer of the server; ``planes`` is ``float32[channels, height, width]``, and is copied."""
    import numpy

    index = {name: i for i, name in enumerate(memory["channels"])}

    def joined(prefix: str, parts: str) -> "numpy.ndarray":
        return numpy.stack([planes[index[prefix + part]] for part in parts], axis=-1)

    colors = {name: joined(name + ".", "RGB") for name in memory["sum"]}
    lights: Dict[str, str] = memory["lights"]
    parts: Dict[str, Dict[str, "numpy.ndarray"]] = {kind: {} for kind in ("diffuse", "specular", "gathered", "reflections", "fog")}
    others = {}
    for name, color in colors.items():
        if name in lights:
            kind = name.rpartition("_")[2]
            parts[kind if kind in parts else "gathered"][lights[name]] = color
        else:
            others[name] = color
    return Layers(
        picture=joined("", "RGB"),
        **parts,
        others=others,
        order=memory["sum"],
        normals=joined("N.", "XYZ"),
        positions=joined("P.", "XYZ"),
        albedo=joined("albedo.", "RGB"),
        depth=planes[index["Z"]].copy(),
        object_ids=planes[index["shape.id"]].astype(numpy.int32),
        material_ids=planes[index["material.id"]].astype(numpy.int32),
        objects=memory["shapes"],
        materials=memory["materials"],
        _colors=colors,
    )
