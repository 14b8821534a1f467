# SPDX-License-Identifier: Apache-2.0
"""Lights in instances, such as those of a collection: each is a light of its own in Lightning. Their edits do not come back."""

from . import animation, lights


def names(snapshot, taken) -> list[str]:
    """Returns the names of a snapshot's instances of lights, which differ from those of other lights."""
    used = set(taken)
    result = []
    for obj, maker, _ in snapshot.lights:
        base = name = f"{obj.name} of {maker.name}"
        number = 2
        while name in used:
            name, number = f"{base} {number}", number + 1
        used.add(name)
        result.append(name)
    return result


def send(snapshot, taken, groups: dict, messages: list[str]) -> list[dict]:
    """Returns a snapshot's instances of lights as Lightning's JSON; `taken` has the names of the other lights."""
    return [lights.send_instance(obj, name, matrix, groups, messages)
            for name, (obj, _, matrix) in zip(names(snapshot, taken), snapshot.lights)]


def store(exported: dict, names) -> dict:
    """Returns what a scene remembers of lights in instances, which have these names in a file of Lightning."""
    tracks = animation.by_light(exported)
    return {light["name"]: {"settings": light, "tracks": animation.digests(tracks.get(light["name"], {}))}
            for light in exported["lights"] if light["name"] in names}


def lost(exported: dict, remembered: dict) -> list[str]:
    """Returns messages about edits of lights in instances since `store`, which only the file has."""
    after = store(exported, remembered.keys())
    return [f"{name}: its edits stay in Lightning, because it is a light in an instance" for name, before in remembered.items()
            if after.get(name) != before]
