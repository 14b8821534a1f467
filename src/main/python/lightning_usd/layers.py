"""Layers of a stage before it is composed: which files may be read, and how many prims there will be."""

from __future__ import annotations

import os
import re
from typing import Any

from choice import listed, message
from output import MAX_NODES, Output, StageError
from pxr import Ar, Sdf, Tf, Usd, UsdUtils

# Prims that are counted, in about half a second. Larger stages are limited by memory and time only.
MAX_COUNTED = 20_000
# Prims of the composed stage, by a count that takes a prim of several layers several times.
MAX_COMPOSED = 10 * MAX_NODES
# References one after another: usd-core needs memory for each pair of them.
MAX_DEPTH = 500
OUTSIDE = "files outside the stage's folder and the folders of LIGHTNING_USD_FOLDERS, not read, such as "
IRREGULAR = "pipes, devices and folders in place of files, not read, such as "


class Layers:
    """Layers that a stage refers to, kept in memory without the files that must not be read."""

    def __init__(self, out: Output) -> None:
        self.out = out
        self.kept: dict[str, Sdf.Layer] = {}
        self.refused: dict[str, list[str]] = {OUTSIDE: [], IRREGULAR: []}

    def open(self, source: str) -> Sdf.Layer:
        """Opens a stage's own layer, and all that it refers to."""
        root = Sdf.Layer.FindOrOpen(source)
        if not root:
            raise StageError("cannot be read by usd-core")
        self.kept[root.identifier] = root
        pending = [root]
        while pending:
            layer = pending.pop()
            self.remove_refused(layer)
            for path in layer.GetCompositionAssetDependencies():
                found = self.find(layer, path)
                if found and found.identifier not in self.kept:
                    self.kept[found.identifier] = found
                    pending.append(found)
        for kind, paths in self.refused.items():
            if paths:
                self.out.note(kind + sorted(paths)[0], len(set(paths)))
        return root

    def remove_refused(self, layer: Sdf.Layer) -> None:
        """Removes the paths of files that must not be read from a layer, in memory only."""
        refused: dict[str, str] = {}

        def check(path: str) -> str:
            kind = self.refusal(layer, path)
            if kind:
                refused[path] = kind
            return path

        UsdUtils.ModifyAssetPaths(layer, check)
        if refused:
            layer.SetPermissionToEdit(True)
            UsdUtils.ModifyAssetPaths(layer, lambda path: "" if path in refused else path)
        for path, kind in refused.items():
            self.refused[kind].append(path)

    def refusal(self, layer: Sdf.Layer, path: str) -> str | None:
        """Returns why the file of a path must not be read; None if it may, or is missing."""
        if not path:
            return None
        absolute = layer.ComputeAbsolutePath(Sdf.Layer.SplitIdentifier(path)[0])
        if "<UDIM>" in absolute:
            folder = os.path.dirname(os.path.join(os.path.dirname(layer.realPath), absolute))
            return None if Ar.IsPackageRelativePath(absolute) or self.out.is_inside(folder) else OUTSIDE
        place = str(Ar.GetResolver().Resolve(absolute))
        if Ar.IsPackageRelativePath(place):
            place = Ar.SplitPackageRelativePathOuter(place)[0]
        if not place:
            return None
        return IRREGULAR if not os.path.isfile(place) else None if self.out.is_inside(place) else OUTSIDE

    def find(self, layer: Sdf.Layer, path: str) -> Sdf.Layer | None:
        """Returns a layer that another one refers to; None if it is missing, damaged or of another kind."""
        if not path or not Sdf.FileFormat.FindByExtension(Sdf.Layer.SplitIdentifier(path)[0].rstrip("]")):
            return None
        try:
            return Sdf.Layer.FindOrOpenRelativeToLayer(layer, path)
        except Tf.ErrorException:
            return None


