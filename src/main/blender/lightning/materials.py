# SPDX-License-Identifier: Apache-2.0
"""What Blender's glTF exporter leaves out of glass and reflections, by glTF's own extensions."""

import math

import bpy
import numpy

from . import model


def add_glass(root: dict, shapes: list, messages: list[str]) -> None:
    """Adds volumes, absorption and Glass BSDFs to the materials of a glTF file, which show a snapshot's shapes."""
    open_meshes = _open_materials(shapes)
    for entry in root.get("materials", []):
        material = bpy.data.materials.get(entry.get("name", ""))
        if material is None or material.node_tree is None:
            continue
        surface = linked(material, "Surface")
        extensions = entry.setdefault("extensions", {})
        if surface is not None and surface.bl_idname in ("ShaderNodeBsdfGlass", "ShaderNodeBsdfRefraction"):
            color = list(surface.inputs["Color"].default_value[:3])
            entry["pbrMetallicRoughness"] = {"baseColorFactor": color + [1], "metallicFactor": 0,
                                             "roughnessFactor": surface.inputs["Roughness"].default_value}
            extensions["KHR_materials_transmission"] = {"transmissionFactor": 1}
            extensions["KHR_materials_ior"] = {"ior": surface.inputs["IOR"].default_value}
        if "KHR_materials_transmission" in extensions:
            volume = extensions.setdefault("KHR_materials_volume", {})
            if material.name in open_meshes:
                messages.append(f"{material.name}: the glass of an open mesh became a thin sheet")
            else:
                volume["thicknessFactor"] = volume.get("thicknessFactor") or 1
                factors = entry.get("pbrMetallicRoughness", {})
                if surface is not None and surface == model.principled(material) and "baseColorFactor" in factors:
                    factors["baseColorFactor"] = model.color_of_surface(entry, factors["baseColorFactor"])
            _add_absorption(material, volume, messages)
        if not extensions:
            del entry["extensions"]
    used = {name for entry in root.get("materials", []) for name in entry.get("extensions", {})}
    root["extensionsUsed"] = sorted(used | set(root.get("extensionsUsed", [])))
    if not root["extensionsUsed"]:
        del root["extensionsUsed"]


def add_reflections(entry: dict, material) -> None:
    """Adds to an exported material what Blender's exporter writes otherwise: its index, those of its coat, its sheen, its
    anisotropy, and a level of its reflection."""
    node = model.principled(material) if material is not None else None
    if node is not None and not node.inputs["IOR"].is_linked and node.inputs["IOR"].default_value != 1.5:
        # The exporter writes it only beside other extensions.
        entry.setdefault("extensions", {}).setdefault("KHR_materials_ior", {"ior": node.inputs["IOR"].default_value})
    extensions = entry.get("extensions", {})
    coat = extensions.get("KHR_materials_clearcoat")
    if coat is not None and node is not None and node.inputs["Coat IOR"].default_value != 1.5:
        # glTF has a single index for all coats.
        coat["extras"] = {"ior": node.inputs["Coat IOR"].default_value}
    if coat is not None and node is not None and not node.inputs["Coat Roughness"].is_linked:
        # The exporter leaves out the value of a new material, which is not that of glTF.
        coat.setdefault("clearcoatRoughnessFactor", node.inputs["Coat Roughness"].default_value)
    sheen = extensions.get("KHR_materials_sheen")
    if sheen is not None and node is not None:
        # Blender's exporter leaves the weight out, and glTF has another lobe.
        if not node.inputs["Sheen Weight"].is_linked:
            sheen["sheenColorFactor"] = [node.inputs["Sheen Weight"].default_value * c for c in sheen.get("sheenColorFactor", (0, 0, 0))]
        roughness = node.inputs["Sheen Roughness"]
        sheen["extras"] = {"roughness": sheen.get("sheenRoughnessFactor", 0) if roughness.is_linked else roughness.default_value}
    anisotropy = extensions.get("KHR_materials_anisotropy")
    if anisotropy is not None and node is not None and not node.inputs["Anisotropic"].is_linked:
        # Blender's exporter writes its number as that of glTF, which has another formula.
        anisotropy["extras"] = {"anisotropy": node.inputs["Anisotropic"].default_value}
        if not node.inputs["Anisotropic Rotation"].is_linked:
            anisotropy["anisotropyRotation"] = 2 * math.pi * node.inputs["Anisotropic Rotation"].default_value
    specular = extensions.get("KHR_materials_specular", {})
    if "specularTexture" in specular:
        # A level of 0.5 is that of the index, and the reflection at grazing angles stays.
        specular["specularColorFactor"] = [2 * c for c in specular.get("specularColorFactor", (1, 1, 1))]
        specular["extras"] = {"level": 1}
    if 0 < specular.get("specularFactor", 0) < 1:
        # A level below 1 leaves the reflection at grazing angles, but a factor of glTF does not.
        factor = specular.pop("specularFactor")
        specular["specularColorFactor"] = [factor * c for c in specular.get("specularColorFactor", (1, 1, 1))]


def _add_absorption(material, volume: dict, messages: list[str]) -> None:
    node = linked(material, "Volume")
    if node is None:
        return
    if node.bl_idname != "ShaderNodeVolumeAbsorption":
        messages.append(f"{material.name}: only Volume Absorption is sent, not {node.bl_label}")
        return
    density = node.inputs["Density"].default_value
    if density > 0:
        # Light falls by exp(-(1 - color) * density * distance).
        volume["attenuationColor"] = [math.exp(-(1 - c)) for c in node.inputs["Color"].default_value[:3]]
        volume["attenuationDistance"] = 1 / density


def linked(material, socket: str):
    """Returns the node that is linked to the active output, or None."""
    output = material.node_tree.get_output_node("ALL") or material.node_tree.get_output_node("CYCLES")
    links = output.inputs[socket].links if output else ()
    return links[0].from_node if links else None


def _open_materials(shapes: list) -> set[str]:
    """Returns the materials of meshes with an edge that does not have two faces."""
    names: set[str] = set()
    for shape in shapes:
        if any(m is not None and m.node_tree for m in shape.materials) and not _is_closed(shape.mesh):
            names.update(m.name for m in shape.materials if m is not None)
    return names


def _is_closed(mesh) -> bool:
    edges = numpy.empty(len(mesh.loops), dtype=numpy.int32)
    mesh.loops.foreach_get("edge_index", edges)
    return bool((numpy.bincount(edges, minlength=len(mesh.edges)) == 2).all())
