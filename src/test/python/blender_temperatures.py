"""Sends lights with color temperatures to Lightning, edits them there, and gets them back."""

import blender_scene as sample
import bpy

FILE = sample.FOLDER / "shot.jen"
PRECISION = 2e-6


def near(actual, expected) -> bool:
    return all(abs(a - e) <= PRECISION * max(1, abs(e)) for a, e in zip(actual, expected, strict=True))


def colors(text: str) -> list[str]:
    """Returns the lines of a scene with colors and temperatures."""
    return [line.strip() for line in text.splitlines() if " color " in line or " temperature " in line]


def with_node(name: str, kelvin: float, **values):
    """Adds a light whose color is that of a Blackbody node."""
    light = sample.add_light("POINT", name, (0, 0, 2), energy=60, **values)
    node, tree = sample.emission(light)
    body = tree.nodes.new("ShaderNodeBlackbody")
    body.inputs["Temperature"].default_value = kelvin
    tree.links.new(body.outputs["Color"], node.inputs["Color"])
    return light, body


sample.start()
from bl_ext.user_default.lightning import lights, temperature, transfer  # noqa: E402, after the add-on is enabled

for kelvin in (800, 1000, 1667, 2000, 2700, 3200, 4000, 5000, 6500, 8000, 12000, 20000):
    plain = sample.add_light("POINT", f"plain {kelvin}", energy=60, use_temperature=True, temperature=kelvin)
    noded, body = with_node(f"node {kelvin}", kelvin)
    # What Blender shows of a light with this temperature.
    color = plain.data.temperature_color
    for light in (plain, noded):
        shown = lights.describe(light, {}, [])
        assert near([c * t for c, t in zip(shown["color"], temperature.tint(shown["temperature"]))],
                    [c if t > 0 else 0 for c, t in zip(color, temperature.tint(shown["temperature"]))]), (kelvin, light.name, shown)
        if 1667 <= kelvin:
            assert near([shown["temperature"]], [kelvin]), shown
    bpy.data.objects.remove(plain)
    bpy.data.objects.remove(noded)

warm = sample.add_light("POINT", "Warm", (0, 0, 2), energy=60, use_temperature=True, temperature=3200)
bulb, body = with_node("Bulb", 2700, color=(1, 0.5, 0.25))
messages = transfer.send(bpy.context, FILE)
assert not [line for line in messages if "Bulb" in line], messages
assert "temperature 2700" in FILE.read_text(encoding="utf-8")
# The color of a light stays if only its temperature changes.
sample.set_in_file(FILE, "Warm.temperature=4500", "Bulb.temperature=3000")
edited = FILE.read_text(encoding="utf-8")
assert bpy.ops.lightning.get_lights(filepath=str(FILE)) == {"FINISHED"}
assert near([warm.data.temperature, *warm.data.color], [4500, 1, 1, 1]), list(warm.data.color)
assert near([body.inputs["Temperature"].default_value, *bulb.data.color], [3000, 1, 0.5, 0.25])
assert not bulb.data.use_temperature
assert bpy.ops.lightning.send(filepath=str(FILE)) == {"FINISHED"}
assert colors(FILE.read_text(encoding="utf-8")) == colors(edited), edited
# A color that was edited comes back.
sample.set_in_file(FILE, "Bulb.color=1 1 1")
assert bpy.ops.lightning.get_lights(filepath=str(FILE)) == {"FINISHED"}
assert near([c * t for c, t in zip(bulb.data.color, temperature.black_body(3000))], temperature.tint(3000)), list(bulb.data.color)
print("all temperatures are equal")
