"""Relights ray-traced scenes exactly, through a running Lightning.

    import lightning_relight

    with lightning_relight.open("scenes/bird.jen") as scene:
        scene.set("sun.color=1 0 0", "lamp.intensity=2")
        picture = scene.picture()            # numpy array: height, width, 3 floats
        scene.picture("red.png")
        print(scene.explain(150, 230)["center"]["object"])

An edit recomputes only what it changes, and each picture equals a full trace in every bit. The five functions are
``open`` and the scene's ``set``, ``picture``, ``explain`` and ``close``. The package needs no other package; numpy
is used if it is installed. ``aio.open`` opens scenes for asyncio. ``Client`` speaks the protocol itself, for programs that
must not wait, such as a live view.
"""

from . import aio
from .client import Answer, Client, RequestError
from .layers import Layers
from .scene import Pixels, Scene, open
from .values import Value

__all__ = ["Answer", "Client", "Layers", "Pixels", "RequestError", "Scene", "Value", "aio", "open"]
