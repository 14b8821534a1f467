"""Prints the opinions of a layer: `opinions.py layer.usda`, one line for each attribute, relationship and field of a prim."""

import sys

from pxr import Sdf

layer = Sdf.Layer.FindOrOpen(sys.argv[1])
lines = []


def visit(path):
    """Adds the opinions of one prim or property."""
    spec = layer.GetObjectAtPath(path)
    if isinstance(spec, Sdf.PrimSpec):
        for key in ("active", "instanceable", "apiSchemas"):
            if spec.HasInfo(key):
                lines.append(f"{path} {key}")
        if spec.specifier == Sdf.SpecifierDef:
            lines.append(f"{path} def {spec.typeName}")
    elif isinstance(spec, Sdf.PropertySpec):
        lines.append(str(path))


layer.Traverse(Sdf.Path.absoluteRootPath, visit)
for line in sorted(lines):
    print(line)
