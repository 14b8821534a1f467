# SPDX-License-Identifier: Apache-2.0
"""Sends a scene to Lightning, and gets its lights back."""

import hashlib
import json
import tempfile
import uuid
from pathlib import Path

import bpy

from . import (animation, gltf, instanced_lights, light_nodes, lights, losses, materials, memory, model_export, picture, program, shaders, shot, surfaces, views,
               visibility, volumes, world, written)
from .snapshot import Snapshot

# Start of messages of the export of lights.
LEFT_OUT = "not exported exactly: "
# End of a message of the import that names an option of the command.
OPTION = "; --indirect"
# Parts of messages of the import that say nothing new: Lightning has no clipping planes.
EXPECTED = ("written;", "clipping distances of cameras (znear)", "clipping distances of cameras (zfar)")


def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()


@visibility.evaluated()
def send(context, target: Path, overwrite: bool = False) -> list[str]:
    """Writes a .jen file with everything that a render of the scene shows. Returns messages for the user."""
    scene = context.scene
    remembered = memory.of_scene(scene)
    _check_unchanged(target, remembered, overwrite)
    messages = memory.damage([scene, *lamps(scene)])
    # Lightning's import moves the files to their places, all of them or none.
    with tempfile.TemporaryDirectory(prefix="lightning-send-") as folder:
        command = prepare(context, Path(folder) / target.name, messages, target)
        # An export can take minutes.
        _check_unchanged(target, remembered, overwrite)
        copy = _keep_edited(target, remembered.get("lost", []), messages)
        is_sent = False
        try:
            lines = program.run(*command, "--keep-others")
            is_sent = True
        except program.ProgramError as e:
            # The user does not know the temporary folder.
            raise program.ProgramError(str(e).replace(f"{folder}/", "")) from e
        finally:
            if copy is not None and not is_sent:
                copy.unlink()
    model = command[1]
    messages += [line.removeprefix(f"{model}: ").split(OPTION)[0] for line in lines if not any(text in line for text in EXPECTED)]
    _remember(scene, target, lamps(scene), messages)
    # Instances of a light have equal messages.
    return list(dict.fromkeys(messages))


def _check_unchanged(target: Path, remembered: dict, overwrite: bool) -> None:
    if target.is_file() and not overwrite and remembered.get("digest") != _digest(target):
        raise program.ProgramError(f"{target.name} was not sent from here, or has changed since: get its lights first, or overwrite it")


def _keep_edited(target: Path, lost: list[str], messages: list[str]) -> Path | None:
    """Keeps the scene file under another name if it has edits that Blender does not have, and that the new file lacks. Returns the copy."""
    if not lost or not target.is_file():
        return None
    copy = target.with_suffix(".edited.jen")
    number = 2
    while copy.exists() or copy.is_symlink():
        copy = target.with_suffix(f".edited{number}.jen")
        number += 1
    with copy.open("xb") as file:
        file.write(target.read_bytes())
    messages += [f"only in {copy.name} now: {edit}" for edit in lost]
    return copy


def lamps(scene) -> list:
    """Returns the light objects that are sent, in their order in Lightning."""
    return [obj for obj in scene.objects if obj.type == "LIGHT" and not visibility.is_portal(obj)]


@visibility.evaluated()
def prepare(context, target: Path, messages: list[str], output: Path | None = None) -> list[str]:
    """Writes the glTF file of a scene, and what it refers to. Returns the command that makes the .jen file of it.

    Args:
        target: file of a scene, next to which the files are written
        output: the .jen file; `target` without it
    """
    # A render shows the keys of the frame, not edits without a key.
    context.scene.frame_set(context.scene.frame_current, subframe=context.scene.frame_subframe)
    with Snapshot(context.scene) as snapshot:
        lost: dict[str, str] = {}
        root, rest = model_export.export(context.scene, snapshot, target.with_suffix(".glb"), lost)
        messages += shaders.notes(root, lost)
        complete(context.scene, target, root, snapshot, messages)
        groups = memory.of_scene(context.scene).get("banks", {})
        names = {obj: obj.name for obj in lamps(context.scene)}
        root["extras"][memory.PROPERTY]["shot"] = shot.record(context, snapshot.objects.keys(), names, groups, messages)
    model = target.with_suffix(".glb")
    gltf.write(model, root, rest)
    return ["import", str(model), "-o", str(output or target), "--light-units", "candela", "--indirect", picture.indirect(context.scene)]


def complete(scene, target: Path, root: dict, snapshot: Snapshot, messages: list[str]) -> None:
    """Adds to an exported scene what glTF cannot say, except animation, and writes the files that it needs."""
    materials.add_glass(root, snapshot.shapes, messages)
    root.setdefault("extras", {})[memory.PROPERTY] = _settings(scene, target, snapshot, messages)
    messages += snapshot.messages + snapshot.left_out.lines()


