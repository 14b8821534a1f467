# SPDX-License-Identifier: Apache-2.0
"""The live view: follows edits in Blender, and shows Lightning's exact picture in an image.

A server of Lightning has the scene open. An edit of lights or of the world becomes edits there. For any other edit, the scene that was
exported gets the edit too, or is exported again, and replaces the open one. In each case the server recomputes only what changed. `pump`
does the next step and never waits for the server.
"""

import shutil
import tempfile
import time
from pathlib import Path

import bpy

from . import gltf, instanced_lights, lights, memory, model_export, picture, program, render_graph, shot, transfer, visibility, words
from .lightning_relight import Client, RequestError
from .model import Model
from .pictures import Pictures
from .snapshot import Snapshot

# Objects that have no mesh in the file.
BARE_TYPES = ("LIGHT", "CAMERA", "EMPTY")
# Most seconds without another edit until a scene is exported again, and those until a slow picture of older lights is canceled.
SEND_DELAY = 0.3
CANCEL_DELAY = 0.1
# Seconds after which a picture of older lights is slow.
SLOW = 0.5

# A light group that changes nothing.
NEUTRAL = {"on": True, "solo": False, "intensity": 1, "color": [1, 1, 1]}


class LiveView:
    """A scene of Blender that a server of Lightning has open."""

    def __init__(self, scene) -> None:
        self.scene_name = scene.name
        self.error = ""
        self.milliseconds = 0.0
        self.coarse_milliseconds = 0.0
        self.pictures = 0
        self._folder = Path(tempfile.mkdtemp(prefix="lightning-live-"))
        self._sent = 0
        self._opening = None
        self._model: Model | None = None
        self._export_seconds = 0.0
        self._edits: list = []
        self._number = None
        self._names: dict[str, str] = {}
        self._lights: dict[str, dict] = {}
        # Lights in instances by their names in Lightning: the object's name, and the matrix.
        self._instances: dict[str, tuple] = {}
        self._groups: dict = {}
        self._world: dict = {}
        self._structure: tuple = ()
        self._choice = self._indirect = ""
        self._is_stale = False
        self._is_world_stale = False
        self._stale_materials: set[str] = set()
        self._must_send = True
        self._changed_at = 0.0
        self._edited_at = time.perf_counter()
        try:
            self._client = Client(program=program.find())
            self._pictures = Pictures(self._client)
        except BaseException:
            shutil.rmtree(self._folder, ignore_errors=True)
            raise

    @property
    def status(self) -> str:
        """One line for the user."""
        if self.error:
            return self.error
        if self._must_send or self._opening and not self.pictures:
            return "Sending the scene"
        return "Rendering" if self._pictures.is_waiting or not self.pictures else f"{self.milliseconds:.0f} ms from edit to picture"

    def is_idle(self) -> bool:
        """Returns whether the image shows the scene as it is, or an error stopped it."""
        return bool(self.error) or not (self._must_send or self._opening or self._pictures.is_waiting or self._edits or self._is_stale or self._is_world_stale)

    def note(self, scene, depsgraph) -> None:
        """Notes what an update of Blender changed."""
        if scene.name != self.scene_name or depsgraph.mode != "VIEWPORT" or render_graph.is_reading:
            return
        was_current = not (self._is_stale or self._is_world_stale or self._must_send)
        for update in depsgraph.updates:
            block = update.id
            if isinstance(block, bpy.types.World):
                self._is_world_stale = True
            elif isinstance(block, (bpy.types.Light, bpy.types.Camera, bpy.types.Object, bpy.types.Collection, bpy.types.Scene)):
                self._is_stale = True
                is_shape = isinstance(block, bpy.types.Object) and block.type not in BARE_TYPES
                self._must_send |= is_shape and update.is_updated_geometry
            elif isinstance(block, bpy.types.Material):
                self._is_stale = True
                self._stale_materials.add(block.name)
            elif isinstance(block, (bpy.types.Mesh, bpy.types.Curve, bpy.types.MetaBall)):
                # An edit of a material updates the shading of its meshes.
                self._must_send |= update.is_updated_geometry
        if self._is_stale or self._is_world_stale or self._must_send:
            self.error = ""
            self._changed_at = time.perf_counter()
            if was_current:
                self._edited_at = self._changed_at

    def refresh(self) -> None:
        """Looks for changes that Blender tells nobody about, such as another size of the picture."""
        self._is_stale = True

    def pump(self) -> None:
        """Does what can be done now. An error ends up in `error`."""
        try:
            self._step()
        except BrokenPipeError:
            self._fail("the server has ended")
        except (OSError, RuntimeError, RequestError, program.ProgramError) as e:
            self._fail(str(e))

    def _fail(self, message: str) -> None:
        self.error = " ".join(message.split()) or "the live view stopped"
        self._clear_notes()
        self._opening = None
        self._pictures.cancel()
        self._edits = []

    def _clear_notes(self) -> None:
        self._must_send = self._is_stale = self._is_world_stale = False
        self._stale_materials = set()

    def _step(self) -> None:
        scene = bpy.data.scenes.get(self.scene_name)
        if scene is None or bpy.context.scene != scene:
            return
        self._receive_edits()
        self._receive_picture(scene)
        if self._opening is not None:
            self._receive_opened()
        elif self._must_send:
            # An export blocks Blender: during a drag, it must not take all of the time.
            if not self._sent or time.perf_counter() - self._changed_at >= min(SEND_DELAY, self._export_seconds):
                self._send(scene)
        elif self._is_stale or self._is_world_stale:
            self._edit(scene)

    def _send(self, scene) -> None:
        """Exports the scene and sends it."""
        start, edited_at = time.perf_counter(), self._edited_at
        self._clear_notes()
        self._pictures.cancel()
        self._model = None
        self._sent += 1
        target = self._target()
        target.parent.mkdir()
        self._copy_files(scene, target.parent)
        with visibility.evaluated(), Snapshot(scene) as snapshot:
            root, rest = model_export.export(scene, snapshot, target.with_suffix(".glb"), {})
            target.with_suffix(".glb").unlink()
            model = Model(scene, root, snapshot.watched)
            transfer.complete(scene, target, root, snapshot, [])
            names = instanced_lights.names(snapshot, [obj.name for obj in transfer.lamps(scene)])
            self._instances = {name: (obj.name, matrix) for name, (obj, _, matrix) in zip(names, snapshot.lights)}
        gltf.write_binary(target.with_suffix(".bin"), rest)
        self._groups = memory.of_scene(scene).get("banks", {})
        self._lights = self._describe(scene)
        settings = root["extras"][memory.PROPERTY]
        self._world = settings["world"]
        self._structure = self._describe_structure(scene)
        if self._choice != picture.indirect(scene):
            self._choice = self._indirect = picture.indirect(scene)
        # The export itself is no edit.
        bpy.context.view_layer.update()
        self._clear_notes()
        self._edited_at = edited_at
        self._model = model
        self._replace("export")
        self._export_seconds = time.perf_counter() - start

    def _replace(self, kind: str) -> None:
        """Lets the server import the exported scene, in place of the one that is open, after an edit of some kind."""
        target = self._target()
        model = target.with_suffix(".gltf")
        gltf.write_text(model, self._model.root, target.with_suffix(".bin").name)
        fields = {"file": str(model), "output": str(target), "indirect": self._indirect}
        if self._number is None:
            self._opening = self._client.send("open", **fields)
        else:
            self._opening = self._client.send("replace", scene=self._number, **fields)
            self._request_picture(kind)

    def _target(self) -> Path:
        return self._folder / str(self._sent) / "live.jen"

    def _copy_files(self, scene, folder: Path) -> None:
        """Copies files that lights got in Lightning, such as gobos and textures."""
        source = Path(bpy.path.abspath(scene.lightning_file)).parent if scene.lightning_file else None
        settings = [memory.of_light(obj).get("settings", {}) for obj in transfer.lamps(scene)] + [memory.of_scene(scene).get("world", {})]
        for name in [s[key] for s in settings for key in ("gobo", "profile", "texture", "environment") if s.get(key)]:
            if source and (source / name).is_file() and (source / name).resolve().is_relative_to(source.resolve()):
                shutil.copyfile(source / name, folder / Path(name).name)

    def _receive_opened(self) -> None:
        if not self._opening.done():
            return
        answer, self._opening = self._opening, None
        result = answer.result()
        is_new = self._number is None
        self._number = result["scene"]
        # Automatic is decided once, so that a moving camera does not switch it.
        self._indirect = "on" if result["indirect"] else "off"
        names = result["lights"] if len(result["lights"]) == len(self._lights) else list(self._lights)
        self._names = dict(zip(self._lights, names))
        shutil.rmtree(self._folder / str(self._sent - 1), ignore_errors=True)
        if is_new:
            self._request_picture("export")

    def _lamps(self, scene) -> list:
        instances = [bpy.data.objects.get(name) for name, _ in self._instances.values()]
        return list(dict.fromkeys([*transfer.lamps(scene), *(obj for obj in instances if obj is not None)]))

    def _describe(self, scene) -> dict[str, dict]:
        result = {obj.name: lights.send(obj, self._groups, []) for obj in transfer.lamps(scene)}
        for name, (object_name, matrix) in self._instances.items():
            obj = bpy.data.objects.get(object_name)
            if obj is not None:
                result[name] = lights.send_instance(obj, name, matrix, self._groups, [])
        return result

    def _describe_structure(self, scene) -> tuple:
        """Returns what only sending can change, as far as it is quick to compare."""
        shown = [(obj.name, obj.instance_type, obj.visible_camera) for obj in scene.objects
                 if (obj.type not in BARE_TYPES or obj.instance_type != "NONE") and visibility.is_on(obj)]
        shown += [(obj.name, obj.hide_render, obj.visible_camera) for obj in visibility.in_instances(scene)]
        groups = {name: group for name, group in memory.of_scene(scene).get("banks", {}).items()
                  if any(group.get(key, neutral) != neutral for key, neutral in NEUTRAL.items())}
        return shot.size(scene), scene.lightning_indirect, picture.bounces(scene), shown, scene.camera and scene.camera.name, groups

    def _edit(self, scene) -> None:
        """Sends the changes and requests a picture."""
        if self._pictures.is_waiting:
            has_paused = time.perf_counter() - self._changed_at > CANCEL_DELAY
            is_slow = self.pictures and self._pictures.seconds > SLOW and has_paused
            if not is_slow and not self._pictures.is_coarse_shown:
                return
            self._pictures.cancel()
        is_world_stale, stale_materials = self._is_world_stale, self._stale_materials
        self._clear_notes()
        after = self._describe(scene)
        kept = [name for name in self._lights if name in after]
        is_same_type = all(after[name]["type"] == self._lights[name]["type"] for name in kept)
        is_same_order = list(after)[:len(kept)] == kept
        if (self._number is None or self._model is None or not is_same_type or not is_same_order
                or self._describe_structure(scene) != self._structure):
            self._must_send = True
            return
        is_model_edited = self._model.edit(scene, stale_materials)
        if is_model_edited is None:
            self._must_send = True
            return
        if is_model_edited:
            self._edit_model(scene, after, is_world_stale, "material" if stale_materials else "object")
            return
        requests = [("delete", {"light": words.quoted(self._names[name])}) for name in self._lights if name not in after]
        edits: list[str] = []
        for name, settings in after.items():
            if name not in self._lights:
                self._names[name] = name
                requests.append(("add", {"light": f"{words.quoted(name)} {settings['type']}"}))
            edits += words.edits(words.quoted(self._names[name]), self._lights.get(name, {"type": settings["type"]}), settings)
        if any(".profile=" in edit or ".texture=" in edit for edit in edits):
            self._write_files(scene)
        self._lights = after
        if is_world_stale:
            edits += self._edit_world(scene)
        if edits:
            requests.append(("set", {"edits": edits, "gesture": "live"}))
        if requests:
            self._edits += [self._client.send(method, scene=self._number, **fields) for method, fields in requests]
            self._request_picture("light")

    def _edit_model(self, scene, after: dict[str, dict], is_world_stale: bool, kind: str) -> None:
        """Sends the exported scene with an edit of it, and with the lights and the world as they are now."""
        if is_world_stale:
            self._edit_world(scene)
            if self._must_send:
                return
        self._write_files(scene)
        self._lights = after
        settings = self._model.root["extras"][memory.PROPERTY]
        groups = dict.fromkeys(obj.lightgroup for obj in self._lamps(scene) if obj.lightgroup)
        if scene.camera is not None:
            settings |= {"distance": shot.target_distance(scene.camera.data), "shift": shot.shift(scene), "lens": shot.lens(scene)}
        settings |= {"world": self._world, "banks": transfer.light_groups(self._groups, groups), "lights": list(after.values())}
        self._replace(kind)

    def _write_files(self, scene) -> None:
        for obj in self._lamps(scene):
            transfer.write_files(obj, self._target().parent, [])

    def _edit_world(self, scene) -> list[str]:
        """Describes the world again. Returns the edits of it."""
        before = self._world
        # A changed image gets another name.
        target = self._target().with_stem(f"live-{time.monotonic_ns()}")
        after = transfer.world_settings(scene, target, [])
        old, new = before.get("environment"), after.get("environment")
        if old and new and (target.parent / old).read_bytes() == (target.parent / new).read_bytes():
            (target.parent / new).unlink()
            after["environment"] = old
        if before.keys() - after.keys() - {"environment"}:
            self._must_send = True
            return []
        self._world = after
        return words.edits("world", before, after)

    def _receive_edits(self) -> None:
        while self._edits and self._edits[0].done():
            try:
                self._edits.pop(0).result()
            except RequestError:
                # Such as a link to an object that was not sent.
                self._edits = []
                self._must_send = True

    def _request_picture(self, kind: str) -> None:
        self._pictures.request(self._number, kind, 0 if kind == "light" else float("inf"))

    def _receive_picture(self, scene) -> None:
        if self._pictures.show_coarse(shot.size(scene)):
            self.coarse_milliseconds = 1000 * (time.perf_counter() - self._edited_at)
        if not self._pictures.show_exact():
            return
        self.pictures += 1
        self.milliseconds = 1000 * (time.perf_counter() - self._edited_at)
        if self._is_stale or self._is_world_stale:
            self._edited_at = self._changed_at

    def close(self) -> None:
        """Ends the server."""
        try:
            self._client.close()
        except OSError:
            pass  # The server has ended.
        shutil.rmtree(self._folder, ignore_errors=True)


