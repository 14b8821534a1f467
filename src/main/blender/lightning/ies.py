# SPDX-License-Identifier: Apache-2.0
"""IES profiles (LM-63) of type C: reading, and writing for Lightning's orientation."""

import bisect
import math
import re
from typing import NamedTuple


class Profile(NamedTuple):
    """Shares of the largest value by direction.

    Attributes:
        vertical: ascending angles from the axis in radians
        horizontal: ascending angles around the axis in degrees, from 0 to 360, or only 0
        rows: for each horizontal angle, a value for each vertical one
        candela: the largest value of the file
    """

    vertical: list[float]
    horizontal: list[float]
    rows: list[list[float]]
    candela: float


def parse(text: str) -> Profile:
    """Reads a profile; a ValueError says why one cannot be read."""
    found = re.search(r"^TILT=NONE\s*$", text, re.MULTILINE)
    if found is None:
        raise ValueError("expected TILT=NONE")
    numbers = [float(word) for word in text[found.end():].replace(",", " ").split()]
    multiplier, count, planes, photometry = numbers[2], int(numbers[3]), int(numbers[4]), int(numbers[5])
    if photometry != 1 or planes < 1 or count < 2:
        raise ValueError("expected photometry of type C")
    vertical, horizontal = numbers[13:13 + count], numbers[13 + count:13 + count + planes]
    scale = multiplier * numbers[10] * numbers[11]
    values = [v * scale for v in numbers[13 + count + planes:13 + count + planes + count * planes]]
    if len(values) != count * planes or vertical != sorted(vertical) or horizontal != sorted(set(horizontal)) or not max(values) > 0:
        raise ValueError("expected ascending angles and a value for each")
    candela = max(values)
    rows = [[v / candela for v in values[i * count:(i + 1) * count]] for i in range(planes)]
    return Profile([math.radians(a) for a in vertical], *_all_around(horizontal, rows), candela)


def _all_around(horizontal: list[float], rows: list[list[float]]) -> tuple[list[float], list[list[float]]]:
    """Returns the planes of the whole circle, of which a file may have a part that the others repeat."""
    if len(horizontal) == 1:
        return [0], rows
    if horizontal[0] == 90 and horizontal[-1] == 270:
        # As Cycles reads it.
        horizontal = [a - 90 for a in horizontal]
    if horizontal[0] != 0 or horizontal[-1] not in (90, 180, 360):
        raise ValueError("expected horizontal angles from 0 to 0, 90, 180 or 360, or from 90 to 270")
    while horizontal[-1] < 360:
        end = horizontal[-1]
        rows = rows + rows[-2::-1]
        horizontal = horizontal + [2 * end - a for a in horizontal[-2::-1]]
    return horizontal, rows


def mirrored(profile: Profile, turn: float) -> Profile:
    """Returns a profile whose plane at an angle a is that at `turn` - a, in degrees: the other sense of rotation, and another start."""
    if len(profile.horizontal) == 1:
        return profile
    angles = sorted({round((turn - a) % 360, 9) % 360 for a in profile.horizontal} | {0})
    columns = list(zip(*profile.rows))
    rows = [[at(list(zip(profile.horizontal, column)), (turn - a) % 360) for column in columns] for a in angles]
    return profile._replace(horizontal=[*angles, 360], rows=[*rows, rows[0]])


def times(profile: Profile, edge: list[tuple[float, float]]) -> Profile:
    """Returns a profile times a factor by vertical angle; it ends with the factor."""
    angles = sorted(set(profile.vertical) | {a for a, _ in edge})
    angles = [a for a in angles if profile.vertical[0] <= a <= edge[-1][0]]
    rows = [[at(list(zip(profile.vertical, row)), a) * at(edge, a) for a in angles] for row in profile.rows]
    return profile._replace(vertical=angles, rows=rows)


def at(points: list[tuple[float, float]], angle: float) -> float:
    """Returns a value between the angles of points."""
    i = min(max(bisect.bisect_right([a for a, _ in points], angle), 1), len(points) - 1)
    (a, v), (b, w) = points[i - 1], points[i]
    return v + (w - v) * min(max((angle - a) / (b - a), 0), 1) if b > a else v


def write(profile: Profile) -> str:
    """Returns the text of a file."""
    lines = ["IESNA:LM-63-2002", "TILT=NONE", f"1 -1 1 {len(profile.vertical)} {len(profile.horizontal)} 1 2 0 0 0", "1 1 1"]
    lines += [f"{math.degrees(a):.9g}" for a in profile.vertical] + [f"{a:.9g}" for a in profile.horizontal]
    lines += [f"{v:.9g}" for row in profile.rows for v in row]
    return "\r\n".join(lines) + "\r\n"