class PrimCount:
    """Number of prims that references multiply to."""

    def __init__(self, layers: dict[str, Sdf.Layer]) -> None:
        self.layers = layers
        self.known: dict[tuple[str, Sdf.Path], int] = {}
        # References one after another, from a prim on.
        self.depths: dict[tuple[str, Sdf.Path], int] = {}

    def check(self, root: Sdf.Layer) -> None:
        """Fails if nested references make more prims than a scene can have."""
        start = (root.identifier, Sdf.Path.absoluteRootPath)
        count = self.of(start)
        if self.depths.get(start, 0) > MAX_DEPTH:
            raise StageError(f"has references to references, more than {MAX_DEPTH} one after another")
        if count > MAX_COMPOSED:
            raise StageError(f"has more than {MAX_NODES} prims, because references multiply them to about {count:.0e}")

    def of(self, start: tuple[str, Sdf.Path]) -> int:
        """Returns the number of prims below a path, with those of references; 0 if there are too many to count."""
        stack = [start]
        parts: dict[tuple[str, Sdf.Path], list[tuple[str, Sdf.Path]]] = {}
        while stack:
            key = stack[-1]
            if key in self.known:
                stack.pop()
            elif key not in parts:
                if len(parts) > MAX_COUNTED:
                    return 0
                parts[key] = self.parts(key)
                stack += [part for part in parts[key] if part not in parts]
            else:
                # A cycle counts nothing: usd-core ends it.
                self.known[key] = 1 + sum(self.known.get(part, 0) for part in parts[key])
                self.depths[key] = max((self.depths.get(part, 0) + (part[1].GetParentPath() != key[1]) for part in parts[key]), default=0)
                stack.pop()
        return self.known[start]

    def parts(self, key: tuple[str, Sdf.Path]) -> list[tuple[str, Sdf.Path]]:
        """Returns what a prim consists of: its children, and the prims that it refers to."""
        layer = self.layers[key[0]]
        prim = layer.GetPrimAtPath(key[1])
        if not prim:
            return []
        found = [(key[0], child.path) for child in prim.nameChildren]
        if key[1] == Sdf.Path.absoluteRootPath:
            return found + [(other, Sdf.Path.absoluteRootPath) for path in layer.subLayerPaths if (other := self.identifier(layer, path))]
        for arcs in (prim.referenceList, prim.payloadList):
            for arc in arcs.GetAddedOrExplicitItems():
                other = self.identifier(layer, arc.assetPath) if arc.assetPath else key[0]
                if other:
                    found.append((other, arc.primPath or self.default_prim(other)))
        found += [(key[0], path) for arcs in (prim.inheritPathList, prim.specializesList) for path in arcs.GetAddedOrExplicitItems()]
        for variants in prim.variantSets.values():
            found += [(key[0], variant.primSpec.path) for variant in list(variants.variants.values())[:1]]
        return found

    def identifier(self, layer: Sdf.Layer, path: str) -> str | None:
        """Returns the key of a layer that another one refers to."""
        found = Sdf.Layer.FindRelativeToLayer(layer, path) if path else None
        return found.identifier if found and found.identifier in self.layers else None

    def default_prim(self, layer: str) -> Sdf.Path:
        """Returns the prim that a reference without a path means."""
        name = self.layers[layer].defaultPrim
        return Sdf.Path.absoluteRootPath.AppendPath(name) if name else Sdf.Path.absoluteRootPath


def note_missing(stage: Usd.Stage, out: Output) -> None:
    """Notes references, payloads and sublayers that cannot be loaded, by their file and prim."""
    errors = stage.GetCompositionErrors()
    # usd-core gives the file in its message only, as @file@<prim>, and in any order, since it loads with several threads.
    found = [re.search(r"@([^@]*)@(<[^>]*>)?", message(error)) for error in errors]
    names = [os.path.basename(match.group(1)) + (match.group(2) or "") if match else "unknown" for match in found]
    out.note(f"references that cannot be loaded: {listed(sorted(set(names)))}", len(errors))


def open_layers(source: str, out: Output) -> list[Any]:
    """Opens the layers of a stage that may be read; returns them, because layers without an owner vanish."""
    layers = Layers(out)
    root = layers.open(source)
    PrimCount(layers.kept).check(root)
    return list(layers.kept.values())
