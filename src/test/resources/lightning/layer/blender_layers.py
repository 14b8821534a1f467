"""Opens a picture in Blender. Prints as JSON the layers that its Image node lists, and those of its Cryptomatte node with the largest
difference between Blender's matte of an object and the file's.
"""

import json
import os
import re
import sys

import bpy
import numpy
import OpenEXR


def choices(node: object, name: str) -> list[str]:
    """Returns the values that a node's list offers; a wrong one makes Blender name them."""
    try:
        setattr(node, name, "?")
    except TypeError as error:
        return re.findall(r"'([^']*)'", str(error).split("not found in")[1])
    return []


def main(path: str, target: str) -> None:
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    tree = bpy.data.node_groups.new("compositor", "CompositorNodeTree")
    tree.interface.new_socket("Image", in_out="OUTPUT", socket_type="NodeSocketColor")
    scene.compositing_node_group = tree
    image = tree.nodes.new("CompositorNodeImage")
    image.image = bpy.data.images.load(path)
    passes = [socket.name for socket in image.outputs]
    mattes = tree.nodes.new("CompositorNodeCryptomatteV2")
    mattes.source = "IMAGE"
    mattes.image = image.image
    layers = choices(mattes, "layer_name")
    file = OpenEXR.File(path, separate_channels=True)
    header, channels = file.header(), file.channels()
    height, width = channels["R"].pixels.shape
    mattes.layer_name = "CryptoObject"
    manifest = next(json.loads(header[key[:-4] + "manifest"]) for key in header if key.endswith("/name") and header[key] == "CryptoObject")
    name = next(iter(manifest))
    mattes.matte_id = name
    output = tree.nodes.new("NodeGroupOutput")
    tree.links.new(mattes.outputs["Matte"], output.inputs[0])
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "BLENDER_WORKBENCH"
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.filepath = target
    bpy.ops.render.render(write_still=True)
    matte = OpenEXR.File(target, separate_channels=True).channels()["R"].pixels
    coverage = numpy.zeros((height, width), numpy.float32)
    for rank in range(3):
        for identity, share in (("R", "G"), ("B", "A")):
            bits = channels[f"CryptoObject0{rank}.{identity}"].pixels.view(numpy.uint32)
            coverage += numpy.where(bits == int(manifest[name], 16), channels[f"CryptoObject0{rank}.{share}"].pixels, 0)
    result = {"passes": passes, "layers": choices(image, "layer"), "mattes": layers, "largest": float(coverage.max()),
              "difference": float(abs(matte - coverage).max())}
    print("\nRESULT " + json.dumps(result), flush=True)
    os._exit(0)


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2])
