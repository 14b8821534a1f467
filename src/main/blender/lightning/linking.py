# SPDX-License-Identifier: Apache-2.0
"""Light linking: Blender has collections of receivers and blockers, Lightning lists of names."""

import bpy

ALL = {"only": False, "names": []}


def to_names(collection) -> dict:
    """Returns the links of a light as Lightning stores them."""
    if collection is None:
        return dict(ALL)
    included: list[str] = []
    excluded: list[str] = []
    for obj, item in zip(collection.objects, collection.collection_objects):
        _side(item, included, excluded).append(obj.name)
    for child, item in zip(collection.children, collection.collection_children):
        _side(item, included, excluded).extend(obj.name for obj in child.all_objects)
    included = [name for name in dict.fromkeys(included) if name not in excluded]
    if included:
        return {"only": True, "names": sorted(included)}
    return {"only": False, "names": sorted(set(excluded))}


def _side(item, included: list[str], excluded: list[str]) -> list[str]:
    return excluded if item.light_linking.link_state == "EXCLUDE" else included


def to_collection(links: dict, title: str, messages: list[str]):
    """Returns a collection for links of Lightning, or None if they name everything."""
    if links == ALL:
        return None
    objects = [bpy.data.objects[name] for name in links["names"] if name in bpy.data.objects]
    if len(objects) < len(links["names"]) or not objects:
        messages.append(f"{title}: some linked objects are not in this file")
    if not objects:
        return None
    collection = bpy.data.collections.get(title) or bpy.data.collections.new(title)
    for obj in list(collection.objects):
        collection.objects.unlink(obj)
    for obj in objects:
        collection.objects.link(obj)
    for item in collection.collection_objects:
        item.light_linking.link_state = "INCLUDE" if links["only"] else "EXCLUDE"
    return collection
