# SPDX-License-Identifier: Apache-2.0
"""The exported model of the live view: edits of placements, of the camera and of simple material values without Blender's exporter.

The exporter is slow for large scenes. A value is edited here only if this module has described it, right after the export, as the exporter
wrote it. Everything else is exported again.
"""

import math
from collections import Counter

import bpy
from mathutils import Matrix

from . import nodes, shot

# Nodes without settings that a change of simple values could miss.
KNOWN_NODES = {"ShaderNodeOutputMaterial", "ShaderNodeBsdfPrincipled", "ShaderNodeTexImage", "ShaderNodeNormalMap", "ShaderNodeUVMap",
               "ShaderNodeMapping", "ShaderNodeTexCoord", "ShaderNodeVolumeAbsorption", "NodeFrame", "NodeReroute"}
# Properties of nodes that the editor changes without changing the material.
EDITOR_PROPERTIES = {"location", "location_absolute", "width", "height", "select", "show_options", "show_preview", "show_texture", "hide", "label",
                     "color", "use_custom_color", "dimensions", "preview_id", "preview_render_type", "is_active_output", "warning_propagation"}
SCALAR_TYPES = {"BOOLEAN", "INT", "FLOAT", "STRING", "ENUM"}


class Model:
    """Root of an exported glTF file. `edit` keeps it equal to a new export."""

    def __init__(self, scene, root: dict, watched: set[str]) -> None:
        """Takes the root before anything is added to it.

        Args:
            watched: names of objects that move others in a way that only an export knows
        """
        self.root = root
        # Objects by name: their matrix, and their node if it can be edited.
        self._nodes: dict = {}
        # Materials by name: the rest of their settings, their simple values, and the entry.
        self._materials: dict = {}
        self._camera = None
        self._lens: tuple = ()
        entries = root.get("nodes", [])
        names = [entry.get("name", "") for entry in entries]
        counts = Counter(names)
        roots = set(root["scenes"][root.get("scene", 0)].get("nodes", []))
        for index, entry in enumerate(entries):
            obj = bpy.data.objects.get(names[index])
            if obj is None:
                continue
            is_plain = counts[names[index]] == 1 and index in roots and names[index] not in watched
            is_same = is_plain and nodes.of_object(obj) == {key: entry[key] for key in ("translation", "rotation", "scale") if key in entry}
            self._nodes[names[index]] = (obj.matrix_world.copy(), entry if is_same else None)
        for obj in [bpy.data.objects.get(name) for name in watched - self._nodes.keys()]:
            if obj is not None:
                self._nodes[obj.name] = (obj.matrix_world.copy(), None)
        self._read_camera(scene, entries)
        materials = root.get("materials", [])
        names = [entry.get("name", "") for entry in materials]
        for entry in materials:
            material = bpy.data.materials.get(entry.get("name", ""))
            if material is not None and names.count(material.name) == 1:
                values = {key: value for key, value in _simple_values(material).items() if _is_written(entry, key, value)}
                self._materials[material.name] = [_rest(material), values, entry]

    def _read_camera(self, scene, entries: list) -> None:
        if scene.camera is None:
            return
        self._lens = _lens(scene)
        entry = next((e for e in entries if e.get("name") == scene.camera.name and "camera" in e), None)
        camera = self.root["cameras"][entry["camera"]].get("perspective") if entry else None
        if camera is not None and camera.get("yfov") == _field_of_view(scene):
            self._camera = camera

    def edit(self, scene, materials: set) -> bool | None:
        """Edits what has changed. Returns whether something did; None if only an export can tell what.

        Args:
            materials: names of materials that may have changed
        """
        is_changed = False
        for name, (matrix, entry) in self._nodes.items():
            obj = bpy.data.objects.get(name)
            if obj is None:
                return None
            if obj.matrix_world == matrix:
                continue
            if entry is None or nodes.is_sheared(obj.matrix_world):
                return None
            for key in ("translation", "rotation", "scale"):
                entry.pop(key, None)
            entry.update(nodes.of_object(obj))
            self._nodes[name] = (obj.matrix_world.copy(), entry)
            is_changed = True
        if scene.camera is not None and _lens(scene) != self._lens:
            if self._camera is None or scene.camera.data.type != "PERSP":
                return None
            self._camera["yfov"] = _field_of_view(scene)
            self._lens = _lens(scene)
            is_changed = True
        for name in materials:
            edited = self._edit_material(name)
            if edited is None:
                return None
            is_changed |= edited
        return is_changed

    def _edit_material(self, name: str) -> bool | None:
        material = bpy.data.materials.get(name)
        known = self._materials.get(name)
        if material is None or known is None:
            return None
        rest, values, entry = known
        if rest is None or _rest(material) != rest:
            return None
        after = _simple_values(material)
        changed = {key: value for key, value in after.items() if values.get(key) != value}
        if not changed.keys() <= values.keys() or not all(PROPERTIES[key][2](values[key], value) for key, value in changed.items()):
            return None
        for key, value in changed.items():
            PROPERTIES[key][1](entry, value)
            values[key] = value
        return bool(changed)


def _lens(scene) -> tuple:
    data = scene.camera.data
    return (data.type, data.angle, data.sensor_fit, data.sensor_width, data.sensor_height, data.ortho_scale, data.shift_x, data.shift_y,
            data.dof.focus_distance, scene.render.pixel_aspect_x, scene.render.pixel_aspect_y, *shot.lens(scene).values())


def _field_of_view(scene) -> float:
    data, render = scene.camera.data, scene.render
    width, height = render.pixel_aspect_x * render.resolution_x, render.pixel_aspect_y * render.resolution_y
    fits_width = data.sensor_fit != "VERTICAL" if width >= height else data.sensor_fit == "HORIZONTAL"
    return 2.0 * math.atan(math.tan(data.angle * 0.5) / (width / height)) if fits_width else data.angle


