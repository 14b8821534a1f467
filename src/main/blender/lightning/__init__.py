# SPDX-License-Identifier: Apache-2.0
"""Blender add-on of Lightning: sends the scene, and gets the lights back."""

import atexit
import textwrap
from pathlib import Path

import bpy
from bpy.props import BoolProperty, EnumProperty, StringProperty
from bpy_extras.io_utils import ExportHelper, ImportHelper

from . import live, picture, program, transfer


class LightningPreferences(bpy.types.AddonPreferences):
    """Preferences of the add-on."""

    bl_idname = __package__

    program: StringProperty(name="Lightning", subtype="FILE_PATH",
                            description="Program of Lightning, bin/lightning; empty to search for it")

    def draw(self, context):
        self.layout.prop(self, "program")


class LIGHTNING_OT_send(bpy.types.Operator, ExportHelper):
    """Write the scene for Lightning, with all of its lights"""

    bl_idname = "lightning.send"
    bl_label = "Send to Lightning"
    bl_options = {"REGISTER"}
    filename_ext = ".jen"
    filter_glob: StringProperty(default="*.jen", options={"HIDDEN"})
    overwrite: BoolProperty(name="Overwrite Edits", default=False,
                            description="Replace a scene that was edited in Lightning since it was sent, with its lights")
    open_editor: BoolProperty(name="Open Lightning", default=True, description="Open the scene in Lightning's window")

    def execute(self, context):
        target = Path(bpy.path.abspath(self.filepath))
        try:
            messages = transfer.send(context, target, self.overwrite)
            if self.open_editor and not bpy.app.background:
                program.start_editor(target)
        except (program.ProgramError, OSError, RuntimeError) as e:
            self.report({"ERROR"}, str(e))
            return {"CANCELLED"}
        context.scene.lightning_file = str(target)
        _report(self, messages, f"Sent to {target.name}")
        return {"FINISHED"}


class LIGHTNING_OT_get_lights(bpy.types.Operator, ImportHelper):
    """Bring back the lights that were edited or added in Lightning"""

    bl_idname = "lightning.get_lights"
    bl_label = "Get Lights from Lightning"
    bl_options = {"REGISTER", "UNDO"}
    filename_ext = ".jen"
    filter_glob: StringProperty(default="*.jen", options={"HIDDEN"})
    remove: BoolProperty(name="Remove Deleted Lights", default=True,
                         description="Remove lights that were sent to Lightning and deleted there")
    from_another: BoolProperty(name="From Another Scene", default=False,
                               description="Add the lights of a file that was not sent from this scene; those of this scene stay")

    def execute(self, context):
        try:
            source = Path(bpy.path.abspath(self.filepath))
            messages = transfer.get_lights(context, source, self.remove, self.from_another)
        except (program.ProgramError, OSError, RuntimeError) as e:
            self.report({"ERROR"}, str(e))
            return {"CANCELLED"}
        if transfer.is_sent_to(context.scene, source):
            context.scene.lightning_file = self.filepath
        _report(self, messages, "Lights received")
        return {"FINISHED"}


class LIGHTNING_OT_live_view(bpy.types.Operator):
    """Show Lightning's picture in the image "Lightning" and follow edits, or stop it"""

    bl_idname = "lightning.live_view"
    bl_label = "Live View"
    bl_options = {"REGISTER"}

    def execute(self, context):
        if live.view() is not None:
            live.stop()
            return {"FINISHED"}
        try:
            live.start(context.scene)
        except (program.ProgramError, OSError) as e:
            self.report({"ERROR"}, str(e))
            return {"CANCELLED"}
        return {"FINISHED"}


def _report(operator, messages: list[str], summary: str) -> None:
    for message in messages:
        operator.report({"WARNING"}, message)
    operator.report({"INFO"}, summary)


class LIGHTNING_PT_panel(bpy.types.Panel):
    """Panel in the sidebar of the 3D view."""

    bl_label = "Lightning"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Lightning"

    def draw(self, context):
        file = context.scene.lightning_file
        self.layout.prop(context.scene, "lightning_file")
        self.layout.prop(context.scene, "lightning_indirect")
        for name, icon in (("lightning.send", "EXPORT"), ("lightning.get_lights", "IMPORT")):
            row = self.layout.row()
            # With a file, the buttons act without asking for one.
            row.operator_context = "EXEC_DEFAULT" if file else "INVOKE_DEFAULT"
            operator = row.operator(name, icon=icon)
            if file:
                operator.filepath = file
        view = live.view()
        self.layout.operator("lightning.live_view", icon="PAUSE" if view else "PLAY", text="Stop Live View" if view else "Live View",
                             depress=view is not None)
        if view:
            # A label does not wrap its text; a letter is about eight pixels wide, an icon as wide as five letters.
            letters = max(context.region.width / (8 * context.preferences.system.ui_scale), 20)
            icon = "ERROR" if view.error else "NONE"
            for line in textwrap.wrap(view.status, int(letters), initial_indent="     " if view.error else ""):
                self.layout.label(text=line.strip(), icon=icon)
                icon = "NONE"


def _draw_export(self, _context) -> None:
    self.layout.operator(LIGHTNING_OT_send.bl_idname, text="Lightning (.jen)")


def _draw_import(self, _context) -> None:
    self.layout.operator(LIGHTNING_OT_get_lights.bl_idname, text="Lights from Lightning (.jen)")


CLASSES = (LightningPreferences, LIGHTNING_OT_send, LIGHTNING_OT_get_lights, LIGHTNING_OT_live_view, LIGHTNING_PT_panel)


def register() -> None:
    """Adds the add-on's operators, panel and menu items."""
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.Scene.lightning_file = StringProperty(name="Scene", subtype="FILE_PATH", description="Scene file that is sent and read")
    bpy.types.Scene.lightning_indirect = EnumProperty(name="Indirect Light", items=picture.INDIRECT, default="AUTO")
    bpy.types.TOPBAR_MT_file_export.append(_draw_export)
    bpy.types.TOPBAR_MT_file_import.append(_draw_import)
    atexit.register(live.stop)


def unregister() -> None:
    """Removes what `register` added."""
    atexit.unregister(live.stop)
    live.stop()
    bpy.types.TOPBAR_MT_file_export.remove(_draw_export)
    bpy.types.TOPBAR_MT_file_import.remove(_draw_import)
    del bpy.types.Scene.lightning_file, bpy.types.Scene.lightning_indirect
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
