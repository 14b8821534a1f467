# SPDX-License-Identifier: Apache-2.0
"""Edits in words: values of JSON as `lightning serve` reads them."""

# Properties with a word, which has no quotes. Other texts are names.
CHOICES = ("type", "falloff", "unit", "filter", "sky_unit")
# No properties of scene files.
SKIPPED = ("name", "relative_intensity")


def quoted(text: str) -> str:
    """Returns a name or a file in quotes."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return f'"{escaped}"'


def value(key: str, content) -> str:
    """Returns the value of a property of a light or of the world."""
    if isinstance(content, bool):
        return "yes" if content else "no"
    if isinstance(content, (int, float)):
        return repr(content)
    if isinstance(content, list):
        return " ".join(repr(number) for number in content)
    if isinstance(content, dict) and "only" in content:
        names = " ".join(quoted(name) for name in content["names"])
        if not names:
            return "none" if content["only"] else "all"
        return f"{'only' if content['only'] else 'except'} {names}"
    if isinstance(content, dict):
        return " ".join(f"{quoted(name)} {factor!r}" for name, factor in content.items()) or "none"
    if key in CHOICES:
        return content
    return quoted(content) if content else "none"


def edits(target: str, before: dict, after: dict) -> list[str]:
    """Returns the edits that change an object; a file that is no longer there becomes none."""
    changed = [key for key in after if key not in SKIPPED and after[key] != before.get(key)]
    removed = [key for key in before if key not in after and isinstance(before[key], str) and key not in SKIPPED]
    return [f"{target}.{key}={value(key, after[key])}" for key in changed] + [f"{target}.{key}=none" for key in removed]
