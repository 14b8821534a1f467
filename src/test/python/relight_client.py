"""Uses the package lightning_relight as an artist would. Arguments: its folder, the command of Lightning as JSON, a scene, and files of
linear floats that full traces of the scene and of the edited scene wrote."""

import json
import os
import sys
import tempfile
from pathlib import Path

folder, command, scene_file, plain, edited = sys.argv[1:]
sys.path.insert(0, folder)

import numpy  # noqa: E402

import lightning_relight  # noqa: E402
from lightning_relight import Client, RequestError  # noqa: E402


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
        report = scene.explain(35, 25)
        assert report["color_linear"] == [float(str(v)) for v in after[25, 35]], (report["color_linear"], after[25, 35])
        assert report["center"]["object"] == "ball"
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
