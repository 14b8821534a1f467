# SPDX-License-Identifier: Apache-2.0
"""Materials with one Principled BSDF in place of other shaders, since Blender's glTF exporter writes only that."""

from . import links, shaders
from .lobes import BLACK, WHITE, Lobes, add, mean, mix, times


def of_material(material, lost: dict):
    """Returns a copy of a material with the equal Principled BSDF; None if it can be exported as it is.

    Args:
        lost: receives what the copy does not show, by the name of the material
    """
    if material is None or material.node_tree is None:
        return None
    kinds = shaders.of_surface(material)
    if not kinds or shaders.is_exported(kinds):
        return None
    copy = material.copy()
    reader = _Reader(copy.node_tree)
    output = copy.node_tree.get_output_node("ALL") or copy.node_tree.get_output_node("CYCLES")
    _build(copy.node_tree, output, reader.surface(output.inputs["Surface"], ()))
    if reader.lost:
        lost[material.name] = ", ".join(reader.lost)
    return copy


class _Reader:
    """Reads the shaders of a tree. Groups are followed; a path of group nodes says where a socket is."""

    def __init__(self, tree) -> None:
        self.tree = tree
        # What cannot be shown; a dict keeps the order.
        self.lost: dict[str, None] = {}

    def surface(self, socket, path: tuple, depth: int = 0) -> Lobes:
        """Returns what the shader that is linked to a socket reflects."""
        source, path = links.source(socket, path)
        if source is None or depth > links.DEPTH:
            return Lobes(opacity=1.0)
        node = source.node
        kind = node.bl_idname
        if kind in ("ShaderNodeMixShader", "ShaderNodeAddShader"):
            inputs = [s for s in node.inputs if s.type == "SHADER"]
            first, second = (self.surface(s, path, depth + 1) for s in inputs)
            self._unlink_metal(first, second)
            return add(first, second) if kind == "ShaderNodeAddShader" else self._mixed(node.inputs[0], first, second, path)
        read = _READERS.get(kind)
        if read is not None:
            return read(self, node, path)
        self._lose(node.bl_label)
        return self._diffuse(node, path) if "Color" in node.inputs else Lobes(diffuse=(0.8, 0.8, 0.8))

    def _mixed(self, factor, first: Lobes, second: Lobes, path: tuple) -> Lobes:
        source, _ = links.source(factor, path)
        kind = source.node.bl_idname if source is not None else ""
        index = self._fresnel_index(source, path)
        if index is not None:
            return self._layered(first, second, index)
        if kind == "ShaderNodeTexImage" and 0 == first.opacity < second.opacity and not path:
            # A picture cuts the second shader out.
            second.links["Alpha"] = (source, 1.0)
            return second
        share = self._number(factor, path)
        return mix(first, second, 0.5 if share is None else min(max(share, 0.0), 1.0))

    def _unlink_metal(self, first: Lobes, second: Lobes) -> None:
        """Leaves metalness by nodes out of mixed bodies, which have a single metalness."""
        if mean(first.body()) > 0 and mean(second.body()) > 0:
            for lobes in (first, second):
                if lobes.links.pop("Metallic", None) is not None:
                    self._lose("nodes for Metallic")

    def _fresnel_index(self, source, path: tuple) -> float | None:
        """Returns the index of refraction of a factor that grows to grazing angles; None for other factors."""
        node = source.node if source is not None else None
        if node is not None and node.bl_idname == "ShaderNodeFresnel":
            return max(1.0, self._number(node.inputs["IOR"], path) or 1.5)
        if node is not None and node.bl_idname == "ShaderNodeLayerWeight":
            blend = self._number(node.inputs["Blend"], path)
            if source.name == "Facing":
                self._lose("Facing of a Layer Weight node, sent as Fresnel")
            return 1 / max(1 - (0.5 if blend is None else blend), 1e-3)
        return None

    def _layered(self, first: Lobes, second: Lobes, index: float) -> Lobes:
        """Returns a surface below a reflection that grows to grazing angles."""
        f0 = ((index - 1) / (index + 1)) ** 2
        if mean(second.metal) == 0:
            self._lose("mix by angle of shaders without reflection")
            return mix(first, second, f0)
        if first.shine() == 0 and first.coat == 0 and first.opacity > 0:
            result = mix(first, Lobes(), 0.0)
            result.f0, result.roughness = times(second.metal, f0), second.roughness
            result.links.update({name: link for name, link in second.links.items() if name == "Roughness" or name not in result.links
                                 and name == "Normal"})
            return result
        if mean(first.transmitted) > 0 and first.opacity == 1:
            # Glass of its parts: it reflects by itself.
            return first
        result = mix(first, Lobes(), 0.0)
        result.opacity = first.opacity + (1 - first.opacity) * f0
        result.coat, result.coat_roughness, result.coat_index = max(result.coat, min(1.0, mean(second.metal))), second.roughness, index
        if max(second.metal) - min(second.metal) > 1e-3:
            self._lose("color of a reflection over another")
        return result

    def _diffuse(self, node, path: tuple) -> Lobes:
        return self._linked(node, path, Lobes(diffuse=self._color(node.inputs["Color"], path)), {"Color": "Base Color"})

    def _glossy(self, node, path: tuple) -> Lobes:
        name = "Base Color" if "Base Color" in node.inputs else "Color"
        strength, turns = self._number(node.inputs["Anisotropy"], path) or 0.0, self._number(node.inputs["Rotation"], path) or 0.0
        if name == "Color":
            # This node's widths are alpha * (1 - a) along the tangent and alpha / (1 - a) across it, or the other way round below 0.
            turns = (turns + 0.25) % 1 if strength > 0 else turns
            strength = min((1 - (1 - min(abs(strength), 0.99)) ** 2) / 0.9, 1.0)
        lobes = Lobes(metal=self._color(node.inputs[name], path), roughness=self._share(node, "Roughness", path), anisotropy=min(max(strength, 0.0), 1.0),
                      anisotropy_rotation=turns)
        return self._linked(node, path, lobes, {name: "Base Color", "Roughness": "Roughness"})

    def _glass(self, node, path: tuple) -> Lobes:
        index = self._number(node.inputs["IOR"], path) or 1.5
        if node.bl_idname == "ShaderNodeBsdfRefraction":
            self._lose("Refraction BSDF, which reflects as glass here")
        f0 = ((index - 1) / (index + 1)) ** 2
        return self._linked(node, path, Lobes(transmitted=self._color(node.inputs["Color"], path), roughness=self._share(node, "Roughness", path), index=index,
                                              f0=times(WHITE, f0)), {"Roughness": "Roughness"})

    def _transparent(self, node, path: tuple) -> Lobes:
        if tuple(self._color(node.inputs["Color"], path)) != WHITE:
            self._lose("color of a Transparent BSDF")
        return Lobes(opacity=0.0)

    def _emission(self, node, path: tuple) -> Lobes:
        strength = self._number(node.inputs["Strength"], path)
        result = Lobes(emitted=times(self._color(node.inputs["Color"], path), 1.0 if strength is None else max(strength, 0.0)))
        return self._linked(node, path, result, {"Color": "Emission Color"})

    def _scattering(self, node, path: tuple) -> Lobes:
        self._lose(f"{node.bl_label}, sent as diffuse")
        return self._diffuse(node, path)

    def _sheen(self, node, path: tuple) -> Lobes:
        if node.distribution != "MICROFIBER":
            self._lose("distribution of a Sheen BSDF, sent as microfiber")
        return self._linked(node, path, Lobes(sheen=self._color(node.inputs["Color"], path), sheen_roughness=self._share(node, "Roughness", path)), {})

    def _principled(self, node, path: tuple) -> Lobes:
        value = {socket.name: socket for socket in node.inputs}
        for name, title in shaders.MISSING.items():
            if self._number(value[name], path) != 0:
                self._lose(title)
        color, metallic = self._color(value["Base Color"], path), self._share(node, "Metallic", path)
        through = self._share(node, "Transmission Weight", path) * (1 - metallic)
        index, level = self._number(value["IOR"], path) or 1.5, self._number(value["Specular IOR Level"], path)
        f0 = min(1.0, 2 * (0.5 if level is None else level) * ((index - 1) / (index + 1)) ** 2) * (1 - metallic)
        glow = self._number(value["Emission Strength"], path)
        result = Lobes(times(color, (1 - metallic) - through), times(color, metallic), times(color, through),
                       times(self._color(value["Emission Color"], path), 1.0 if glow is None else max(glow, 0.0)),
                       times(self._color(value["Specular Tint"], path), f0), self._share(node, "Alpha", path), self._share(node, "Roughness", path), index,
                       self._share(node, "Coat Weight", path), self._share(node, "Coat Roughness", path), self._number(value["Coat IOR"], path) or 1.5,
                       times(self._color(value["Sheen Tint"], path), self._share(node, "Sheen Weight", path)), self._share(node, "Sheen Roughness", path),
                       self._share(node, "Anisotropic", path), self._number(value["Anisotropic Rotation"], path) or 0.0)
        return self._linked(node, path, result, {name: name for name in ("Base Color", "Metallic", "Roughness", "Alpha", "Emission Color")})

    def _linked(self, node, path: tuple, lobes: Lobes, names: dict[str, str]) -> Lobes:
        """Adds links of sockets whose values are not constant."""
        for name, target in [*names.items(), ("Normal", "Normal")]:
            source, place = links.source(node.inputs[name], path) if name in node.inputs else (None, ())
            if source is not None and source.node.bl_idname not in links.CONSTANTS:
                if place:
                    self._lose("textures in node groups")
                else:
                    lobes.links[target] = (source, 1.0)
        return lobes

    def _share(self, node, name: str, path: tuple) -> float:
        value = self._number(node.inputs[name], path)
        return min(max(0.5 if value is None else value, 0.0), 1.0)

    def _color(self, socket, path: tuple) -> tuple:
        value = self._constant(socket, path)
        return (0.5, 0.5, 0.5) if value is None else tuple(max(c, 0.0) for c in value[:3])

    def _number(self, socket, path: tuple) -> float | None:
        """Returns the value of a socket; None, and a note, if nodes compute it."""
        value = self._constant(socket, path)
        if value is None:
            if socket.name not in ("Metallic", "Roughness", "Alpha"):
                self._lose(f"nodes for {socket.name}")
            return None
        return mean(value[:3]) if hasattr(value, "__len__") else value

    def _constant(self, socket, path: tuple):
        source, _ = links.source(socket, path)
        if source is None:
            socket = links.outermost(socket, path)
            return socket.default_value
        return source.default_value if source.node.bl_idname in links.CONSTANTS else None

    def _lose(self, title: str) -> None:
        self.lost[title] = None


