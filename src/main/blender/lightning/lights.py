# SPDX-License-Identifier: Apache-2.0
"""Lights of both programs.

A light is sent as the JSON object that `lightning export-lights` writes for it. Blender cannot hold all of it (barn doors, gobos,
gains, units), so each light object remembers what it was in Lightning, and what Blender showed of it then. A property that did not change
in Blender since keeps its exact value.
"""

import math

import bpy

from . import axes, light_nodes, linking, memory, temperature, visibility

# Lightning's intensity for one watt, or for one watt per square meter of a sun: the brightness of a white surface at distance 1.
PER_WATT = {"POINT": 1 / (4 * math.pi ** 2), "SPOT": 1 / (4 * math.pi ** 2), "AREA": 1 / math.pi ** 2, "SUN": 1 / math.pi}
# Values of settings that older versions did not remember.
OLD = {"beam_spread": 90}
# Smallest half-angle of an area light's beam in Lightning, in degrees.
NARROWEST = 1
TYPES = {"point": "POINT", "spot": "SPOT", "directional": "SUN", "rect": "AREA", "disc": "AREA", "tube": "POINT"}


def store(obj, name: str, settings: dict, groups: dict, tracks: dict | None = None) -> None:
    """Remembers a light as it is in Lightning, and as Blender shows it now; `tracks` has digests of its animation there."""
    memory.store(obj, {"name": name, "settings": settings, "shown": describe(obj, groups, []),
                       "group": groups.get(settings["bank"], {}), "tracks": tracks or {}})


def send(obj, groups: dict, messages: list[str]) -> dict:
    """Returns a light as Lightning's JSON."""
    return _settings(describe(obj, groups, messages), memory.of_light(obj)) | {"name": obj.name}


def send_instance(obj, name: str, matrix, groups: dict, messages: list[str]) -> dict:
    """Returns an instance of a light as Lightning's JSON: a light of its own, at another place."""
    return _settings(describe(obj, groups, messages, matrix) | {"on": True}, {}) | {"name": name}


def _settings(shown: dict, remembered: dict) -> dict:
    settings = dict(remembered.get("settings", {}))
    before = remembered.get("shown", {})
    if settings.get("type") != shown["type"]:
        settings, before = {}, {}
    settings.update({key: value for key, value in shown.items() if key not in settings or before.get(key, value) != value})
    if settings.get("unit", "relative") != "relative" and before.get("intensity") != shown["intensity"]:
        settings["unit"] = "relative"
    if shown["intensity"] != before.get("intensity") or "falloff" not in settings:
        settings["falloff"] = "custom" if shown["type"] == "directional" else "inverse_square"
    settings.pop("relative_intensity", None)
    for key in ("profile", "texture"):
        if not settings.get(key):
            settings.pop(key, None)
    return settings


