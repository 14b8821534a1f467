# SPDX-License-Identifier: Apache-2.0
"""The live view: follows edits in Blender, and shows Lightning's exact picture in an image.

A server of Lightning has the scene open. An edit of lights or of the world becomes edits there, which recompute only what they change;
any other edit sends the scene again. `pump` does the next step and never waits for the server.
"""

import shutil
import tempfile
import time
from pathlib import Path

import bpy
import numpy

from . import lights, program, shot, transfer, words
from .lightning_relight import Client, RequestError

IMAGE = "Lightning"
# Seconds without another edit until a scene is sent again, and until a slow picture of older lights is canceled.
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
        self.pictures = 0
        self._folder = Path(tempfile.mkdtemp(prefix="lightning-live-"))
        self._sent = 0
        self._import = None
        self._opening = None
        self._edits: list = []
        self._render = None
        self._render_start = 0.0
        self._number = None
        self._names: dict[str, str] = {}
        self._lights: dict[str, dict] = {}
        self._groups: dict = {}
        self._world: dict = {}
        self._structure: tuple = ()
        self._is_stale = False
        self._is_world_stale = False
        self._must_send = True
        self._changed_at = 0.0
        self._edited_at = time.perf_counter()
        try:
            self._client = Client(program=program.find())
        except BaseException:
            shutil.rmtree(self._folder, ignore_errors=True)
            raise

    @property
    def status(self) -> str:
        """One line for the user."""
        if self.error:
            return self.error
        if self._import or self._opening or self._must_send:
            return "Sending the scene"
        return "Rendering" if self._render or not self.pictures else f"{self.milliseconds:.0f} ms from edit to picture"

    def is_idle(self) -> bool:
        """Returns whether the image shows the scene as it is, or an error stopped it."""
        return bool(self.error) or not (self._must_send or self._import or self._opening or self._render or self._edits
                                        or self._is_stale or self._is_world_stale)

    def note(self, scene, depsgraph) -> None:
        """Notes what an update of Blender changed."""
        if scene.name != self.scene_name:
            return
        was_current = not (self._is_stale or self._is_world_stale or self._must_send)
        for update in depsgraph.updates:
            block = update.id
            if isinstance(block, bpy.types.World):
                self._is_world_stale = True
            elif isinstance(block, bpy.types.Light) or isinstance(block, (bpy.types.Object, bpy.types.Collection, bpy.types.Scene)):
                self._is_stale = True
                shape = isinstance(block, bpy.types.Object) and block.type not in ("LIGHT", "CAMERA", "EMPTY")
                self._must_send |= shape and (update.is_updated_geometry or update.is_updated_transform)
            elif isinstance(block, (bpy.types.Mesh, bpy.types.Curve, bpy.types.MetaBall, bpy.types.Material)):
                self._must_send |= update.is_updated_geometry or update.is_updated_shading
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
        except (OSError, RuntimeError, RequestError, program.ProgramError) as e:
            self._fail(str(e))

    def _fail(self, message: str) -> None:
        self.error = " ".join(message.split()) or "the live view stopped"
        self._must_send = self._is_stale = self._is_world_stale = False
        self._import = self._opening = self._render = None
        self._edits = []

    def _step(self) -> None:
        scene = bpy.data.scenes.get(self.scene_name)
        if scene is None or bpy.context.scene != scene:
            return
        self._receive_edits()
        self._receive_picture()
        if self._import is not None:
            self._open()
        elif self._opening is not None:
            self._receive_opened()
        elif self._must_send:
            if not self._sent or time.perf_counter() - self._changed_at >= SEND_DELAY:
                self._send(scene)
        elif self._is_stale or self._is_world_stale:
            self._edit(scene)

    def _send(self, scene) -> None:
        """Starts to send the scene: Blender exports it, and a process of Lightning imports it while Blender goes on."""
        self._must_send = self._is_stale = self._is_world_stale = False
        self._cancel()
        self._sent += 1
        target = self._target()
        target.parent.mkdir()
        self._copy_files(scene, target.parent)
        command = transfer.prepare(bpy.context, target, [], is_animated=False)
        self._groups = transfer.memory(scene).get("banks", {})
        self._lights = self._describe(scene)
        self._world = transfer.world_settings(scene, target, [])
        self._structure = self._describe_structure(scene)
        # The export itself is no edit.
        bpy.context.view_layer.update()
        self._must_send = self._is_stale = self._is_world_stale = False
        self._import = program.start(*command)

    def _target(self) -> Path:
        return self._folder / str(self._sent) / "live.jen"

    def _copy_files(self, scene, folder: Path) -> None:
        """Copies files that lights got in Lightning, such as gobos and textures."""
        source = Path(bpy.path.abspath(scene.lightning_file)).parent if scene.lightning_file else None
        settings = [lights.stored(obj).get("settings", {}) for obj in transfer.lamps(scene)] + [transfer.memory(scene).get("world", {})]
        for name in [s[key] for s in settings for key in ("gobo", "profile", "texture", "environment") if s.get(key)]:
            if source and (source / name).is_file():
                shutil.copyfile(source / name, folder / Path(name).name)

    def _open(self) -> None:
        if self._import.poll() is None:
            return
        process, self._import = self._import, None
        program.finish(process)
        if self._must_send:
            return
        if self._number is not None:
            self._client.send("close", scene=self._number)
            self._number = None
        self._opening = self._client.send("open", file=str(self._target()))

    def _receive_opened(self) -> None:
        if not self._opening.done():
            return
        answer, self._opening = self._opening, None
        result = answer.result()
        self._number = result["scene"]
        names = result["lights"] if len(result["lights"]) == len(self._lights) else list(self._lights)
        self._names = dict(zip(self._lights, names))
        shutil.rmtree(self._folder / str(self._sent - 1), ignore_errors=True)
        self._request_picture()

    def _describe(self, scene) -> dict[str, dict]:
        return {obj.name: lights.send(obj, self._groups, []) for obj in transfer.lamps(scene)}

    def _describe_structure(self, scene) -> tuple:
        """Returns what only sending can change, as far as it is quick to compare."""
        shown = [obj.name for obj in scene.objects if obj.type not in ("LIGHT", "CAMERA", "EMPTY") and lights.is_on(obj)]
        groups = {name: group for name, group in transfer.memory(scene).get("banks", {}).items()
                  if any(group.get(key, neutral) != neutral for key, neutral in NEUTRAL.items())}
        return shot.size(scene), shown, shot.camera(scene) if scene.camera else None, groups

    def _edit(self, scene) -> None:
        """Sends what changed of the lights and the world, and asks for a picture."""
        now = time.perf_counter()
        if self._render is not None:
            is_slow = self.pictures and now - self._render_start > SLOW and now - self._changed_at > CANCEL_DELAY
            if not is_slow:
                return
            self._cancel()
        is_world_stale = self._is_world_stale
        self._is_stale = self._is_world_stale = False
        after = self._describe(scene)
        kept = [name for name in self._lights if name in after]
        is_same_type = all(after[name]["type"] == self._lights[name]["type"] for name in kept)
        if self._number is None or not is_same_type or list(after)[:len(kept)] != kept or self._describe_structure(scene) != self._structure:
            self._must_send = True
            return
        requests = [("delete", {"light": words.quoted(self._names[name])}) for name in self._lights if name not in after]
        edits: list[str] = []
        for name, settings in after.items():
            if name not in self._lights:
                self._names[name] = name
                requests.append(("add", {"light": f"{words.quoted(name)} {settings['type']}"}))
            edits += words.edits(words.quoted(self._names[name]), self._lights.get(name, {"type": settings["type"]}), settings)
        if any(".profile=" in edit for edit in edits):
            for obj in transfer.lamps(scene):
                transfer.write_profile(obj, self._target().parent)
        self._lights = after
        if is_world_stale:
            edits += self._edit_world(scene)
        if edits:
            requests.append(("set", {"edits": edits, "gesture": "live"}))
        if requests:
            self._edits += [self._client.send(method, scene=self._number, **fields) for method, fields in requests]
            self._request_picture()

    def _edit_world(self, scene) -> list[str]:
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

    def _request_picture(self) -> None:
        self._render_start = time.perf_counter()
        self._render = self._client.send("render", scene=self._number, memory=True)

    def _cancel(self) -> None:
        if self._render is not None:
            self._render.cancel()
            self._render = None

    def _receive_picture(self) -> None:
        if self._render is None or not self._render.done():
            return
        answer, self._render = self._render, None
        memory = answer.result()["memory"]
        height, width, _ = memory["shape"]
        colors = numpy.fromfile(memory["path"], dtype="<f4").reshape(height, width, 3)
        show(colors)
        self.pictures += 1
        self.milliseconds = 1000 * (time.perf_counter() - self._edited_at)
        if self._is_stale or self._is_world_stale:
            self._edited_at = self._changed_at

    def close(self) -> None:
        """Ends the server."""
        if self._import is not None:
            self._import.kill()
            self._import.wait()
            self._import.stdout.close()
        try:
            self._client.close()
        except OSError:
            pass  # The server has ended.
        shutil.rmtree(self._folder, ignore_errors=True)


def show(colors) -> None:
    """Shows linear colors, from the top row, in the image."""
    height, width, _ = colors.shape
    image = bpy.data.images.get(IMAGE)
    if image is not None and (image.source != "GENERATED" or not image.is_float):
        image.name = f"{IMAGE} (old)"
        image = None
    if image is None:
        image = bpy.data.images.new(IMAGE, width, height, float_buffer=True)
        # Editors apply the scene's view transform.
        image.use_view_as_render = True
    elif tuple(image.size) != (width, height):
        image.scale(width, height)
    pixels = numpy.ones((height, width, 4), dtype=numpy.float32)
    pixels[:, :, :3] = colors[::-1]
    image.pixels.foreach_set(pixels.reshape(-1))
    image.update()


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