def _settings(scene, target: Path, snapshot: Snapshot, messages: list[str]) -> dict:
    messages += losses.of_scene(scene)
    remembered = memory.of_scene(scene)
    groups = remembered.get("banks", {})
    sent = lamps(scene)
    used = dict.fromkeys(obj.lightgroup for obj in [*sent, *(obj for obj, _, _ in snapshot.lights)] if obj.lightgroup)
    settings = {
        "version": 1,
        "id": _id(scene),
        "picture": picture.send(scene, remembered.get("picture", {}), messages),
        "world": world_settings(scene, target, messages) | snapshot.fog,
        "banks": light_groups(groups, used),
        "materials": surfaces.send(remembered.get("surfaces", {})),
        "lights": [lights.send(obj, groups, messages) for obj in sent] + instanced_lights.send(snapshot, [obj.name for obj in sent], groups, messages),
    }
    if scene.camera is not None:
        settings["camera"] = scene.camera.name
        settings["distance"] = shot.target_distance(scene.camera.data)
        settings["shift"] = shot.shift(scene)
        settings["lens"] = shot.lens(scene)
    for obj in dict.fromkeys([*sent, *(obj for obj, _, _ in snapshot.lights)]):
        write_files(obj, target.parent, messages)
    return settings


def _id(scene) -> str:
    """Returns what marks the files that a scene was sent to."""
    return memory.of_scene(scene).get("id") or uuid.uuid4().hex


def light_groups(groups: dict, used) -> list[dict]:
    """Returns the light groups that lights use, with their settings in Lightning."""
    return [{"name": name, **groups.get(name, {})} for name in used]


def world_settings(scene, target: Path, messages: list[str]) -> dict:
    """Returns the world as Lightning's JSON, and writes its image next to the scene file."""
    remembered = memory.of_scene(scene)
    sent = world.send(scene.world, target.parent, target.stem, messages)
    # What Blender had and has no more. Lightning's own sky and fog stay.
    gone: dict = {}
    for key in remembered.get("sent", []):
        if key not in sent:
            gone |= world.OFF[key]
    return remembered.get("world", {}) | sent | gone


def write_files(obj, folder: Path, messages: list[str]) -> None:
    """Writes the profile and the image of a light."""
    light_nodes.write_texture(obj.data, folder, messages)
    name, profile = light_nodes.profile(obj) if obj.data.type in ("POINT", "SPOT") else ("", "")
    content = profile.encode("ascii")
    if name and not ((folder / name).is_file() and (folder / name).read_bytes() == content):
        (folder / name).write_bytes(content)


def _store(scene, file: Path, exported: dict, groups: dict, kept: dict, instances, lost: list[str]) -> None:
    """Stores in a scene what a file of Lightning has, so that later edits can be told.

    Args:
        instances: names of lights in instances
        kept: edits of materials that are sent again
        lost: messages about edits that only the file has
    """
    memory.store(scene, {"banks": groups, "world": exported["world"], "picture": picture.store(scene, exported["picture"]),
                         "id": written.sender(file), "digest": _digest(file), "views": views.digests(exported),
                         "surfaces": surfaces.store(exported, kept), "instances": instanced_lights.store(exported, instances), "lost": lost,
                         "sent": [*world.kinds(scene.world), *(["fog"] if any(map(volumes.has_only_volume, scene.objects)) else [])]})


def _remember(scene, target: Path, sent: list, messages: list[str]) -> None:
    """Stores the lights as Lightning has them now, so that a later exchange can tell who changed what."""
    exported = export(target, [])
    groups = {group.pop("name"): group for group in exported["banks"]}
    by_name = {light["name"]: light for light in exported["lights"]}
    animated = animation.by_light(exported)
    for obj in sent:
        if obj.name in by_name:
            lights.store(obj, obj.name, by_name[obj.name], groups, animation.digests(animated.get(obj.name, {})))
    kept = surfaces.check(exported, memory.of_scene(scene).get("surfaces", {}).get("kept", {}), messages)
    _store(scene, target, exported, groups, kept, by_name.keys() - {obj.name for obj in sent}, [])


