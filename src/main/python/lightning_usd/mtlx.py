"""MaterialX files as layers of UsdShade, for a usd-core that does not read them."""

from __future__ import annotations

import os
from typing import Any
from xml.etree import ElementTree

from output import Output, shown
from pxr import Ar, Sdf, Tf, Usd, UsdShade

MAX_BYTES = 64 << 20
MAX_ROUNDS = 32
TYPES = {"float": Sdf.ValueTypeNames.Float, "integer": Sdf.ValueTypeNames.Int, "boolean": Sdf.ValueTypeNames.Bool,
         "string": Sdf.ValueTypeNames.String, "filename": Sdf.ValueTypeNames.Asset, "color3": Sdf.ValueTypeNames.Color3f,
         "color4": Sdf.ValueTypeNames.Color4f, "vector2": Sdf.ValueTypeNames.Float2, "vector3": Sdf.ValueTypeNames.Float3,
         "vector4": Sdf.ValueTypeNames.Float4}


def replace_references(stage: Usd.Stage, out: Output) -> list[Sdf.Layer]:
    """Replaces the MaterialX files that layers refer to, in memory only; returns the new layers, which the caller keeps."""
    if Sdf.FileFormat.FindByExtension("mtlx"):
        return []
    known: dict[str, Sdf.Layer | None] = {}
    for _ in range(MAX_ROUNDS):
        pending = [(layer, file) for layer in stage.GetUsedLayers() for file in layer.GetCompositionAssetDependencies()
                   if file.lower().endswith(".mtlx") and layer.ComputeAbsolutePath(file) not in known]
        for layer, file in pending:
            known[layer.ComputeAbsolutePath(file)] = read(layer.ComputeAbsolutePath(file), out)
        replaced = False
        for layer in stage.GetUsedLayers():
            for file in layer.GetCompositionAssetDependencies():
                new = known.get(layer.ComputeAbsolutePath(file))
                if new:
                    layer.SetPermissionToEdit(True)
                    replaced |= layer.UpdateCompositionAssetDependency(file, new.identifier)
        if not replaced:
            break
    return [layer for layer in known.values() if layer]


def read(file: str, out: Output) -> Sdf.Layer | None:
    """Returns a layer with the materials of a file; None if it is missing or damaged."""
    place = Ar.GetResolver().Resolve(file)
    if place and not Ar.IsPackageRelativePath(str(place)) and not (os.path.isfile(str(place)) and out.is_inside(str(place))):
        return None
    data = Ar.GetResolver().OpenAsset(place) if place else None
    if not data or data.GetSize() > MAX_BYTES:
        return None
    try:
        text = bytes(data.GetBuffer() or b"")
        # Programs write comments before the declaration, and inclusions without their namespace.
        text = text[max(text.find(b"<?xml"), 0):].replace(b"<xi:", b"<").replace(b"</xi:", b"</")
        document = ElementTree.fromstring(text)
        return File(document, place, out).layer()
    except (ElementTree.ParseError, ValueError, Tf.ErrorException):
        out.note("MaterialX files that are damaged")
        return None
    except RecursionError:
        out.note(f"MaterialX file {os.path.basename(file)}: its nodes refer to too many others one after another, left out")
        return None


class File:
    """One MaterialX document."""

    def __init__(self, document: ElementTree.Element, place: Ar.ResolvedPath, out: Output) -> None:
        self.out = out
        self.document = document
        self.place = place
        self.root = Sdf.Layer.CreateAnonymous(".usda")
        self.stage = Usd.Stage.Open(self.root)
        self.made: set[Sdf.Path] = set()

    def layer(self) -> Sdf.Layer:
        """Returns the materials, laid out as usd-core's own reader does."""
        self.stage.SetDefaultPrim(self.stage.DefinePrim("/MaterialX"))
        root = self.stage.DefinePrim("/MaterialX/Materials").GetPath()
        for element in self.document.findall("surfacematerial"):
            material = UsdShade.Material.Define(self.stage, root.AppendChild(identifier(element.get("name"))))
            for source in element.findall("input"):
                if source.get("name") == "surfaceshader":
                    output = self.source(source, self.document, self.document, material.GetPath(), Sdf.ValueTypeNames.Token)
                    if output:
                        material.CreateSurfaceOutput("mtlx").ConnectToSource(output)
        return self.root

    def source(self, source: ElementTree.Element, nodes: Any, outer: Any, scope: Sdf.Path, kind: Any) -> UsdShade.Output | None:
        """Returns the output that an input is connected to; None without one."""
        name, output = source.get("nodename"), source.get("output")
        if source.get("nodegraph"):
            nodes = child(outer, source.get("nodegraph"))
            ends = [] if nodes is None else [e for e in nodes.findall("output") if output in (None, e.get("name"))]
            if not ends:
                return None
            scope = scope.AppendChild(identifier(source.get("nodegraph")))
            name, output = ends[0].get("nodename"), ends[0].get("output")
        node = child(nodes, name)
        if node is None:
            return None
        path = scope.AppendChild(identifier(name))
        shader = UsdShade.Shader.Define(self.stage, path)
        if path not in self.made:
            self.made.add(path)
            shader.CreateIdAttr(f"ND_{node.tag}_{node.get('type')}")
            self.add_inputs(shader, node, nodes, scope)
        return shader.CreateOutput(output or ("surface" if kind == Sdf.ValueTypeNames.Token else "out"), kind)

    def add_inputs(self, shader: UsdShade.Shader, node: ElementTree.Element, nodes: Any, scope: Sdf.Path) -> None:
        """Adds values and connections of a node."""
        for element in node.findall("input"):
            kind = TYPES.get(element.get("type"))
            if not kind or not element.get("name"):
                continue
            made = shader.CreateInput(element.get("name"), kind)
            if element.get("interfacename"):
                # The value of the graph's own input.
                element = child(nodes, element.get("interfacename"))
                if element is None:
                    continue
            text = element.get("value")
            if text is not None:
                try:
                    made.Set(self.value(text, element))
                except (ValueError, IndexError, TypeError, Tf.ErrorException):
                    kind = element.get("type")
                    self.out.note(f"{node.get('name')}.{element.get('name')} of a MaterialX file: expected a value of type {kind}, found {shown(text)}")
                continue
            output = self.source(element, nodes, self.document, scope, kind)
            if output:
                made.ConnectToSource(output)

    def value(self, text: str, element: ElementTree.Element) -> Any:
        """Returns a value."""
        kind = element.get("type")
        if kind == "filename":
            prefix = element.get("fileprefix") or self.document.get("fileprefix") or ""
            for name in (prefix + text, text):
                path = Ar.GetResolver().CreateIdentifier(name, self.place)
                if "<UDIM>" in name or Ar.GetResolver().Resolve(path):
                    return Sdf.AssetPath(path)
            return Sdf.AssetPath(text)
        if kind == "string":
            return text
        if kind == "boolean":
            return text.strip() == "true"
        numbers = [float(part) for part in text.replace(",", " ").split()]
        if kind == "integer":
            return int(numbers[0])
        return numbers[0] if kind == "float" else TYPES[kind].type.pythonClass(*numbers)


def child(parent: Any, name: str | None) -> ElementTree.Element | None:
    """Returns the element of a name."""
    return next((e for e in parent if e.get("name") == name), None) if name else None


def identifier(name: str | None) -> str:
    """Returns a name that prims can have."""
    return Tf.MakeValidIdentifier(name or "unnamed")