def describe(obj, groups: dict, messages: list[str], matrix=None) -> dict:
    """Returns what Blender shows of a light, in Lightning's terms.

    Args:
        groups: the light groups of Lightning by name: Blender has no faders, so their factors are taken out of its lights
        matrix: transform of an instance of the light
    """
    light = obj.data
    group = groups.get(obj.lightgroup, {})
    kelvin, correction = _temperature(light)
    color, strength = light_nodes.color_and_strength(light, obj.name, messages)
    matrix = matrix or placement(obj)
    scale = matrix.to_scale()
    result = {
        "type": {"POINT": "point", "SPOT": "spot", "SUN": "directional"}.get(light.type, _area_type(light)),
        "color": [_ratio(axes.number(c) * e * k, g) for c, e, k, g in zip(light.color, color, correction, group.get("color", [1, 1, 1]))],
        "intensity": _ratio(max(axes.number(light.energy) * strength * _area_factor(light, scale) * _spread_gain(light), 0) * PER_WATT[light.type],
                            group.get("intensity", 1)),
        "exposure": axes.number(light.exposure),
        "temperature": axes.number(kelvin),
        "at": axes.vector(matrix.translation),
        "direction": axes.vector(-matrix.col[2].to_3d().normalized()),
        "up": axes.vector(matrix.col[1].to_3d().normalized()),
        "on": visibility.is_on(obj),
        "bank": obj.lightgroup,
        "illuminates": linking.to_names(obj.light_linking.receiver_collection),
        "shadowed_by": linking.to_names(obj.light_linking.blocker_collection),
        "casts_shadows": light.use_shadow,
        "diffuse": axes.number(light.diffuse_factor),
        "specular": axes.number(light.specular_factor),
    }
    if light.energy < 0:
        messages.append(f"{obj.name}: a negative strength became 0")
    if light.type in ("POINT", "SPOT"):
        result["radius"] = axes.number(light.shadow_soft_size)
        result["profile"] = light_nodes.profile(obj)[0]
        if light.type == "POINT" and result["profile"] and matrix.col[2].to_3d().normalized().z < 0.9999:
            messages.append(f"{obj.name}: its IES profile hangs straight down in Lightning")
    if light.type == "SPOT":
        result["angle"] = axes.degrees(light.spot_size / 2)
        result["dropoff"] = 0
        if max(scale) - min(scale) > 1e-4 * max(scale):
            messages.append(f"{obj.name}: the cone of a spot is not scaled")
    if light.type == "SUN":
        result["spread"] = axes.degrees(light.angle / 2)
    if light.type == "AREA":
        result["texture"] = light_nodes.texture_name(light)
        width, height = light.size * scale.x, (light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else light.size) * scale.y
        if result["type"] == "disc":
            result["radius"] = axes.number(math.sqrt(width * height) / 2)
            if not math.isclose(width, height, rel_tol=1e-5):
                messages.append(f"{obj.name}: an ellipse became a disc of the same area")
        else:
            result["width"], result["height"] = axes.number(width), axes.number(height)
        result["beam_spread"] = _beam_spread(light)
        if math.degrees(light.spread) < 2 * NARROWEST - 1e-3:
            messages.append(f"{obj.name}: its beam spread became {2 * NARROWEST} degrees, the smallest of Lightning")
    return result


def _temperature(light) -> tuple[float, list[float]]:
    """Returns a light's temperature in Lightning, and the factors by which its color differs there: of the light, or of its nodes."""
    node = light_nodes.black_body(light)
    shown = node.inputs["Temperature"].default_value if node is not None else None
    if not light.use_temperature:
        return temperature.in_lightning(shown) if node is not None else (temperature.NEUTRAL, [1, 1, 1])
    kelvin, factors = temperature.in_lightning(light.temperature)
    return kelvin, [f * c for f, c in zip(factors, temperature.black_body(shown))] if node is not None else factors


def _ratio(value: float, factor: float) -> float:
    return value if factor == 1 or factor == 0 else value / factor


def _area_type(light) -> str:
    return "disc" if light.type == "AREA" and light.shape in ("DISK", "ELLIPSE") else "rect"


def _beam_spread(light) -> float:
    """Returns the half-angle of an area light's beam in degrees; 90 for one without a limit."""
    return min(max(axes.degrees(light.spread / 2), NARROWEST), 90)


def _spread_gain(light) -> float:
    """Returns the factor along the axis by which Cycles makes a narrow area light brighter, so that its power stays.

    The light at angle x is 1 - tan(x) / tan(a), and the integral of that times cos(x) * sin(x) is (tan(a) - a) / (2 * tan(a)).
    """
    half = math.radians(_beam_spread(light)) if light.type == "AREA" else math.pi / 2
    return math.tan(half) / (math.tan(half) - half) if half < math.radians(89.999) else 1


def _area_factor(light, scale) -> float:
    """Returns the area that multiplies a strength that is not normalized."""
    if light.normalize:
        return 1
    if light.type == "AREA":
        height = light.size_y if light.shape in ("RECTANGLE", "ELLIPSE") else light.size
        area = light.size * scale.x * height * scale.y
        return area * (math.pi / 4 if light.shape in ("DISK", "ELLIPSE") else 1)
    if light.type == "SUN":
        return math.pi * math.sin(light.angle / 2) ** 2 if light.angle > 0 else 1
    return 4 * math.pi * light.shadow_soft_size ** 2 if light.shadow_soft_size > 0 else 4


