"""Kills Blender at random moments while it sends a scene: the scene opens, old or new, and no file of the user changes.

Arguments: a folder, the number of kills, and a seed.
"""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import blender_scene as sample
import bpy

USER = {"shot-world.hdr": b"my own sky", "notes.txt": b"my notes"}
TEMPLATE = sample.FOLDER / "template"


def send_again(folder: Path) -> None:
    """Sends the scene of the template with another mesh and another material."""
    bpy.ops.wm.open_mainfile(filepath=str(TEMPLATE.with_suffix(".blend")))
    bpy.data.objects.remove(bpy.data.objects["Ball"])
    bpy.ops.mesh.primitive_cone_add(vertices=4000)
    bpy.context.object.name = "Cone"
    print("sending", flush=True)
    assert bpy.ops.lightning.send(filepath=str(folder / "shot.jen"), overwrite=len(sys.argv) > 4) == {"FINISHED"}


def start(folder: Path, *arguments: str) -> subprocess.Popen:
    """Starts a process that sends the scene, and waits until it begins."""
    process = subprocess.Popen([sys.executable, "-B", __file__, str(sample.FOLDER), "send", str(folder), *arguments], stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL, start_new_session=True)
    while process.stdout.readline() not in (b"sending\n", b""):
        pass
    return process


def check(folder: Path, allowed: tuple) -> str:
    """Returns the mesh that the scene shows; fails if the scene does not open, or a file of the user has changed."""
    sample.run_program("check", str(folder / "shot.jen"))
    text = (folder / "shot.jen").read_text(encoding="utf-8")
    shown = [name for name in allowed if f"mesh {name} " in text]
    assert len(shown) == 1, text
    for name, content in USER.items():
        assert (folder / name).read_bytes() == content, name
    return shown[0]


def kill_one(random_source, seconds: float) -> str:
    """Sends to a copy of the template, kills Blender, and for every second kill Lightning too; returns the mesh that the scene shows."""
    folder = sample.FOLDER / "trial"
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(TEMPLATE, folder)
    process = start(folder)
    moment = random_source.random()
    if random_source.random() < 0.5:
        time.sleep(moment * seconds)
    else:
        # While files are moved.
        while process.poll() is None and not any(folder.glob("*.import")):
            time.sleep(0.0005)
        time.sleep(moment * 0.05)
    kill = os.killpg if random_source.random() < 0.8 else os.kill
    if process.poll() is None:
        kill(process.pid, signal.SIGKILL)
    process.wait()
    while kill is os.kill and subprocess.run(["pgrep", "-g", str(process.pid)], stdout=subprocess.DEVNULL, check=False).returncode == 0:
        time.sleep(0.05)
    shown = check(folder, ("Ball", "Cone"))
    return shown + ("" if not any(folder.glob("*.import")) else ", with its folder")


def repair() -> None:
    """Sends again after a kill."""
    folder = sample.FOLDER / "trial"
    assert start(folder, "overwrite").wait() == 0
    assert check(folder, ("Ball", "Cone")) == "Cone"
    # An empty folder is removed after a minute.
    left = [file.name for file in folder.iterdir() if file.suffix == ".tmp" or file.suffix == ".import" and any(file.iterdir())]
    assert not left, left


sample.start()
if sys.argv[2] == "send":
    send_again(Path(sys.argv[3]))
    sys.exit()
TEMPLATE.mkdir()
for name, content in USER.items():
    (TEMPLATE / name).write_bytes(content)
bpy.ops.mesh.primitive_uv_sphere_add(segments=200, ring_count=100)
bpy.context.object.name = "Ball"
assert bpy.ops.lightning.send(filepath=str(TEMPLATE / "shot.jen")) == {"FINISHED"}
bpy.ops.wm.save_as_mainfile(filepath=str(TEMPLATE.with_suffix(".blend")))
shutil.copytree(TEMPLATE, sample.FOLDER / "trial")
clock = time.perf_counter()
assert start(sample.FOLDER / "trial").wait() == 0
clock = time.perf_counter() - clock
source = random.Random(int(sys.argv[3]))
counts: dict = {}
for i in range(int(sys.argv[2])):
    state = kill_one(source, clock)
    counts[state] = counts.get(state, 0) + 1
    if i % 5 == 0 or "folder" in state:
        repair()
    print(i + 1, state, flush=True)
print("nothing is lost:", counts)