def export(source: Path, messages: list[str]) -> dict:
    """Returns the lights of a .jen file as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "lights.json"
        lines = program.run("export-lights", str(source), "-o", str(file))
        messages += [f"stay in Lightning only: {line.split(LEFT_OUT, 1)[1]}" for line in lines if LEFT_OUT in line]
        exported = json.loads(file.read_text(encoding="utf-8"))
    _use_own_names(exported, written.sources(source))
    return exported


def _use_own_names(exported: dict, sources: dict[str, str]) -> None:
    """Replaces the names of files that the import wrote under another name: Blender knows them by their own."""
    for settings in (*exported["lights"], exported["world"]):
        for key in ("profile", "texture", "environment"):
            if settings.get(key) in sources:
                settings[key] = sources[settings[key]]


def is_sent_to(scene, file: Path) -> bool:
    """Returns whether a file was sent from a scene, or is a copy of one."""
    sender = written.sender(file)
    return bool(sender) and sender == memory.of_scene(scene).get("id")


@visibility.evaluated()
def get_lights(context, source: Path, remove: bool = True, from_another: bool = False) -> list[str]:
    """Brings the lights of a .jen file back: edited, added and, with `remove`, deleted ones. Returns messages for the user.

    Args:
        from_another: also adds the lights of a file that this scene was not sent to; nothing else changes then
    """
    scene = context.scene
    remembered = memory.of_scene(scene)
    messages = memory.damage([scene, *lamps(scene)])
    is_own = is_sent_to(scene, source)
    if not is_own and not from_another and any(memory.of_light(obj) for obj in lamps(scene)):
        raise program.ProgramError(f"{source.name} was not sent from this scene: choose From Another Scene to add its lights to those of this one")
    exported = export(source, messages)
    groups = {group.pop("name"): group for group in exported["banks"]}
    animated = animation.by_light(exported)
    known = {}
    for obj in scene.objects:
        if obj.type == "LIGHT":
            known[memory.of_light(obj).get("name", obj.name)] = obj
    received = []
    instances = remembered.get("instances", {}) if is_own else {}
    for settings in exported["lights"]:
        if settings["name"] in instances and settings["name"] not in known:
            continue
        if settings["type"] == "object":
            known.pop(settings["name"], None)
            messages.append(f"{settings['name']}: left out, because it is the surface of an object; give that an emission in Blender")
            continue
        obj = known.pop(settings["name"], None) or _new_light(scene, settings)
        if settings["bank"] and settings["bank"] not in context.view_layer.lightgroups:
            context.view_layer.lightgroups.add(name=settings["bank"])
        lights.receive(obj, settings, groups, messages)
        values = animated.get(settings["name"], {})
        animation.receive(scene, obj, settings, values, exported.get("shot", {}).get("frames", [0])[0], groups, messages)
        received.append((obj, settings, animation.digests(values)))
    for name, obj in known.items():
        if is_own and remove and memory.of_light(obj):
            bpy.data.objects.remove(obj)
            messages.append(f"{name}: removed, because it was deleted in Lightning")
    context.view_layer.update()
    for obj, settings, tracks in received:
        lights.store(obj, settings["name"], settings, groups, tracks)
    if is_own:
        _get_rest(scene, source, exported, groups, messages)
    else:
        _add_groups(scene, groups)
    if any(settings["solo"] for settings in exported["lights"]) or any(group["solo"] for group in groups.values()):
        messages.append("solo lights: Blender shows the others too")
    for name, group in groups.items():
        if group["intensity"] != 1 or group["color"] != [1, 1, 1] or not group["on"]:
            messages.append(f"{name}: the light group's settings are part of its lights in Blender")
    return messages


def _get_rest(scene, source: Path, exported: dict, groups: dict, messages: list[str]) -> None:
    """Brings back all but the lights from a file that the scene was sent to, and remembers the file."""
    remembered = memory.of_scene(scene)
    picture.receive(scene, exported["picture"], remembered.get("picture", {}), messages)
    lost: list[str] = []
    views.receive(scene, exported, remembered.get("views", {}), lost)
    kept = surfaces.receive(exported, remembered.get("surfaces", {}), messages, lost)
    instances = remembered.get("instances", {})
    lost += instanced_lights.lost(exported, instances)
    messages += lost
    world.receive(scene.world, exported["world"], remembered.get("world", {}), messages)
    messages += world.lost(scene.world, exported)
    _store(scene, source, exported, groups, kept, instances, [*remembered.get("lost", []), *lost])


def _add_groups(scene, groups: dict) -> None:
    """Remembers light groups of another scene, whose factors the received lights have."""
    remembered = memory.of_scene(scene)
    memory.store(scene, remembered | {"banks": remembered.get("banks", {}) | groups})


def _new_light(scene, settings: dict):
    data = bpy.data.lights.new(settings["name"], lights.TYPES[settings["type"]])
    if data.type == "AREA":
        data.shape = "RECTANGLE" if settings["type"] == "rect" else "DISK"
    obj = bpy.data.objects.new(settings["name"], data)
    scene.collection.objects.link(obj)
    return obj