def placement(obj):
    """Returns the world transform of an object; Blender does not compute it for objects that the view layer excludes."""
    if obj.name in bpy.context.view_layer.objects or obj.parent is not None:
        return obj.matrix_world
    return obj.matrix_basis


def receive(obj, settings: dict, groups: dict, messages: list[str]) -> None:
    """Changes a light object to what Lightning's light has become since it was sent."""
    remembered = memory.of_light(obj)
    before = remembered.get("settings", {})

    def changed(*keys: str) -> bool:
        return any(settings.get(key) != before.get(key, OLD.get(key)) for key in keys)

    light = obj.data
    kind = settings["type"]
    if changed("type") and (light.type != TYPES[kind] or _area_type(light) != kind):
        light.type = TYPES[kind]
        light = obj.data
        if kind in ("rect", "disc"):
            light.shape = "RECTANGLE" if kind == "rect" else "DISK"
        before = {}
    if changed("at", "direction", "up") and obj.parent is None and not obj.constraints:
        scale = placement(obj).to_scale()
        _place(obj, settings, before)
        obj.scale = scale
    elif changed("at", "direction", "up"):
        _place(obj, settings, before)
    bpy.context.view_layer.update()
    _receive_shape(obj, light, settings, changed, messages)
    _receive_strength(obj, light, settings, before, groups, messages)
    if changed("on", "bank") or not groups.get(settings["bank"], {}).get("on", True):
        is_lit = settings["on"] and groups.get(settings["bank"], {}).get("on", True)
        obj.hide_render = not is_lit
        obj.hide_viewport = obj.hide_viewport and not is_lit
        if is_lit and not visibility.is_on(obj):
            messages.append(f"{obj.name}: is on in Lightning, but its collection is off in Blender")
    if changed("illuminates"):
        obj.light_linking.receiver_collection = linking.to_collection(settings["illuminates"], f"{obj.name} illuminates", messages)
    if changed("shadowed_by"):
        obj.light_linking.blocker_collection = linking.to_collection(settings["shadowed_by"], f"{obj.name} shadowed by", messages)
    if changed("casts_shadows"):
        light.use_shadow = settings["casts_shadows"]
    if changed("diffuse"):
        light.diffuse_factor = settings["diffuse"]
    if changed("specular"):
        light.specular_factor = settings["specular"]
    if changed("bank"):
        obj.lightgroup = settings["bank"]
    for key, neutral, what in (("doors", [90, 90, 90, 90], "barn doors"), ("gobo", "", "the gobo"), ("texture", "", "the texture"), ("gains", {}, "gains"),
                               ("flag", False, "the flag"), ("filter", "none", "the filter")):
        if settings.get(key, neutral) != neutral and changed(key):
            messages.append(f"{obj.name}: {what} stay in Lightning only")
    if light.type == "AREA":
        for key, neutral, what in (("cone", 90, "the cone"), ("dropoff", 0, "the edge falloff"), ("profile", "", "the IES profile")):
            if settings.get(key, neutral) != neutral and changed(key):
                messages.append(f"{obj.name}: {what} stays in Lightning only")


def _place(obj, settings: dict, before: dict) -> None:
    if settings["type"] == "point" and before:
        # A point has no direction: its rotation stays.
        matrix = placement(obj).copy()
        matrix.translation = axes.blender_vector(settings["at"])
    elif settings["type"] == "directional" and before:
        matrix = axes.light_matrix(settings["at"], settings["direction"], settings["up"])
        matrix.translation = placement(obj).translation
    else:
        matrix = axes.light_matrix(settings["at"], settings["direction"], settings["up"])
    obj.matrix_world = matrix


