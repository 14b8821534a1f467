package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import lightning.base.text.Messages;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;

/** Status texts of a film strip. */
final class FilmStripText {
    private FilmStripText() {}

    /** Describes the progress and the machines; empty if all frames are current and local. */
    static String status(FilmStrip strip, Shot shot) {
        int frameCount = shot.last() - shot.first() + 1;
        int current = strip.count(FrameState.CURRENT);
        int failed = strip.count(FrameState.FAILED);
        OptionalInt machines = strip.frames().machineCount();
        if (machines.isEmpty() && current == frameCount) {
            return "";
        }
        List<String> parts = new ArrayList<>();
        machines.ifPresent(count -> parts.add(count == 0 ? noMachineText(strip)
                : Messages.count(count, "{0} node", "{0} nodes", count)));
        parts.add(Messages.tr("{0} of {1} frames", current, frameCount));
        if (failed > 0) {
            parts.add(Messages.tr("{0} failed", failed));
        }
        if (strip.status().hasLostMachine() && machines.orElse(0) > 0) {
            parts.add(Messages.tr("lost a node; its frames are being rendered on other nodes"));
        }
        return String.join(", ", parts);
    }

    private static String noMachineText(FilmStrip strip) {
        String hosts = strip.frames() instanceof RemoteFrames remote ? remote.hosts() : "";
        return strip.status().hasLostMachine() ? Messages.tr("all nodes lost; rendering resumes when a node connects")
                : Messages.tr("no node responds at {0}: it may not be running, or its certificate differs", hosts);
    }

    /** Returns the accessible text of one frame. */
    static String frameText(FilmStrip strip, int frame) {
        String name = Messages.tr("frame {0}", frame);
        return switch (strip.state(frame)) {
            case CURRENT -> name;
            case STALE -> Messages.tr("{0}, out of date", name);
            case MISSING -> Messages.tr("{0}, not rendered yet", name);
            case FAILED -> Messages.tr("{0} failed: {1}", name, strip.status().problem(frame).orElse(""));
        };
    }
}
