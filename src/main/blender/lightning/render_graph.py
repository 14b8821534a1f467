# SPDX-License-Identifier: Apache-2.0
"""Blender's render depsgraph: objects as a render shows them, with the render levels of their modifiers.

Blender gives this graph to render engines only. So an engine that draws nothing "bakes" a triangle; unlike a render, this leaves the user's
render result as it is.
"""

import bpy

# Whether updates of Blender come from here, and are no edits.
is_reading = False


class _Reader(bpy.types.RenderEngine):
    """Engine that passes its depsgraph to a function."""

    bl_idname = "LIGHTNING_READER"
    bl_label = "Lightning's reader"
    function = None
    error: BaseException | None = None

    def bake(self, depsgraph, obj, pass_type, pass_filter, width, height):
        function, _Reader.function = _Reader.function, None
        try:
            function(depsgraph)
        except BaseException as e:  # Blender would only print it.
            _Reader.error = e


def visit(scene, function) -> None:
    """Calls a function with the render depsgraph of a scene and the context's view layer. What it gets is valid only during the call.

    Raises:
        RuntimeError: Blender cannot evaluate the scene, such as during a render
    """
    global is_reading
    # Handlers get the user's edits first.
    bpy.context.view_layer.update()
    is_reading = True
    try:
        _bake(scene, function)
        bpy.context.view_layer.update()
    finally:
        is_reading = False


def _bake(scene, function) -> None:
    triangle = bpy.data.meshes.new("lightning reader")
    triangle.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    triangle.color_attributes.new("color", "FLOAT_COLOR", "POINT")
    obj = bpy.data.objects.new(triangle.name, triangle)
    engine = scene.render.engine
    bpy.utils.register_class(_Reader)
    _Reader.function, _Reader.error = (lambda depsgraph: function(depsgraph, obj)), None
    try:
        scene.collection.objects.link(obj)
        scene.render.engine = _Reader.bl_idname
        with bpy.context.temp_override(active_object=obj, object=obj, selected_objects=[obj], selected_editable_objects=[obj]):
            bpy.ops.object.bake(type="EMIT", target="VERTEX_COLORS", use_selected_to_active=False)
        is_read = _Reader.function is None
    finally:
        _Reader.function = None
        scene.render.engine = engine
        bpy.utils.unregister_class(_Reader)
        bpy.data.objects.remove(obj)
        bpy.data.meshes.remove(triangle)
    error, _Reader.error = _Reader.error, None
    if error is not None:
        raise error
    if not is_read:
        raise RuntimeError("Blender did not evaluate the scene for a render")
