"""Materials: UsdPreviewSurface, and the constants of MaterialX surfaces."""

from __future__ import annotations

from typing import Any

from meshes import identity
from output import Output, numbers
from pxr import Sdf, Usd, UsdGeom, UsdShade

PREVIEW = {"diffuseColor": [0.18] * 3, "emissiveColor": [0.0] * 3, "useSpecularWorkflow": 0, "specularColor": [0.0] * 3, "metallic": 0.0,
           "roughness": 0.5, "clearcoat": 0.0, "opacity": 1.0, "opacityThreshold": 0.0, "ior": 1.5, "normal": None, "displacement": 0.0}
STANDARD = {"diffuseColor": ("base_color", [0.8] * 3), "metallic": ("metalness", 0.0), "roughness": ("specular_roughness", 0.2),
            "ior": ("specular_IOR", 1.5), "emissiveColor": ("emission_color", [1.0] * 3), "emission": ("emission", 0.0),
            "transmission": ("transmission", 0.0), "weight": ("base", 1.0)}
OPEN_PBR = {"diffuseColor": ("base_color", [0.8] * 3), "metallic": ("base_metalness", 0.0), "roughness": ("specular_roughness", 0.3),
            "ior": ("specular_ior", 1.5), "emissiveColor": ("emission_color", [1.0] * 3), "emission": ("emission_luminance", 0.0),
            "transmission": ("transmission_weight", 0.0), "weight": ("base_weight", 1.0)}
MATERIALX = {"ND_standard_surface_surfaceshader": STANDARD, "ND_open_pbr_surface_surfaceshader": OPEN_PBR}