def _receive_shape(obj, light, settings: dict, changed, messages: list[str]) -> None:
    scale = placement(obj).to_scale()
    if settings["type"] == "tube" and changed("type", "radius", "height"):
        light.shadow_soft_size = math.sqrt(settings["height"] * settings["radius"] / 2)
        messages.append(f"{obj.name}: a tube is a ball of the same area in Blender")
    elif light.type in ("POINT", "SPOT") and changed("type", "radius"):
        light.shadow_soft_size = settings["radius"]
    if light.type == "SPOT":
        if changed("type", "angle"):
            light.spot_size = math.radians(min(2 * settings["angle"], 180))
        if changed("type", "dropoff", "profile"):
            profile = settings.get("profile", "")
            if not profile.startswith("spot-"):
                light.spot_blend = _blend(settings["angle"], settings["dropoff"])
                if profile:
                    messages.append(f"{obj.name}: the IES profile stays in Lightning only")
    if light.type == "SUN" and changed("type", "spread"):
        light.angle = math.radians(2 * settings["spread"])
    if light.type == "AREA" and changed("type", "beam_spread") and "beam_spread" in settings:
        light.spread = math.radians(2 * settings["beam_spread"])
    if light.type == "AREA" and changed("type", "radius", "width", "height"):
        if settings["type"] == "disc":
            light.shape = "DISK"
            light.size = 2 * settings["radius"] / math.sqrt(abs(scale.x * scale.y))
        elif light.shape != "SQUARE" or settings["width"] != settings["height"]:
            light.shape = "RECTANGLE"
            light.size, light.size_y = settings["width"] / scale.x, settings["height"] / scale.y
        else:
            light.size = settings["width"] / scale.x


def _blend(angle: float, dropoff: float) -> float:
    """Returns the spot blend with which a spot has half its light at the same angle as with a dropoff."""
    outer = math.cos(math.radians(min(angle, 90)))
    half = 0.5 ** (1 / dropoff) if dropoff > 0 else 0
    return min(max(2 * (half - outer) / (1 - outer), 0), 1) if half > outer else 0


def _receive_strength(obj, light, settings: dict, before: dict, groups: dict, messages: list[str]) -> None:
    neutral = {"color": [1, 1, 1], "intensity": 1}
    keys = ("color", "intensity", "exposure", "temperature", "bank", "falloff", "attenuation", "unit", "beam_spread")
    group = groups.get(settings["bank"]) or neutral
    old_group = neutral | memory.of_light(obj).get("group", {})

    def changed_besides(*known: str) -> bool:
        return (any(settings.get(k) != before.get(k, OLD.get(k)) for k in keys if k not in known)
                or any(group[k] != old_group[k] for k in neutral))

    if before and not changed_besides():
        return
    kelvin = settings["temperature"]
    if before.get("temperature") != kelvin:
        node = light_nodes.black_body(light)
        had_temperature = light.use_temperature or node is not None
        if node is not None and not light.use_temperature:
            node.inputs["Temperature"].default_value = kelvin
        else:
            light.use_temperature = kelvin != temperature.NEUTRAL
            light.temperature = kelvin
        # What the programs' black bodies differ by depends on the temperature: it would change the color, too.
        if before and had_temperature and (light.use_temperature or node is not None) and not changed_besides("temperature"):
            return
    color, strength = light_nodes.color_and_strength(light, obj.name, messages)
    correction = _temperature(light)[1]
    node = light_nodes.own_emission(light)
    wanted = [c * g / k if k > 0 else 0 for c, g, k in zip(settings["color"], group["color"], correction)]
    if node is None:
        light.color = [c / e if e > 0 else 0 for c, e in zip(wanted, color)]
    else:
        # The light's own color and power are factors of its node's; they change only if no factor gives the result.
        if not all(own > 0 for own in light.color):
            light.color = (1, 1, 1)
        node.inputs["Color"].default_value = [c / own for c, own in zip(wanted, light.color)] + [1]
    light.exposure = settings["exposure"]
    intensity = settings.get("relative_intensity", settings["intensity"])
    if settings["falloff"] == "custom" and settings["type"] != "directional":
        constant, linear, quadratic = settings["attenuation"]
        intensity /= max(constant + linear + quadratic, 1) if constant or linear else quadratic or 1
        if constant or linear:
            messages.append(f"{obj.name}: its falloff is not inverse-square; Blender's light is equal at distance 1")
    factor = PER_WATT[light.type] * _area_factor(light, placement(obj).to_scale()) * _spread_gain(light)
    power = intensity * group["intensity"] / factor if factor > 0 else 0
    if node is not None and light.energy > 0:
        node.inputs["Strength"].default_value = power / light.energy
    else:
        light.energy = power / strength if strength > 0 else power
