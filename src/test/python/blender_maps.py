"""Sends materials whose roughness or metalness comes from an image through nodes, and writes the messages."""

import blender_scene as sample
import bpy

sample.start()
# Red, green, blue and alpha of the left pixel; the right one is black and transparent.
LEFT = [51 / 255, 102 / 255, 153 / 255, 204 / 255]


def picture(name: str, space: str):
    """Returns an image of two pixels."""
    result = bpy.data.images.new(name, 2, 1, alpha=True)
    result.colorspace_settings.name = space
    result.pixels = LEFT + [0.0] * 4
    result.pack()
    return result


NUMBERS = picture("numbers", "Non-Color")


class Look:
    """A material on a plane."""

    def __init__(self, name: str, image=NUMBERS) -> None:
        self.material = bpy.data.materials.new(name)
        self.tree = self.material.node_tree
        self.shader = self.tree.nodes["Principled BSDF"]
        self.image = self.node("ShaderNodeTexImage")
        self.image.image = image
        bpy.ops.mesh.primitive_plane_add()
        bpy.context.object.data.materials.append(self.material)

    def node(self, kind: str, *inputs, **settings):
        """Adds a node; inputs that are sockets are linked."""
        result = self.tree.nodes.new(kind)
        for key, value in settings.items():
            setattr(result, key, value)
        for socket, value in zip(result.inputs, inputs):
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, socket)
            elif value is not None:
                socket.default_value = value
        return result

    def channel(self, name: str):
        """Returns a channel of the image."""
        return self.node("ShaderNodeSeparateColor", self.image.outputs["Color"]).outputs[name]

    def link(self, output, socket: str = "Roughness") -> None:
        """Links an output to the shader."""
        self.tree.links.new(output, self.shader.inputs[socket])


look = Look("channels")
look.link(look.channel("Red"))
look.link(look.channel("Blue"), "Metallic")
look = Look("direct")
look.link(look.image.outputs["Color"])
look = Look("alpha")
look.link(look.image.outputs["Alpha"])
look = Look("curved", picture("curved", "sRGB"))
look.link(look.channel("Green"))
look = Look("product")
look.link(look.node("ShaderNodeMath", look.channel("Green"), 0.5, operation="MULTIPLY").outputs[0])
look = Look("large")
look.link(look.node("ShaderNodeMath", look.channel("Green"), 2.0, operation="MULTIPLY").outputs[0])
look = Look("inverted")
look.link(look.node("ShaderNodeInvert", 1.0, look.channel("Green")).outputs[0])
look = Look("mapped")
look.link(look.node("ShaderNodeMapRange", look.channel("Blue"), 0.0, 1.0, 0.25, 0.75).outputs[0], "Metallic")
look = Look("ramp")
ramp = look.node("ShaderNodeValToRGB", look.channel("Green"))
ramp.color_ramp.elements[0].color = (1, 1, 1, 1)
ramp.color_ramp.elements[1].color = (0.5, 0.5, 0.5, 1)
look.link(ramp.outputs["Color"])
look = Look("mixed")
mixed = look.node("ShaderNodeMix", 0.25, data_type="FLOAT")
mixed.inputs[2].default_value = 1
look.tree.links.new(look.channel("Green"), mixed.inputs[3])
look.link(mixed.outputs[0])
look = Look("placed")
color = look.node("ShaderNodeTexImage")
color.image = picture("colors", "sRGB")
for image, place, angle, scale in ((color, (0.25, 0.5, 0), 0.0, (2, 2, 1)), (look.image, (0.125, 0.75, 0), 0.5, (3, 1.5, 1))):
    mapping = look.node("ShaderNodeMapping", look.node("ShaderNodeUVMap").outputs[0], place, (0, 0, angle), scale)
    look.tree.links.new(mapping.outputs[0], image.inputs["Vector"])
look.link(color.outputs["Color"], "Base Color")
look.link(look.channel("Green"))
look = Look("apart")
metal = look.node("ShaderNodeTexImage")
metal.image = NUMBERS
look.tree.links.new(look.node("ShaderNodeMapping", look.node("ShaderNodeUVMap").outputs[0], None, None, (4, 4, 1)).outputs[0], metal.inputs["Vector"])
look.link(metal.outputs["Color"], "Metallic")
look.link(look.channel("Green"))
look = Look("constant")
look.link(look.node("ShaderNodeMath", 0.75, 0.5, operation="SUBTRACT").outputs[0])
look = Look("unknown")
shifted = look.node("ShaderNodeHueSaturation")
look.tree.links.new(look.image.outputs["Color"], shifted.inputs["Color"])
look.link(shifted.outputs[0])
look = Look("noisy")
look.link(look.node("ShaderNodeTexNoise").outputs[0])
look = Look("lacquer")
look.link(look.channel("Blue"), "Coat Weight")
look.link(look.node("ShaderNodeInvert", 1.0, look.channel("Green")).outputs[0], "Coat Roughness")
look = Look("level")
look.link(look.channel("Green"), "Specular IOR Level")
look = Look("tinted")
look.link(look.node("ShaderNodeMix", 0.5, data_type="RGBA").outputs[2], "Specular Tint")
tint = look.shader.inputs["Specular Tint"].links[0].from_node
tint.inputs[6].default_value = (1, 1, 1, 1)
look.tree.links.new(look.image.outputs["Color"], tint.inputs[7])
look = Look("fibers")
look.link(look.channel("Red"), "Sheen Weight")
look.shader.inputs["Sheen Tint"].default_value = (1, 0.5, 0, 1)
look.link(look.channel("Blue"), "Sheen Roughness")
look = Look("cut")
cut = look.node("ShaderNodeMixShader", 0.5, look.node("ShaderNodeBsdfTransparent").outputs[0], look.shader.outputs[0])
look.tree.links.new(cut.outputs[0], look.tree.nodes["Material Output"].inputs["Surface"])
look.link(look.channel("Green"))
look.link(look.channel("Blue"), "Metallic")
look = Look("grouped")
group = bpy.data.node_groups.new("half", "ShaderNodeTree")
group.interface.new_socket("Value", in_out="INPUT", socket_type="NodeSocketFloat")
group.interface.new_socket("Value", in_out="OUTPUT", socket_type="NodeSocketFloat")
start, half, end = (group.nodes.new(kind) for kind in ("NodeGroupInput", "ShaderNodeMath", "NodeGroupOutput"))
half.operation = "MULTIPLY"
half.inputs[1].default_value = 0.5
group.links.new(start.outputs[0], half.inputs[0])
group.links.new(half.outputs[0], end.inputs[0])
outer = look.node("ShaderNodeGroup")
outer.node_tree = group
look.tree.links.new(look.channel("Green"), outer.inputs[0])
look.link(outer.outputs[0])

from bl_ext.user_default.lightning import transfer  # noqa: E402, after the add-on is installed

before = len(bpy.data.images), len(bpy.data.materials)
messages = transfer.send(bpy.context, sample.FOLDER / "scene.jen")
assert before == (len(bpy.data.images), len(bpy.data.materials))
(sample.FOLDER / "messages.txt").write_text("\n".join(messages), encoding="utf-8")
print("sent")