class Materials:
    """All materials of a stage."""

    def __init__(self, out: Output, time: Usd.TimeCode) -> None:
        self.out = out
        self.time = time
        self.all: list[dict[str, Any]] = []
        self.known: dict[Any, int] = {}

    def of(self, prim: Usd.Prim) -> int:
        """Returns the index of the material that is bound to a prim; -1 if none can be imported."""
        return self.index(UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0])

    def subsets(self, prim: Usd.Prim) -> list[dict[str, Any]]:
        """Returns the parts of a mesh with other materials."""
        result = []
        for subset in UsdShade.MaterialBindingAPI(prim).GetMaterialBindSubsets():
            faces = subset.GetIndicesAttr().Get(self.time)
            if faces:
                result.append({"name": subset.GetPrim().GetName(), "faces": self.out.array(faces), "material": self.of(subset.GetPrim())})
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
        rgb = numbers(values[0]) if is_constant else [1.0, 1.0, 1.0]
        opacity = api.FindPrimvarWithInheritance("displayOpacity")
        alphas = opacity.Get(self.time) if opacity and opacity.HasValue() else None
        key = ("display", *rgb, alphas[0] if alphas else 1.0)
        if key not in self.known:
            self.known[key] = len(self.all)
            self.all.append({"name": "display color", "display": rgb, "opacity": float(alphas[0]) if alphas else 1.0})
        return self.known[key]

    def index(self, material: UsdShade.Material) -> int:
        """Returns the index of a material."""
        if not material:
            return -1
        key = identity(material.GetPrim())
        if key not in self.known:
            self.known[key] = self.add(material)
        return self.known[key]

    def add(self, material: UsdShade.Material) -> int:
        """Adds a material; returns -1 if its surface is of another kind."""
        for context in ("", "mtlx"):
            shader = material.ComputeSurfaceSource(context)[0] if context else material.ComputeSurfaceSource()[0]
            kind = shader.GetIdAttr().Get() if shader else None
            if kind in ("UsdPreviewSurface", "ND_UsdPreviewSurface_surfaceshader"):
                return self.keep(material, self.preview(shader))
            if kind in MATERIALX:
                self.out.note("MaterialX surfaces, without their less common inputs")
                return self.keep(material, self.materialx(shader, MATERIALX[kind]))
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

    def materialx(self, shader: UsdShade.Shader, names: dict[str, tuple[str, Any]]) -> dict[str, Any]:
        """Returns a MaterialX surface as a UsdPreviewSurface."""
        result: dict[str, Any] = {"textures": {}}
        for target, (name, fallback) in names.items():
            self.resolve(shader, name, target, fallback, result)
        emission, weight = result.pop("emission"), result.pop("weight")
        result["emissiveColor"] = [v * emission for v in result["emissiveColor"]]
        result["diffuseColor"] = [v * weight for v in result["diffuseColor"]]
        return result

    def resolve(self, shader: UsdShade.Shader, name: str, target: str, fallback: Any, result: dict[str, Any]) -> None:
        """Adds the value or the texture of an input."""
        result[target] = fallback
        source = shader.GetInput(name)
        attributes = UsdShade.Utils.GetValueProducingAttributes(source) if source else []
        if not attributes:
            return
        attribute = attributes[0]
        if UsdShade.Utils.GetType(attribute.GetName()) == UsdShade.AttributeType.Output:
            texture = self.texture(UsdShade.Shader(attribute.GetPrim()), attribute.GetName().split(":")[-1], result)
            if texture:
                result["textures"][target] = texture
            else:
                self.out.note("shading networks other than a texture")
            return
        value = attribute.Get(self.time)
        if value is not None and fallback is not None:
            try:
                result[target] = numbers(value) if isinstance(fallback, list) else float(value)
            except (TypeError, ValueError):
                self.out.note("inputs of materials of another type")
        if attribute.ValueMightBeTimeVarying():
            self.out.note("animated inputs of materials, at the first frame")

    def texture(self, shader: UsdShade.Shader, channel: str, result: dict[str, Any]) -> dict[str, Any] | None:
        """Returns a texture, followed through MaterialX nodes that pass one image on; None for other shaders."""
        for _ in range(8):
            kind = str(shader.GetIdAttr().Get() or "")
            if kind == "UsdUVTexture" or kind.startswith(("ND_image_", "ND_tiledimage_", "ND_UsdUVTexture")):
                return self.image(shader, channel, result)
            inputs = [shader.GetInput(name) for name in ("in", "in1", "basecolor") if shader.GetInput(name)]
            sources = UsdShade.Utils.GetValueProducingAttributes(inputs[0]) if inputs else []
            if not sources or UsdShade.Utils.GetType(sources[0].GetName()) != UsdShade.AttributeType.Output:
                return None
            shader = UsdShade.Shader(sources[0].GetPrim())
            if not kind.startswith("ND_normalmap"):
                self.out.note("shading nodes between a texture and its surface")
        return None

    def image(self, shader: UsdShade.Shader, channel: str, result: dict[str, Any]) -> dict[str, Any] | None:
        """Returns the file of a texture, with its scale and its place."""
        path = self.value(shader, "file", None)
        if not path or not path.path:
            return None
        texture: dict[str, Any] = {"channel": channel, **self.out.file(path)}
        if "<UDIM>" in path.path:
            texture["tiles"] = self.tiles(shader.GetInput("file"), path)
        for name in ("scale", "bias"):
            value = self.value(shader, name, None)
            if value is not None:
                texture[name] = numbers(value)
        if any(self.value(shader, "wrap" + axis, "repeat") not in ("repeat", "useMetadata") for axis in "ST"):
            self.out.note("textures that do not repeat, imported as repeating")
        self.placement(shader, texture, result)
        return texture

    def tiles(self, source: UsdShade.Input, path: Sdf.AssetPath) -> list[dict[str, Any]]:
        """Returns the existing files of a texture of several tiles."""
        attribute = UsdShade.Utils.GetValueProducingAttributes(source)[0]
        layers = [spec.layer for spec in attribute.GetPropertyStack(self.time) if spec.HasDefaultValue()]
        found = UsdShade.UdimUtils.ResolveUdimTilePaths(path.path, layers[0]) if layers else []
        return [{"tile": int(tile), **self.out.file(Sdf.AssetPath(place, place))} for place, tile in found]

    def placement(self, shader: UsdShade.Shader, texture: dict[str, Any], result: dict[str, Any]) -> None:
        """Adds how often a texture repeats, and the name of its coordinates."""
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
                scale = self.value(shader, "scale", (1, 1))
                texture["repeat"] = numbers(scale)
                if self.value(shader, "rotation", 0.0) or any(self.value(shader, "translation", (0, 0))):
                    self.out.note("rotations and translations of textures")
            elif kind.startswith("UsdPrimvarReader"):
                result["coordinates"] = str(self.value(shader, "varname", "st"))
                return

    def value(self, shader: UsdShade.Shader, name: str, fallback: Any) -> Any:
        """Returns the value of an input, also one that the material passes on."""
        source = shader.GetInput(name)
        attributes = UsdShade.Utils.GetValueProducingAttributes(source) if source else []
        found = attributes[0].Get(self.time) if attributes else None
        return fallback if found is None else found
