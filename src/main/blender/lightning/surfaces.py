# SPDX-License-Identifier: Apache-2.0
"""Materials that come back from Lightning: plain values of the only Principled BSDF. Other edits are sent again with the scene."""

import bpy

from . import model

# Sockets of a Principled BSDF for each attribute of Lightning's materials.
SOCKETS = {"base": ("Base Color",), "metalness": ("Metallic",), "roughness": ("Roughness",), "glow": ("Emission Color", "Emission Strength"),
           "ior": ("IOR",), "coat": ("Coat Weight",), "coat_roughness": ("Coat Roughness",), "coat_ior": ("Coat IOR",),
           "sheen": ("Sheen Weight", "Sheen Tint"), "sheen_roughness": ("Sheen Roughness",), "anisotropy": ("Anisotropic",),
           "anisotropy_rotation": ("Anisotropic Rotation",)}


def send(remembered: dict) -> list[dict]:
    """Returns the edits of materials in Lightning that Blender cannot hold, each with the value before and after.

    Args:
        remembered: what the scene remembers, see `store`
    """
    return [{"name": name, "edits": edits} for name, edits in remembered.get("kept", {}).items()]


def store(exported: dict, kept: dict) -> dict:
    """Returns what a scene remembers of its materials: their values in Lightning, and the edits that Blender cannot hold."""
    values = {material["name"]: material for material in exported["materials"]}
    return {"values": values, "kept": {name: edits for name, edits in kept.items() if name in values and edits}}


def check(exported: dict, kept: dict, messages: list[str]) -> dict:
    """Returns the edits that a scene has after it was sent; a message names those whose value was changed in Blender since."""
    values = {material["name"]: material for material in exported["materials"]}
    result: dict = {}
    for name, edits in kept.items():
        result[name] = {key: edit for key, edit in edits.items() if values.get(name, {}).get(key) == edit[1]}
        replaced = [key for key in edits if key not in result[name]]
        if replaced:
            messages.append(f"{name}: edits in Blender replace those in Lightning: {', '.join(replaced)}")
    return result


def receive(exported: dict, remembered: dict, messages: list[str], lost: list[str]) -> dict:
    """Changes the values of materials that were edited in Lightning, and tells which of them stay there.

    Args:
        remembered: what the scene remembers; nothing comes back without it
        lost: receives messages about edits that the next sending cannot repeat

    Returns:
        the edits that Blender cannot hold
    """
    kept = {name: dict(edits) for name, edits in remembered.get("kept", {}).items()}
    # Attributes that name files or lights, which the import cannot edit.
    names = exported.get("materialNames", ())
    for after in exported["materials"] if remembered else ():
        name = after["name"]
        before = remembered["values"].get(name)
        if before is None:
            lost.append(f"{name}: the material stays in Lightning, because it was added there")
            continue
        edited = [key for key in before.keys() | after.keys() if before.get(key) != after.get(key)]
        hidden = sorted(key for key in edited if not _show(bpy.data.materials.get(name), key, after.get(key)))
        for key in edited:
            edit = kept.setdefault(name, {}).pop(key, [before.get(key)])
            if key in hidden and key not in names and edit[0] != after[key]:
                kept[name][key] = [edit[0], after[key]]
        for target, keys in ((lost, [key for key in hidden if key in names]), (messages, [key for key in hidden if key not in names])):
            if keys:
                target.append(f"{name}: edits of the material stay in Lightning: {', '.join(keys)}")
    return kept


def _show(material, key: str, value) -> bool:
    """Gives a material an edited value; returns whether it can have it."""
    node = model.principled(material) if material is not None else None
    sockets = [node.inputs[name] for name in SOCKETS.get(key, ())] if node is not None else []
    if not sockets or any(socket.is_linked for socket in sockets):
        return False
    if key == "glow":
        strength = max(1.0, *value)
        sockets[0].default_value = (*(v / strength for v in value), 1)
        sockets[1].default_value = strength
    elif key == "sheen":
        weight = max(value)
        sockets[0].default_value = weight
        sockets[1].default_value = (*(v / weight for v in value), 1) if weight > 0 else (1, 1, 1, 1)
    elif key == "anisotropy_rotation":
        # Blender's number is a share of a turn.
        sockets[0].default_value = value / 360 % 1
    elif key == "base":
        sockets[0].default_value = (*value, sockets[0].default_value[3])
    else:
        sockets[0].default_value = value
    return True
