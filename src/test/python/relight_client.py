"""Uses the package lightning_relight as an artist would. Arguments: its folder, the command of Lightning as JSON, a scene, and files of
linear floats that full traces of the scene and of the edited scene wrote."""

import asyncio
import json
import os
import sys
import tempfile
from pathlib import Path

folder, command, scene_file, plain, edited = sys.argv[1:]
sys.path.insert(0, folder)

import numpy  # noqa: E402

import lightning_relight  # noqa: E402
from lightning_relight import Client, RequestError, aio  # noqa: E402


def floats(path: str) -> numpy.ndarray:
    return numpy.frombuffer(Path(path).read_bytes(), dtype="<f4").reshape(50, 70, 3)


with Client(program=json.loads(command)) as client:
    with lightning_relight.open(scene_file, client=client) as scene:
        assert scene.lights == ["key", "fill"], scene.lights
        before = scene.picture()
        assert before.dtype == numpy.float32 and (before == floats(plain)).all()
        assert scene.set("key.color=1 0.5 0", "fill.intensity=0.7") == []
        after = scene.picture()
        assert (after == floats(edited)).all()
        assert (before == floats(plain)).all(), "an array stays as it is"
        assert (scene.picture(region=(3, 4, 10, 5)) == after[4:9, 3:13]).all()
        assert abs(scene.picture(light="key") + scene.picture(light="fill") - after).max() < 1
        pixels = scene.pixels()
        assert (pixels.width, pixels.height) == (70, 50) and list(pixels.floats[:3]) == list(after[0, 0])
        try:
            pixels.floats[0] = 1.0
            raise AssertionError("the picture is read-only")
        except TypeError:
            pass
        assert scene.review()["url"].startswith("http://127.0.0.1:")
        scene.end_review()
        report = scene.explain(35, 25)
        assert report["color_linear"] == [float(str(v)) for v in after[25, 35]], (report["color_linear"], after[25, 35])
        assert report["center"]["object"] == "ball"
        reference = os.path.join(tempfile.mkdtemp(), "reference.pfm")
        scene.picture(reference)
        scene.set("key.intensity=4")
        assert scene.match(reference, lights=["key"])["error_after"] < 1e-3
        scene.undo(2)
        assert scene.get("key.color") == {"key.color": "1 0.5 0"}
        assert scene.set("key.angle=20")[0].startswith("key.angle has no effect")
        try:
            scene.set("key.intensity=9", "kee.color=1 0 0")
            raise AssertionError("a wrong edit must be refused")
        except RequestError as e:
            assert (e.code, e.place) == ("bad_edit", "edits[1]"), e
        scene.undo(2)
        assert (scene.picture() == before).all()
        scene.redo()
        assert (scene.picture() == after).all()
        # Values with types.
        assert scene.values("key.color", "key.intensity", "key.on") == {
            "key.color": (1.0, 0.5, 0.0), "key.intensity": 0.8, "key.on": True}, scene.values("key.color", "key.intensity", "key.on")
        scene.set({"key.color": numpy.array([1, 0.25, 0.5]), "key.on": False}, "fill.intensity=0.5")
        assert scene.get("key.color", "key.on", "fill.intensity") == {"key.color": "1 0.25 0.5", "key.on": "no", "fill.intensity": "0.5"}
        scene.undo()

        # Names follow the edits.
        scene.add("rim point intensity=0.5 at=0 3 2")
        assert scene.lights == ["key", "fill", "rim"], scene.lights
        scene.delete("key")
        assert scene.lights == ["fill", "rim"]
        scene.undo(2)
        assert scene.lights == ["key", "fill"] and scene.size == (70, 50) and scene.frames is None
        assert (scene.picture() == after).all()

        # All layers in one call.
        layers = scene.layers()
        assert (layers.picture == after).all() and (layers.total() == after).all()
        assert set(layers.diffuse) == {"key", "fill"} == set(layers.specular), (layers.order, list(layers.diffuse))
        assert abs(layers.light("key") - scene.picture(light="key")).max() < 1e-5
        assert layers.albedo.shape == (50, 70, 3) and 0 < layers.albedo[25, 35].max() <= 1
        assert layers.normals.shape == layers.positions.shape == (50, 70, 3) and layers.depth.shape == (50, 70)
        assert layers.objects[layers.object_ids[25, 35] - 1] == "ball", layers.objects
        assert layers.materials[layers.material_ids[25, 35] - 1] == report["center"]["material"]
        assert abs(numpy.linalg.norm(layers.normals[25, 35]) - 1) < 1e-5
        assert numpy.allclose(layers.positions[25, 35], report["center"]["position"], atol=1e-4)

        # Derivatives, beside differences of pictures.
        for parameter, value in [("intensity", 0.8), ("exposure", 0.0)]:
            high, low = scene.batch([{f"key.{parameter}": value + 0.25}, {f"key.{parameter}": value - 0.25}])
            difference = (high - low) / 0.5
            gradient = scene.gradient("key", parameter)
            assert gradient.dtype == numpy.float32 and abs(gradient).max() > 0.01
            assert abs(difference - gradient).max() < 0.02 * abs(gradient).max(), parameter
        scene.set("key.color=1 0.5 0.25")
        redder, = scene.batch(["key.color=1.5 0.5 0.25"])
        gradient = scene.gradient("key", "color")
        assert abs((redder - scene.picture())[:, :, 0] / 0.5 - gradient[:, :, 0]).max() < 1e-4
        scene.undo()
        try:
            scene.gradient("key", "color")
            raise AssertionError("a color of 0 has no part to divide")
        except ValueError as e:
            assert "key.color" in str(e)

        # A batch leaves the scene as it is, also after a wrong edit and after an edit that changes nothing.
        pictures = scene.batch([["key.color=1 1 1", "fill.intensity=0.2"], {"fill.on": False}, "key.color=1 0.5 0"])
        assert (pictures[2] == after).all() and (pictures[1] != after).any() and (pictures[0] != pictures[1]).any()
        try:
            scene.batch(["key.color=1 1 1", "nothing.color=1 1 1"])
            raise AssertionError("a wrong edit must be refused")
        except RequestError as e:
            assert e.code == "bad_edit", e
        assert (scene.picture() == after).all()

        with tempfile.TemporaryDirectory() as out:
            os.chdir(out)
            assert scene.picture("a.exr", bits=32, layers=True) is None
            scene.picture("a.png")
            scene.save("a.jen")
            assert sorted(os.listdir(out)) == ["a.exr", "a.jen", "a.png"]
            os.chdir("/")
        with lightning_relight.open(text=Path(scene_file).read_text(), client=client) as second:
            assert second.replace(text="jen 1\npicture { size 20 10 }") == [] and second.lights == []
            assert second.picture().shape == (10, 20, 3)
            second.replace(os.path.abspath(scene_file))
            second.set("picture.size=64 64")
            assert second.picture().shape == (64, 64, 3)
            second.set("picture.size=1500 1500")
            shares = []
            answer = client.send("render", scene=second.number, memory=True, on_progress=shares.append)
            while not shares:
                assert not answer.done()
            answer.cancel()
            try:
                answer.result(60)
                raise AssertionError("a canceled request has no result")
            except RequestError as e:
                assert e.code == "canceled", e
        # Frames of a shot.
        shot = Path(scene_file).read_text() + "\nshot { frames 1 4  light key { intensity { 1 0  4 3 } } }\n"
        with lightning_relight.open(text=shot, client=client) as animated:
            assert animated.frames == (1, 4)
            animated.frame(4)
            assert animated.values("key.intensity") == {"key.intensity": 3.0}, animated.values("key.intensity")
            bright = animated.picture()
            animated.frame(1)
            assert animated.picture().sum() < bright.sum()

        # Options of an import.
        with tempfile.TemporaryDirectory() as out:
            model = Path(out, "model.ply")
            model.write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
            with lightning_relight.open(model, output=Path(out, "model.jen"), lighting="studio", indirect="on", client=client) as imported:
                assert imported.lights == ["key", "fill", "rim", "sky"], imported.lights
                assert client.request("describe", scene=imported.number)["indirect"]
            try:
                lightning_relight.open(model, output=Path(out, "model.jen"), lighting="moon", client=client)
                raise AssertionError("an unknown choice must be refused")
            except RequestError as e:
                assert e.place == "lighting" and "studio" in str(e), e

        # Awaited calls; a canceled task cancels its request.
        async def awaited() -> None:
            async with aio.open(scene_file, client=client) as other:
                await other.set({"key.color": (1, 0.5, 0)}, "fill.intensity=0.7")
                pictures = await asyncio.gather(other.picture(), other.picture(light="key"))
                assert (pictures[0] == after).all() and pictures[1].shape == after.shape
                assert (await other.layers()).order == layers.order
                await other.set("picture.size=3000 3000")
                task = asyncio.ensure_future(other.picture())
                await asyncio.sleep(0.05)
                task.cancel()
                try:
                    await task
                    raise AssertionError("a canceled task has no picture")
                except asyncio.CancelledError:
                    pass
                await other.set("picture.size=70 50")
                assert (await other.picture() == after).all()

        asyncio.run(awaited())
        shared = client.request("render", scene=scene.number, memory=True)["memory"]["path"]
        assert os.path.exists(shared)
    assert not os.path.exists(shared)
    try:
        lightning_relight.open("/none.jen", client=client)
        raise AssertionError("a missing file must be refused")
    except RequestError as e:
        assert e.code == "file" and "/none.jen" in str(e), e
try:
    client.request("list")
    raise AssertionError("a closed client has no answers")
except (ConnectionError, ValueError):
    pass
print("done")
