"""Scenes for programs that use asyncio: each function is that of ``Scene``, and is awaited.

    async with lightning_relight.aio.open("scenes/bird.jen") as scene:
        await scene.set("sun.color=1 0 0")
        picture = await scene.picture()

Calls of one scene run one after the other. If a task that waits for a call is canceled, the server stops the call.
"""

from __future__ import annotations

import asyncio
import functools
from typing import TYPE_CHECKING, Any, Callable, List, Optional

from . import scene as scenes

if TYPE_CHECKING:
    import numpy


class AsyncScene:
    """Open scene whose functions are awaited. ``scene.scene`` is the scene itself."""

    def __init__(self, opening: Callable[[], scenes.Scene]) -> None:
        self._opening = opening
        self._lock: Optional[asyncio.Lock] = None
        self.scene: scenes.Scene = None  # type: ignore[assignment]

    async def _run(self, call: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
        self._lock = self._lock or asyncio.Lock()
        async with self._lock:
            running = asyncio.ensure_future(asyncio.to_thread(functools.partial(call, *arguments, **options)))
            try:
                return await asyncio.shield(running)
            except asyncio.CancelledError:
                if self.scene:
                    self.scene.cancel()
                # The next call must not start before the server has answered.
                await asyncio.wait([running])
                if running.exception() is None and isinstance(running.result(), scenes.Scene):
                    running.result().close()  # The caller never got the opened scene.
                raise

    async def __aenter__(self) -> "AsyncScene":
        self.scene = await self._run(self._opening)
        return self

    async def __aexit__(self, *_: object) -> None:
        await self._run(self.scene.close)

    @property
    def lights(self) -> List[str]:
        """Names of the lights; blocks for the moment of a request after an edit."""
        return self.scene.lights


def _awaited(name: str) -> Callable[..., Any]:
    call = getattr(scenes.Scene, name)

    @functools.wraps(call)
    async def run(self: AsyncScene, *arguments: Any, **options: Any) -> Any:
        return await self._run(call, self.scene, *arguments, **options)

    return run


for _name in (
    "replace", "set", "get", "values", "add", "delete", "undo", "redo", "frame", "picture", "pixels", "layers", "gradient", "batch",
    "explain", "match", "review", "end_review", "save", "close",
):
    setattr(AsyncScene, _name, _awaited(_name))


@functools.wraps(scenes.open)
def open(*arguments: Any, **options: Any) -> AsyncScene:
    return AsyncScene(functools.partial(scenes.open, *arguments, **options))
