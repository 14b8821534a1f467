#!/usr/bin/env python3
"""OpenCue: renders a shot, a chunk of consecutive frames in each process. Needs opencue_pyoutline.

    opencue_shot.py SCENE FOLDER --frames 1-240 --chunk 8 [options of "lightning shot render"]
"""

import argparse
from pathlib import Path

import outline
import outline.cuerun
from outline.modules.shell import Shell


def main() -> None:
    """Launches the job, or prints it."""
    parser = argparse.ArgumentParser(description="Renders a shot on an OpenCue farm.")
    parser.add_argument("scene", help="a scene with a shot block, at the same path on all machines")
    parser.add_argument("folder", help="folder for the pictures")
    parser.add_argument("--frames", default="1-48", help="frames, such as 1-240")
    parser.add_argument("--chunk", type=int, default=8, help="consecutive frames of a process")
    parser.add_argument("--program", default="lightning", help="Lightning's program")
    parser.add_argument("--cores", type=int, default=4, help="processors of a process")
    parser.add_argument("--print", action="store_true", help="print the job in place of launching it")
    options, others = parser.parse_known_args()

    job = outline.Outline(f"lightning-{Path(options.scene).stem}", frame_range=options.frames)
    job.add_layer(Shell("render", range=options.frames, chunk=options.chunk, cores=options.cores, threadable=False, command=[
        options.program, "shot", "render", options.scene, "--frames", "#FRAME_START#-#FRAME_END#", "-o", options.folder,
        "--threads", str(options.cores), *others]))
    if options.print:
        launcher = outline.cuerun.OutlineLauncher(job)
        print(launcher.serialize(use_pycuerun=False))
    else:
        outline.cuerun.launch(job, use_pycuerun=False)


if __name__ == "__main__":
    main()