_view: LiveView | None = None


def view() -> LiveView | None:
    """Returns the running live view."""
    return _view


def start(scene) -> None:
    """Starts the live view of a scene."""
    global _view
    stop()
    _view = LiveView(scene)
    bpy.app.handlers.depsgraph_update_post.append(_note)
    bpy.app.handlers.load_pre.append(_stop_before_load)
    _wake()


def stop() -> None:
    """Stops the live view; its last picture stays."""
    global _view
    if _view is None:
        return
    closing, _view = _view, None
    for handlers, function in ((bpy.app.handlers.depsgraph_update_post, _note), (bpy.app.handlers.load_pre, _stop_before_load)):
        if function in handlers:
            handlers.remove(function)
    if bpy.app.timers.is_registered(_tick):
        bpy.app.timers.unregister(_tick)
    closing.close()
    _redraw()


def _note(scene, depsgraph) -> None:
    if _view is not None:
        _view.note(scene, depsgraph)
        if not _view.is_idle():
            _wake()


def _wake() -> None:
    if not bpy.app.timers.is_registered(_tick):
        bpy.app.timers.register(_tick)


def _tick() -> float | None:
    """Pumps until the image shows the scene; returns the seconds until the next call."""
    if _view is None:
        return None
    before = (_view.status, _view.pictures)
    _view.pump()
    if (_view.status, _view.pictures) != before:
        _redraw()
    return None if _view.is_idle() else 0.003


def _redraw() -> None:
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type in ("IMAGE_EDITOR", "VIEW_3D"):
                area.tag_redraw()


@bpy.app.handlers.persistent
def _stop_before_load(*_) -> None:
    stop()
