# SPDX-License-Identifier: Apache-2.0
"""Export of a snapshot: Blender's exporter converts its meshes and materials, and the nodes come from the snapshot."""

from pathlib import Path

import bpy

from . import equivalents, gltf, linked_values, materials, nodes, number_images


def export(scene, snapshot, path: Path, lost: dict[str, str]) -> tuple[dict, bytes]:
    """Writes what a render shows as a .glb file. Returns its JSON and the chunks that follow it.

    Args:
        lost: receives what is lost of shaders, by the name of their material
    """
    added = []
    copies: dict = {}
    images: list = []
    own = bpy.data.scenes.new("lightning export")
    for name in ("resolution_x", "resolution_y", "resolution_percentage", "pixel_aspect_x", "pixel_aspect_y"):
        setattr(own.render, name, getattr(scene.render, name))
    # Materials can have keys.
    own.frame_set(scene.frame_current, subframe=scene.frame_subframe)
    try:
        shapes = {}
        for index, shape in enumerate(snapshot.shapes):
            obj = bpy.data.objects.new(f"lightning {index}", shape.mesh)
            added.append(obj)
            _set_materials(obj, [_exported(material, copies, lost, images) for material in shape.materials])
            own.collection.objects.link(obj)
            shapes[obj.name] = index
        cameras = {}
        for camera in [scene.camera] if scene.camera is not None else [obj for obj in scene.objects if obj.type == "CAMERA"]:
            obj = bpy.data.objects.new("lightning camera", camera.data)
            added.append(obj)
            own.collection.objects.link(obj)
            cameras[obj.name] = camera
        _run(own, path)
        root, rest = gltf.read(path)
        originals = {copy.name: name for name, copy in copies.items() if copy is not None}
        for entry in root.get("materials", []):
            materials.add_reflections(entry, bpy.data.materials.get(entry.get("name", "")))
            entry["name"] = originals.get(entry.get("name", ""), entry.get("name", ""))
    finally:
        bpy.data.batch_remove([*added, own, *(copy for copy in copies.values() if copy is not None), *images])
    _replace_nodes(root, scene, snapshot, shapes, cameras)
    return root, rest


def _exported(material, copies: dict, lost: dict[str, str], images: list):
    """Returns a material that Blender's exporter can write."""
    if material is None:
        return None
    if material.name not in copies:
        copies[material.name] = linked_values.of_material(
            material, number_images.of_material(material, equivalents.of_material(material, lost), lost, images), lost)
    return copies[material.name] or material


def _set_materials(obj, shown: list) -> None:
    mesh = obj.data
    for _ in range(len(shown) - len(mesh.materials)):
        mesh.materials.append(None)
    for slot, material in zip(obj.material_slots, shown):
        slot.link = "OBJECT"
        slot.material = material


def _run(own, path: Path) -> None:
    """Runs the exporter, which takes the scene of the window."""
    # A timer has no window.
    window = bpy.context.window or bpy.context.window_manager.windows[0]
    before, layer = window.scene, window.view_layer
    try:
        window.scene = own
        with bpy.context.temp_override(window=window):
            bpy.ops.export_scene.gltf(filepath=str(path), export_format="GLB", use_active_scene=True, export_current_frame=True,
                                      export_cameras=True, export_lights=False, export_extras=False, export_animations=False,
                                      export_skins=False, export_morph=False, export_tangents=False)
    finally:
        window.scene, window.view_layer = before, layer


def _replace_nodes(root: dict, scene, snapshot, shapes: dict[str, int], cameras: dict) -> None:
    """Replaces the exporter's nodes by those of the snapshot."""
    meshes: dict[int, int] = {}
    entries = []
    for entry in root.get("nodes", []):
        if entry["name"] in shapes and "mesh" in entry:
            index = shapes[entry["name"]]
            meshes[index] = entry["mesh"]
            root["meshes"][entry["mesh"]]["name"] = snapshot.shapes[index].name
        elif entry["name"] in cameras and "camera" in entry:
            camera = cameras[entry["name"]]
            matrix = snapshot.camera if camera == scene.camera else camera.matrix_world
            entries.append({"name": camera.name} | nodes.placement(matrix @ nodes.CAMERA_TURN) | {"camera": entry["camera"]})
    root["nodes"], roots = nodes.of_snapshot(snapshot, meshes, entries)
    root["scene"] = 0
    root["scenes"] = [{"name": scene.name, "nodes": roots}]
