"""Materials: UsdPreviewSurface, and the constants of MaterialX surfaces."""

from __future__ import annotations

import math
from typing import Any

from arithmetic import Linear, apply, linear
from materialx import CHANNELS, DIRECTIONS, MISSING, NUMBERS, SURFACES, WEIGHTS, as_preview, is_image, is_preview_image, multiply
from meshes import identity
from output import Output, StageError, numbers
from pxr import Sdf, Usd, UsdGeom, UsdShade

# Names of the color spaces in which files are read anyway: sRGB for codes, linear Rec. 709 for floats, and numbers that are no colors.
SPACES = {"", "auto", "raw", "data", "none", "identity", "unknown", "srgb", "srgb_texture", "srgb_rec709_scene", "linear",
          "lin_rec709", "lin_rec709_scene", "lin_srgb"}
PREVIEW = {"diffuseColor": [0.18] * 3, "emissiveColor": [0.0] * 3, "useSpecularWorkflow": 0, "specularColor": [0.0] * 3, "metallic": 0.0,
           "roughness": 0.5, "clearcoat": 0.0, "clearcoatRoughness": 0.01, "opacity": 1.0, "opacityThreshold": 0.0, "ior": 1.5, "normal": None, "displacement": 0.0}


class Materials:
    """All materials of a stage."""

    def __init__(self, out: Output, time: Usd.TimeCode) -> None:
        self.out = out
        self.time = time
        self.all: list[dict[str, Any]] = []
        self.known: dict[Any, int] = {}

    def of(self, prim: Usd.Prim) -> int:
        """Returns the index of the material that is bound to a prim for a final picture; -1 if none can be imported."""
        api = UsdShade.MaterialBindingAPI(prim)
        # A purpose without a binding of its own takes the general one.
        bound = [api.ComputeBoundMaterial(purpose)[0] for purpose in (UsdShade.Tokens.full, UsdShade.Tokens.preview)]
        return self.index(next((material for material in bound if material), bound[0]))

    def subsets(self, prim: Usd.Prim) -> list[dict[str, Any]]:
        """Returns the parts of a mesh with other materials."""
        result = []
        for subset in UsdShade.MaterialBindingAPI(prim).GetMaterialBindSubsets():
            faces = subset.GetIndicesAttr().Get(self.time)
            if faces:
                material = self.of(subset.GetPrim())
                result.append({"name": subset.GetPrim().GetName(), "faces": self.out.array(faces), "material": material})
        return result

    def coordinates(self, material: int) -> str:
        """Returns the name of the texture coordinates that a material uses; empty for the usual ones."""
        return self.all[material].get("coordinates", "") if material >= 0 else ""

    def display(self, prim: Usd.Prim) -> int:
        """Returns the index of a material of the display color; -1 without one."""
        api = UsdGeom.PrimvarsAPI(prim)
        color = api.FindPrimvarWithInheritance("displayColor")
        values = color.Get(self.time) if color and color.HasValue() else None
        if not values:
            return -1
        is_constant = color.GetInterpolation() == "constant"
        rgb = amounts(first(color, values)) if is_constant else [1.0, 1.0, 1.0]
        if len(rgb) != 3:
            self.out.note("display colors of another type")
            return -1
        rgb = self.out.vector(prim, "displayColor", rgb, [1.0] * 3)
        opacity = api.FindPrimvarWithInheritance("displayOpacity")
        alphas = opacity.Get(self.time) if opacity and opacity.HasValue() else None
        if alphas and len(set(alphas)) > 1 and opacity.GetInterpolation() != "constant":
            self.out.note("display opacities that vary over an object, imported as the first")
        alpha = self.out.number(prim, "displayOpacity", first(opacity, alphas), 1.0) if alphas else 1.0
        key = ("display", *rgb, alpha)
        if key not in self.known:
            self.known[key] = len(self.all)
            self.all.append({"name": "display color", "display": rgb, "opacity": alpha})
        return self.known[key]

    def index(self, material: UsdShade.Material) -> int:
        """Returns the index of a material."""
        if not material:
            return -1
        key = identity(material.GetPrim())
        if key not in self.known:
            try:
                self.known[key] = self.add(material)
            except (StageError, MemoryError, OSError):
                raise
            except RecursionError:
                self.out.note_prim(material.GetPrim(), "has too many nodes one after another, imported as gray or in the display color of its objects")
                self.known[key] = -1
            except Exception:  # usd-core raises its own kinds for damaged content
                self.out.note_prim(material.GetPrim(), "has values of another type, imported as gray or in the display color of its objects")
                self.known[key] = -1
        return self.known[key]

    def add(self, material: UsdShade.Material) -> int:
        """Adds a material; returns -1 if its surface is of another kind."""
        for context in ("", "mtlx"):
            shader = material.ComputeSurfaceSource(context)[0] if context else material.ComputeSurfaceSource()[0]
            kind = shader.GetIdAttr().Get() if shader else None
            if kind in ("UsdPreviewSurface", "ND_UsdPreviewSurface_surfaceshader"):
                return self.keep(material, self.preview(shader))
            if kind in SURFACES:
                self.out.note("MaterialX surfaces, without their less common inputs")
                self.note_missing(material, shader)
                return self.keep(material, self.materialx(shader, kind))
        self.out.note("materials without a UsdPreviewSurface, imported as gray or in their display color")
        return -1

    def keep(self, material: UsdShade.Material, surface: dict[str, Any]) -> int:
        """Adds a surface."""
        self.all.append({"name": material.GetPrim().GetName(), **surface})
        return len(self.all) - 1

    def preview(self, shader: UsdShade.Shader) -> dict[str, Any]:
        """Returns a UsdPreviewSurface."""
        result: dict[str, Any] = {"textures": {}}
        for name, fallback in PREVIEW.items():
            self.resolve(shader, name, name, fallback, result)
        mode = shader.GetInput("opacityMode")
        result["presence"] = bool(mode) and mode.Get() == "presence"
        return result

    def materialx(self, shader: UsdShade.Shader, kind: str) -> dict[str, Any]:
        """Returns a MaterialX surface as a UsdPreviewSurface."""
        result: dict[str, Any] = {"textures": {}, "surface": kind.removeprefix("ND_").removesuffix("_surfaceshader")}
        names = SURFACES[kind]
        for target, (name, fallback) in names.items():
            self.resolve(shader, name, target, fallback, result)
        result["isFuzz"] = int("fuzz_weight" in [name for name, _ in names.values()])
        return as_preview(result, self.out)

    def note_missing(self, material: UsdShade.Material, shader: UsdShade.Shader) -> None:
        """Notes properties of a MaterialX surface that no material of a scene has, with the name of the material."""
        for title, (names, neutral) in MISSING.items():
            if any(self.has_effect(shader, name, neutral) for name in names):
                self.out.note_named(f"{title} of materials", material.GetPrim().GetName())

    def has_effect(self, shader: UsdShade.Shader, name: str, neutral: float | None) -> bool:
        """Returns whether an input differs from a value, and whether an input that switches it on does so.

        Args:
            neutral: None for an input whose values say nothing, only nodes
        """
        weights = [weight for weight in WEIGHTS.get(name, ()) if shader.GetInput(weight)]
        return self.differs(shader, name, neutral) and (
            any(self.differs(shader, weight, 0.0) for weight in weights) if weights else neutral is not None)

    def differs(self, shader: UsdShade.Shader, name: str, neutral: float | None) -> bool:
        """Returns whether an input has another value, or nodes that give it one."""
        source = shader.GetInput(name)
        attributes = UsdShade.Utils.GetValueProducingAttributes(source) if source else []
        attribute = self.constant(attributes[0]) if attributes else None
        if attribute and is_output(attribute):
            return not str(UsdShade.Shader(attribute.GetPrim()).GetIdAttr().Get() or "").startswith(DIRECTIONS)
        value = attribute.Get(self.time) if attribute else None
        return value is not None and neutral is not None and any(v != neutral for v in amounts(value))

    def resolve(self, shader: UsdShade.Shader, name: str, target: str, fallback: Any, result: dict[str, Any]) -> None:
        """Adds the value or the texture of an input."""
        result[target] = fallback
        source = shader.GetInput(name)
        attributes = UsdShade.Utils.GetValueProducingAttributes(source) if source else []
        if not attributes:
            return
        attribute = self.constant(attributes[0])
        if is_output(attribute):
            if str(UsdShade.Shader(attribute.GetPrim()).GetIdAttr().Get() or "").startswith(DIRECTIONS):
                return
            texture = self.texture(UsdShade.Shader(attribute.GetPrim()), attribute.GetName().split(":")[-1], target in NUMBERS, result)
            if texture and "fallback" in texture:
                self.out.note("textures that are missing, replaced by their fallback color")
                values = texture["fallback"]
                result[target] = values[:3] if isinstance(fallback, list) else values["rgba".find(texture["channel"][:1])]
            elif texture:
                result["textures"][target] = texture
            else:
                self.out.note("shading networks other than a texture")
            return
        value = attribute.Get(self.time)
        if value is not None and fallback is not None:
            check = self.out.vector if isinstance(fallback, list) else self.out.number
            result[target] = check(shader.GetPrim(), f"inputs:{name}", value, fallback)
        if attribute.ValueMightBeTimeVarying():
            self.out.note_moving("animated inputs of materials", str(attribute.GetPath()))

    def texture(self, shader: UsdShade.Shader, channel: str, is_number: bool, result: dict[str, Any]) -> dict[str, Any] | None:
        """Returns a texture, followed through MaterialX nodes that pass one image on; None for other shaders."""
        factors: list[list[float]] = []
        steps: list[Linear] = []
        strength = 1.0
        for _ in range(8):
            kind = str(shader.GetIdAttr().Get() or "")
            if is_image(kind):
                texture = self.image(shader, channel, result)
                for factor in factors if texture else []:
                    multiply(texture, factor)
                if texture:
                    apply(texture, steps)
                if texture and strength != 1:
                    texture["strength"] = strength
                return texture
            inputs = [shader.GetInput(name) for name in ("in", "in1", "in2", "basecolor") if shader.GetInput(name)]
            sources = [self.constant(found[0]) for found in map(UsdShade.Utils.GetValueProducingAttributes, inputs) if found]
            images = [source for source in sources if is_output(source)]
            if len(images) != 1:
                return None
            step = self.step(shader, kind) if is_number else None
            if step:
                steps.append(step)
            elif kind.startswith("ND_multiply"):
                factors += [amounts(source.Get(self.time)) for source in sources if not is_output(source)]
            elif kind.startswith("ND_extract"):
                channel = "rgba"[min(max(int(self.value(shader, "index", 0)), 0), 3)]
            elif kind.startswith("ND_separate"):
                channel = CHANNELS.get(channel, channel)
            elif kind.startswith("ND_normalmap"):
                strength = float(amounts(self.value(shader, "scale", 1.0))[0])
            else:
                self.out.note("shading nodes between a texture and its surface")
            shader = UsdShade.Shader(images[0].GetPrim())
            if not kind.startswith(("ND_extract", "ND_separate")):
                channel = images[0].GetName().split(":")[-1] if channel in ("out", "rgb") else channel
        return None

    def step(self, shader: UsdShade.Shader, kind: str) -> Linear | None:
        """Returns what a node does to the numbers of an image; None for other nodes."""
        constants = {}
        for source in shader.GetInputs():
            attributes = UsdShade.Utils.GetValueProducingAttributes(source)
            attribute = self.constant(attributes[0]) if attributes else None
            if attribute and not is_output(attribute):
                constants[source.GetBaseName()] = amounts(attribute.Get(self.time))
        return linear(kind, constants)

    def constant(self, attribute: Usd.Attribute) -> Usd.Attribute:
        """Returns the value of a MaterialX constant instead of its output."""
        for _ in range(8):
            shader = UsdShade.Shader(attribute.GetPrim())
            if not is_output(attribute) or not str(shader.GetIdAttr().Get() or "").startswith("ND_constant"):
                break
            sources = UsdShade.Utils.GetValueProducingAttributes(shader.GetInput("value")) if shader.GetInput("value") else []
            if not sources:
                break
            attribute = sources[0]
        return attribute

    def image(self, shader: UsdShade.Shader, channel: str, result: dict[str, Any]) -> dict[str, Any] | None:
        """Returns the file of a texture, with its scale and its place."""
        path = self.value(shader, "file", None)
        if not path or not path.path:
            return None
        kind = str(shader.GetIdAttr().Get() or "")
        texture: dict[str, Any] = {"channel": CHANNELS.get(channel, channel), **self.out.file(path)}
        if "<UDIM>" in path.path:
            texture["tiles"] = self.tiles(shader.GetInput("file"), path)
        missing = self.value(shader, "fallback", None) if is_preview_image(kind) and not texture.keys() & {"place", "tiles"} else None
        if missing is not None:
            texture["fallback"] = self.out.vector(shader.GetPrim(), "inputs:fallback", missing, [0.0, 0.0, 0.0, 1.0])
            return texture
        for name in ("scale", "bias") if is_preview_image(kind) else ():
            value = self.value(shader, name, None)
            if value is not None:
                texture[name] = self.out.vector(shader.GetPrim(), f"inputs:{name}", value, [1.0 if name == "scale" else 0.0] * 4)
        texture["space"] = str(self.value(shader, "sourceColorSpace", "auto"))
        self.note_color_space(shader.GetInput("file"), texture["space"])
        texture["wrap"] = [self.edge(shader, "wrapS", "uaddressmode"), self.edge(shader, "wrapT", "vaddressmode")]
        for name in ("factor", "color", "geomcolor") if kind.startswith("ND_gltf_") else ():
            self.tint(shader, name, texture)
        self.placement(shader, texture, result)
        return texture

    def note_color_space(self, file: UsdShade.Input, space: str) -> None:
        """Notes a color space that the reader of the file does not know by this name."""
        attribute = UsdShade.Utils.GetValueProducingAttributes(file)[0]
        declared = attribute.GetColorSpace() if attribute.HasColorSpace() else space
        if declared.lower() not in SPACES:
            self.out.note(f"textures in the color space {declared}, read as their files say")

    def tint(self, shader: UsdShade.Shader, name: str, texture: dict[str, Any]) -> None:
        """Multiplies a texture by an input of its own node."""
        source = shader.GetInput(name)
        attributes = UsdShade.Utils.GetValueProducingAttributes(source) if source else []
        attribute = self.constant(attributes[0]) if attributes else None
        if attribute and is_output(attribute):
            self.out.note("colors of vertices or nodes that multiply a texture, left out")
        elif attribute and attribute.Get(self.time) is not None:
            multiply(texture, amounts(attribute.Get(self.time)))

    def edge(self, shader: UsdShade.Shader, *names: str) -> str:
        """Returns what follows the edges of a texture along an axis."""
        modes = [str(mode) for mode in (self.value(shader, name, None) for name in names) if mode]
        mode = modes[0] if modes else "repeat"
        if mode in ("black", "constant"):
            self.out.note("textures that are black beyond their edges, whose edge pixels go on")
        return {"black": "clamp", "constant": "clamp", "clamp": "clamp", "mirror": "mirror"}.get(mode, "repeat")

    def tiles(self, source: UsdShade.Input, path: Sdf.AssetPath) -> list[dict[str, Any]]:
        """Returns the existing files of a texture of several tiles."""
        attribute = UsdShade.Utils.GetValueProducingAttributes(source)[0]
        layers = [spec.layer for spec in attribute.GetPropertyStack(self.time) if spec.HasDefaultValue()]
        found = UsdShade.UdimUtils.ResolveUdimTilePaths(path.path, layers[0]) if layers else []
        return [{"tile": int(tile), **self.out.file(Sdf.AssetPath(place, place))} for place, tile in found]

    def placement(self, shader: UsdShade.Shader, texture: dict[str, Any], result: dict[str, Any]) -> None:
        """Adds where a texture is on its surface, and the name of its coordinates."""
        tiling = self.value(shader, "uvtiling", None)
        if tiling is not None:
            tiling = self.out.vector(shader.GetPrim(), "inputs:uvtiling", tiling, [1.0, 1.0])
            shift = self.out.vector(shader.GetPrim(), "inputs:uvoffset", self.value(shader, "uvoffset", (0, 0)), [0.0, 0.0])
            place(texture, tiling, 0.0, [-v for v in shift])
        if str(shader.GetIdAttr().Get() or "").startswith("ND_gltf_"):
            self.place_gltf(shader, texture)
        for _ in range(4):
            source = shader.GetInput("st") or shader.GetInput("in") or shader.GetInput("texcoord")
            attributes = UsdShade.Utils.GetValueProducingAttributes(source) if source else []
            if not attributes:
                return
            shader = UsdShade.Shader(attributes[0].GetPrim())
            if not shader:
                return
            kind = str(shader.GetIdAttr().Get() or "")
            if kind == "UsdTransform2d":
                self.transform(shader, texture)
            elif kind.startswith("ND_place2d"):
                self.place2d(shader, texture)
            elif kind.startswith(("UsdPrimvarReader", "ND_UsdPrimvarReader", "ND_geompropvalue")):
                result["coordinates"] = str(self.value(shader, "geomprop" if "geomprop" in kind else "varname", "st"))
                return

    def transform(self, shader: UsdShade.Shader, texture: dict[str, Any]) -> None:
        """Adds a UsdTransform2d: a scale, then a rotation and a translation."""
        prim = shader.GetPrim()
        scale = self.out.vector(prim, "inputs:scale", self.value(shader, "scale", (1, 1)), [1.0, 1.0])
        angle = self.out.number(prim, "inputs:rotation", self.value(shader, "rotation", 0.0), 0.0)
        shift = self.out.vector(prim, "inputs:translation", self.value(shader, "translation", (0, 0)), [0.0, 0.0])
        place(texture, scale, angle, shift)

    def place2d(self, shader: UsdShade.Shader, texture: dict[str, Any]) -> None:
        """Adds a place2d node of MaterialX, which moves, turns and scales an image, not its coordinates."""
        prim = shader.GetPrim()
        sizes = self.out.vector(prim, "inputs:scale", self.value(shader, "scale", (1, 1)), [1.0, 1.0])
        angle = self.out.number(prim, "inputs:rotate", self.value(shader, "rotate", 0.0), 0.0)
        shift = self.out.vector(prim, "inputs:offset", self.value(shader, "offset", (0, 0)), [0.0, 0.0])
        pivot = self.out.vector(prim, "inputs:pivot", self.value(shader, "pivot", (0, 0)), [0.0, 0.0])
        self.move(texture, [1 / size if size else 1.0 for size in sizes], angle, shift, pivot, self.value(shader, "operationorder", 0))

    def place_gltf(self, shader: UsdShade.Shader, texture: dict[str, Any]) -> None:
        """Adds the transform of an image node of glTF, which moves, turns and scales coordinates with v downwards."""
        prim = shader.GetPrim()
        kind = str(shader.GetIdAttr().Get())
        scale = self.out.vector(prim, "inputs:scale", self.value(shader, "scale", (1, 1)), [1.0, 1.0])
        angle = self.out.number(prim, "inputs:rotate", self.value(shader, "rotate", 0.0), 0.0)
        shift = self.out.vector(prim, "inputs:offset", self.value(shader, "offset", (0, 0)), [0.0, 0.0])
        pivot = self.out.vector(prim, "inputs:pivot", self.value(shader, "pivot", (0, 1)), [0.0, 1.0])
        # The definition of gltf_colorimage ignores its own order.
        order = 0 if kind.startswith("ND_gltf_colorimage") else self.value(shader, "operationorder", 1 if "_color4" in kind else 0)
        self.move(texture, scale, -angle, [-shift[0], shift[1]], pivot, order)

    def move(self, texture: dict[str, Any], scale: list[float], angle: float, shift: list[float], pivot: list[float], order: int) -> None:
        """Scales coordinates about a pivot, turns them back by an angle and subtracts a shift; in order 1 the other way round."""
        if order == 0:
            turned = rotated([-scale[0] * pivot[0], -scale[1] * pivot[1]], -angle)
            place(texture, scale, -angle, [t + p - s for t, p, s in zip(turned, pivot, shift)])
        elif angle and scale[0] != scale[1]:
            self.out.note("textures that are turned before an uneven scale, imported without either")
        else:
            turned = rotated([-pivot[0] - shift[0], -pivot[1] - shift[1]], -angle)
            place(texture, scale, -angle, [s * t + p for s, t, p in zip(scale, turned, pivot)])

    def value(self, shader: UsdShade.Shader, name: str, fallback: Any) -> Any:
        """Returns the value of an input, also one that the material passes on."""
        source = shader.GetInput(name)
        attributes = UsdShade.Utils.GetValueProducingAttributes(source) if source else []
        found = attributes[0].Get(self.time) if attributes else None
        return fallback if found is None else found