_READERS = {
    "ShaderNodeBsdfDiffuse": _Reader._diffuse, "ShaderNodeBsdfAnisotropic": _Reader._glossy, "ShaderNodeBsdfGlossy": _Reader._glossy,
    "ShaderNodeBsdfMetallic": _Reader._glossy, "ShaderNodeBsdfGlass": _Reader._glass, "ShaderNodeBsdfRefraction": _Reader._glass,
    "ShaderNodeBsdfTransparent": _Reader._transparent, "ShaderNodeEmission": _Reader._emission, "ShaderNodeBsdfPrincipled": _Reader._principled,
    "ShaderNodeBsdfTranslucent": _Reader._scattering, "ShaderNodeSubsurfaceScattering": _Reader._scattering,
    "ShaderNodeBsdfSheen": _Reader._sheen, "ShaderNodeBsdfToon": _Reader._scattering,
}


def _build(tree, output, lobes: Lobes) -> None:
    """Links a Principled BSDF to the output of a tree."""
    node = tree.nodes.new("ShaderNodeBsdfPrincipled")
    color, opacity = lobes.body(), max(lobes.opacity, 1e-3)
    # Each shader has its share of the surface that is left.
    color = tuple(min(c / opacity, 1.0) for c in color)
    f0 = times(lobes.f0, 1 / opacity)
    metallic = mean(lobes.metal) / mean(lobes.body()) if mean(lobes.body()) > 0 else 0.0
    nonmetal = mean(lobes.diffuse) + mean(lobes.transmitted)
    f0 = tuple(min(c / max(1 - metallic, 1e-3), 1.0) for c in f0) if metallic < 1 else BLACK
    strength, sheen = max(1.0, *lobes.emitted), min(1.0, max(lobes.sheen) / opacity)
    glass = ((lobes.index - 1) / (lobes.index + 1)) ** 2
    level = max(f0) / (2 * glass) if glass > 0 else 0.0
    values = {
        "Base Color": (*color, 1), "Metallic": metallic, "Roughness": lobes.roughness, "IOR": lobes.index, "Alpha": lobes.opacity,
        "Transmission Weight": mean(lobes.transmitted) / nonmetal if nonmetal > 0 else 0.0,
        # A level above 1 would be limited.
        "Specular IOR Level": min(level, 1.0), "Specular Tint": (*times(f0, max(level, 1.0) / max(f0)), 1) if max(f0) > 0 else (1, 1, 1, 1),
        "Coat Weight": lobes.coat, "Coat Roughness": lobes.coat_roughness, "Coat IOR": lobes.coat_index,
        "Sheen Weight": sheen, "Sheen Tint": (*times(lobes.sheen, 1 / max(lobes.sheen)), 1) if sheen > 0 else (1, 1, 1, 1),
        "Sheen Roughness": lobes.sheen_roughness, "Anisotropic": lobes.anisotropy, "Anisotropic Rotation": lobes.anisotropy_rotation,
        "Emission Color": (*times(lobes.emitted, 1 / strength), 1), "Emission Strength": strength if any(lobes.emitted) else 0.0,
    }
    for name, value in values.items():
        node.inputs[name].default_value = value
    for name, (socket, _) in lobes.links.items():
        tree.links.new(socket, node.inputs[name])
    tree.links.new(node.outputs[0], output.inputs["Surface"])
    for other in [n for n in tree.nodes if n != node and any(socket.type == "SHADER" for socket in n.outputs)]:
        tree.nodes.remove(other)