def principled(material):
    """Returns the only shader of a material; None if there are others."""
    nodes = material.node_tree.nodes if material.node_tree else ()
    found = [node for node in nodes if node.bl_idname == "ShaderNodeBsdfPrincipled"]
    return found[0] if len(found) == 1 else None


def _simple_values(material) -> dict:
    """Returns values of the sockets of a material's only shader that nothing is linked to, as glTF has them."""
    node = principled(material)
    if node is None:
        return {}
    result = {}
    for key, (sockets, _, _) in PROPERTIES.items():
        inputs = [node.inputs.get(name) for name in sockets]
        if all(socket is not None and not socket.is_linked for socket in inputs):
            result[key] = _CONVERSIONS.get(key, lambda value: value)(*(socket.default_value for socket in inputs))
    return result


def _is_written(entry: dict, key: str, value) -> bool:
    """Returns whether a material of the exporter says a value as this module does."""
    written = dict(entry)
    PROPERTIES[key][1](written, value)
    return written == entry


def _color(color, alpha: float) -> list:
    return [max(min(c, 1.0), 0.0) for c in color[:3]] + [alpha]


def _emission(color, strength: float) -> list:
    return [c * strength for c in color[:3]]


_CONVERSIONS = {"color": _color, "emission": _emission}


def color_of_surface(entry: dict, color: list) -> list:
    """Returns the color of each surface of a material, from that of a Principled BSDF.

    Light through a body has the color of a Principled BSDF once in Cycles, but that of glTF at both surfaces. So each has the root.
    """
    extensions = entry.get("extensions", {})
    transmitted = extensions.get("KHR_materials_transmission", {}).get("transmissionFactor")
    is_body = transmitted == 1 and extensions.get("KHR_materials_volume", {}).get("thicknessFactor", 0) > 0
    return [math.sqrt(c) for c in color[:3]] + color[3:] if is_body else color


def _write_color(entry: dict, value: list) -> None:
    _write_factor("baseColorFactor", [1, 1, 1, 1])(entry, color_of_surface(entry, value))
    entry.pop("alphaMode", None)
    if value[3] != 1:
        entry["alphaMode"] = "BLEND"


def _write_emission(entry: dict, value: list) -> None:
    entry.pop("emissiveFactor", None)
    strength = max(value)
    _write_extension("KHR_materials_emissive_strength", "emissiveStrength", None)(entry, strength if strength > 1.0 else None)
    if strength > 1.0:
        value = [v / strength for v in value]
    if value != [0, 0, 0]:
        entry["emissiveFactor"] = value


def _write_factor(name: str, default=1):
    return lambda entry, value: _write(entry, "pbrMetallicRoughness", {name: value} if value != default else {}, name)


def _write_extension(extension: str, name: str, default: float | None):
    return lambda entry, value: _write(entry, "extensions", {extension: {name: value}} if value != default else {}, extension)


def _write(entry: dict, group: str, content: dict, name: str) -> None:
    """Replaces a member of a group; a group without members is left out."""
    rest = {key: value for key, value in entry.pop(group, {}).items() if key != name} | content
    if rest:
        entry[group] = rest


def _always(_before, _after) -> bool:
    return True


def _stays_partial(before: float, after: float) -> bool:
    # Glass that transmits all light has another color (color_of_surface).
    return before not in (0, 1) and after not in (0, 1)


# For each simple value: its sockets, the function that writes it, and a test for changes that leave other values as they are.
PROPERTIES = {
    "color": (("Base Color", "Alpha"), _write_color, _always),
    "metallic": (("Metallic",), _write_factor("metallicFactor"), _always),
    "roughness": (("Roughness",), _write_factor("roughnessFactor"), _always),
    "emission": (("Emission Color", "Emission Strength"), _write_emission, _always),
    "index": (("IOR",), _write_extension("KHR_materials_ior", "ior", 1.5), _always),
    "transmission": (("Transmission Weight",), _write_extension("KHR_materials_transmission", "transmissionFactor", 0.0), _stays_partial),
}


def _rest(material) -> tuple | None:
    """Returns all settings of a material except its simple values; None if it has nodes that cannot be compared."""
    tree = material.node_tree
    shader = principled(material)
    if tree is None or shader is None or any(node.bl_idname not in KNOWN_NODES for node in tree.nodes):
        return None
    simple = {name for sockets, _, _ in PROPERTIES.values() for name in sockets}
    result = [_settings(material)]
    for node in tree.nodes:
        image = getattr(node, "image", None)
        result.append((node.name, _settings(node), image and (image.name, image.filepath)))
        result += [_value(socket) for socket in node.inputs
                   if hasattr(socket, "default_value") and (node != shader or socket.is_linked or socket.name not in simple)]
    result += [(link.from_node.name, link.from_socket.identifier, link.to_node.name, link.to_socket.identifier) for link in tree.links]
    return tuple(result)


def _value(socket) -> tuple:
    value = socket.default_value
    return socket.identifier, tuple(value) if hasattr(value, "__len__") and not isinstance(value, str) else value


def _settings(block) -> tuple:
    return tuple((p.identifier, _plain(getattr(block, p.identifier))) for p in block.bl_rna.properties
                 if p.type in SCALAR_TYPES and not p.is_readonly and p.identifier not in EDITOR_PROPERTIES)


def _plain(value):
    return tuple(tuple(row) for row in value) if isinstance(value, Matrix) else tuple(value) if hasattr(value, "__len__") and not isinstance(
        value, (str, set, frozenset)) else frozenset(value) if isinstance(value, set) else value
