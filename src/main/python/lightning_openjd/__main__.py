"""Starts the adaptor: ``python -m lightning_openjd``, or ``lightning-openjd`` after an installation."""

import sys

from openjd.adaptor_runtime import EntryPoint

from .adaptor import ShotAdaptor


def main() -> int:
    """Runs the command that the arguments name, such as ``daemon run``."""
    EntryPoint(ShotAdaptor).start(reentry_exe=None)
    return 0


if __name__ == "__main__":
    sys.exit(main())
