"""Variants: which content a prim has of those that its stage offers."""

from __future__ import annotations

from choice import listed
from instances import MAX_DEPTH, dissolve
from output import Output, StageError
from pxr import Usd


class Variants:
    """Selection of variants on a stage, in memory only."""

    def __init__(self, stage: Usd.Stage, choices: tuple[str, ...], out: Output) -> None:
        self.stage = stage
        self.out = out
        self.choices = [self.parse(choice) for choice in choices]
        # Names of the variants of each set, of all prims; and choices that a prim has.
        self.sets: dict[str, list[str]] = {}
        self.used: set[tuple[str, str, str]] = set()

    @staticmethod
    def parse(choice: str) -> tuple[str, str, str]:
        """Returns the path of the prim, which is empty for all, the set and the name of the variant."""
        place, _, name = choice.partition("=")
        path, _, kind = place.rpartition(":") if place.startswith("/") else ("", "", place)
        if not name or not kind:
            raise StageError(f"must have a variant such as 'look=red', not '{choice}'")
        return path, kind, name

    def select(self) -> None:
        """Selects the chosen variants; notes the sets without a choice."""
        # Variants may contain further sets.
        for _ in range(MAX_DEPTH):
            if not self.select_present():
                break
        for path, kind, name in self.choices:
            if (path, kind, name) not in self.used:
                raise StageError(self.missing(path, kind, name))
        others = [f"{kind} ({', '.join(names[:20])})" for kind, names in self.sets.items()
                  if len(names) > 1 and kind not in [chosen for _, chosen, _ in self.choices]]
        self.out.note(f"variants, imported as the stage selects them: {'; '.join(others[:20])}{' …' if len(others) > 20 else ''}", len(others))

    def select_present(self) -> bool:
        """Selects the variants that prims have now; returns whether any selection has changed."""
        pending = []
        # Also what point instancers place, which may be classes or overs.
        kinds = Usd.TraverseInstanceProxies(Usd.PrimIsActive & Usd.PrimIsLoaded)
        for prim in Usd.PrimRange.Stage(self.stage, kinds):
            if not prim.HasVariantSets():
                continue
            sets = prim.GetVariantSets()
            for kind in sets.GetNames():
                names = sets.GetVariantSet(kind).GetVariantNames()
                known = self.sets.setdefault(kind, [])
                known += [name for name in names if name not in known]
                for choice in self.choices:
                    if choice[0] in ("", str(prim.GetPath())) and choice[1] == kind and choice[2] in names:
                        self.used.add(choice)
                        if sets.GetVariantSelection(kind) != choice[2]:
                            pending.append((prim, kind, choice[2]))
        if dissolve(self.stage, [prim for prim, _, _ in pending if prim.IsInstanceProxy()]):
            return True
        self.stage.SetEditTarget(self.stage.GetSessionLayer())
        for prim, kind, name in pending:
            prim.GetVariantSet(kind).SetVariantSelection(name)
        return bool(pending)

    def missing(self, path: str, kind: str, name: str) -> str:
        """Returns what is wrong with a choice that no prim has."""
        if path and not self.stage.GetPrimAtPath(path):
            return f"must have the prim {path} for the variant '{kind}={name}'"
        place = f"{path}: " if path else ""
        if kind not in self.sets:
            return f"{place}must have the variant set '{kind}', has {listed(list(self.sets)) or 'none'}"
        return f"{place}must have the variant '{name}' of '{kind}', has {listed(self.sets[kind])}"
