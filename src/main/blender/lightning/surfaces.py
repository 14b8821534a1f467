# SPDX-License-Identifier: Apache-2.0
"""Materials that come back from Lightning: plain values of the only Principled BSDF."""

import bpy

from . import animation, model

# Sockets of a Principled BSDF for each attribute of Lightning's materials.
SOCKETS = {"base": ("Base Color",), "metalness": ("Metallic",), "roughness": ("Roughness",), "glow": ("Emission Color", "Emission Strength"),
           "ior": ("IOR",)}


def digests(exported: dict) -> dict[str, str]:
    """Returns what a scene remembers of its materials, by material and attribute."""
    return animation.digests({f"{material['name']}/{key}": value for material in exported["materials"] for key, value in material.items()})


def receive(exported: dict, before: dict[str, str], messages: list[str]) -> None:
    """Changes the values of materials that were edited in Lightning, and tells which of them stay there.

    Args:
        before: what the scene remembers; nothing comes back without it
    """
    after = digests(exported)
    for settings in exported["materials"] if before else ():
        name = settings["name"]
        if f"{name}/name" not in before:
            messages.append(f"{name}: the material stays in Lightning, because it was added there")
            continue
        edited = [key for key in settings if before.get(f"{name}/{key}") != after[f"{name}/{key}"]]
        kept = [key for key in edited if not _show(bpy.data.materials.get(name), key, settings[key])]
        if kept:
            messages.append(f"{name}: edits of the material stay in Lightning: {', '.join(kept)}")


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
    elif key == "base":
        sockets[0].default_value = (*value, sockets[0].default_value[3])
    else:
        sockets[0].default_value = value
    return True