def place(texture: dict[str, Any], scale: list[float], angle: float, shift: list[float]) -> None:
    """Applies a scale, a rotation in degrees and a translation to the coordinates of a texture, before its own."""
    (a, d), (b, e) = rotated([scale[0], 0.0], angle), rotated([0.0, scale[1]], angle)
    p = texture.get("placement", [1.0, 0.0, 0.0, 0.0, 1.0, 0.0])
    texture["placement"] = [p[0] * a + p[1] * d, p[0] * b + p[1] * e, p[0] * shift[0] + p[1] * shift[1] + p[2],
                            p[3] * a + p[4] * d, p[3] * b + p[4] * e, p[3] * shift[0] + p[4] * shift[1] + p[5]]


def rotated(vector: list[float], angle: float) -> list[float]:
    """Returns a vector turned by an angle in degrees, from u to v."""
    cosine, sine = math.cos(math.radians(angle)), math.sin(math.radians(angle))
    return [cosine * vector[0] - sine * vector[1], sine * vector[0] + cosine * vector[1]]


def is_output(attribute: Usd.Attribute) -> bool:
    """Returns whether an attribute is the output of a shader, not a value."""
    return UsdShade.Utils.GetType(attribute.GetName()) == UsdShade.AttributeType.Output


def first(primvar: UsdGeom.Primvar, values: Any) -> Any:
    """Returns the first value of a primvar, by its indices if it has some."""
    indices = primvar.GetIndices() if primvar.IsIndexed() else None
    index = indices[0] if indices else 0
    return values[index] if 0 <= index < len(values) else values[0]


def amounts(value: Any) -> list[float]:
    """Returns the numbers of a value; 1 for one of another type or without end."""
    try:
        found = numbers(value) if hasattr(value, "__len__") else [float(value)]
        return [number if math.isfinite(number) else 1.0 for number in found]
    except (TypeError, ValueError):
        return [1.0]
