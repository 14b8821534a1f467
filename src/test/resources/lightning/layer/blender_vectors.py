"""Renders the second frame of a moving wall by Cycles, and prints its motion vectors at the picture's center.

The wall is a square of 4 units in the plane z = 0. The camera is 10 units away, has a vertical field of view of 40 degrees, and a picture of
40 x 40 pixels.
"""

import json
import math
import sys

import bpy
import OpenEXR


def main(path: str) -> None:
    scene = bpy.context.scene
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.mesh.primitive_plane_add(size=4)
    wall = bpy.context.object
    for frame, x, y in ((1, -0.5, 0.25), (2, 0, 0), (3, 1, 0.75)):
        wall.location = (x, y, 0)
        wall.keyframe_insert("location", frame=frame)
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "VERTICAL"
    lens.angle = math.radians(40)
    camera = bpy.data.objects.new("camera", lens)
    camera.location = (0, 0, 10)
    scene.collection.objects.link(camera)
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 1
    scene.render.resolution_x = scene.render.resolution_y = 40
    scene.render.resolution_percentage = 100
    scene.view_layers[0].use_pass_vector = True
    if hasattr(scene.render.image_settings, "media_type"):
        scene.render.image_settings.media_type = "MULTI_LAYER_IMAGE"
    scene.render.image_settings.file_format = "OPEN_EXR_MULTILAYER"
    scene.render.filepath = path
    scene.frame_set(2)
    bpy.ops.render.render(write_still=True)
    file = OpenEXR.File(path, separate_channels=True)
    channels = {name: channel for part in file.parts for name, channel in part.channels.items()}
    print("RESULT " + json.dumps({axis: float(channels[f"ViewLayer.Vector.{axis}"].pixels[20, 20]) for axis in "XYZW"}))


if __name__ == "__main__":
    main(sys.argv[1])
