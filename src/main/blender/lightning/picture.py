# SPDX-License-Identifier: Apache-2.0
"""Settings of the picture. Blender has size, view and exposure, too; Lightning has more."""

from . import axes, shot

# Lightning's curves for Blender's view transforms.
VIEWS = {"AgX": "agx", "ACES 2.0": "aces2", "Filmic": "filmic", "Standard": "srgb", "Raw": "linear"}
# Choices of indirect light, as for the import.
INDIRECT = [("AUTO", "Automatic", "Indirect light with the bounces of Cycles; with other engines, if rays are traced or the camera is in a closed room"),
            ("ON", "On", "Indirect light: light that surfaces scatter onto each other"),
            ("OFF", "Off", "Direct light only")]
# Engines that trace rays if the scene says so. The name changed twice.
EEVEE = ("BLENDER_EEVEE", "BLENDER_EEVEE_NEXT")
# Bounces of Cycles by default, for EEVEE, which has no number of its own.
DEFAULT_BOUNCES = 4
# Maximum bounces in Lightning.
MAX_BOUNCES = 8


def send(scene, remembered: dict, messages: list[str]) -> dict:
    """Returns the picture as Lightning's JSON: what it has there, and what has changed in Blender since.

    Args:
        remembered: what the scene remembers of the picture, see `store`
    """
    now, before = _of_blender(scene), remembered.get("blender", {})
    if "view" not in now:
        messages.append(f"the view transform {scene.view_settings.view_transform} is not sent")
    result = {"antialias": "edges"} | remembered.get("lightning", {})
    result |= {key: value for key, value in now.items() if key not in result or value != before.get(key)}
    # Automatic is decided again each time.
    if scene.lightning_indirect != "ON":
        result.pop("indirect", None)
    if scene.lightning_indirect == "AUTO":
        _add_indirect(scene, result, messages)
    return result


def _add_indirect(scene, result: dict, messages: list[str]) -> None:
    count = bounces(scene)
    if count is None:
        return
    engine = "EEVEE with ray tracing" if scene.render.engine in EEVEE else "Cycles"
    if count == 0:
        messages.append("indirect light is off, because Cycles has no diffuse bounces")
        return
    used = min(count, MAX_BOUNCES)
    result["indirect"] = {"bounces": used}
    messages.append(f"indirect light is on with {used} {'bounce' if used == 1 else 'bounces'}, as in {engine}"
                    + (f", which has {count}" if count > used else ""))


def bounces(scene) -> int | None:
    """Returns the diffuse bounces of a render in Blender; None if its engine has no such light."""
    if scene.render.engine == "CYCLES":
        return min(scene.cycles.diffuse_bounces, scene.cycles.max_bounces)
    return DEFAULT_BOUNCES if scene.render.engine in EEVEE and scene.eevee.use_raytracing else None


def indirect(scene) -> str:
    """Returns whether an import gives the scene indirect light: auto, on or off."""
    count = bounces(scene)
    if scene.lightning_indirect != "AUTO" or count is None:
        return scene.lightning_indirect.lower()
    return "on" if count else "off"


def store(scene, shown: dict) -> dict:
    """Returns what a scene remembers of the picture: Lightning's settings and Blender's own."""
    return {"lightning": shown, "blender": _of_blender(scene)}


def receive(scene, shown: dict, remembered: dict, messages: list[str]) -> None:
    """Changes what was edited in Lightning.

    Args:
        shown: the settings there
        remembered: what the scene remembers; nothing comes back without it
    """
    before = remembered.get("lightning")
    if before is None:
        return
    if shown["size"] != before["size"]:
        scene.render.resolution_x, scene.render.resolution_y = shown["size"]
        scene.render.resolution_percentage = 100
    if shown["exposure"] != before["exposure"]:
        scene.view_settings.exposure = shown["exposure"]
    if shown["view"] != before["view"]:
        _show_view(scene, shown["view"], messages)
    if shown.get("indirect") != before.get("indirect"):
        scene.lightning_indirect = "ON" if "indirect" in shown else "OFF"


def _show_view(scene, curve: str, messages: list[str]) -> None:
    transform = next((name for name, word in VIEWS.items() if word == curve), None)
    try:
        scene.view_settings.view_transform = transform or ""
    except TypeError:
        messages.append(f"the view {curve} stays in Lightning, because Blender has no such view transform")


def _of_blender(scene) -> dict:
    view = scene.view_settings
    result = {"size": shot.size(scene), "exposure": axes.number(view.exposure)}
    return result | ({"view": VIEWS[view.view_transform]} if view.view_transform in VIEWS else {})
