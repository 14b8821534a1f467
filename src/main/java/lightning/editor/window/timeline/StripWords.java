package lightning.editor.window.timeline;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import lightning.base.text.Texts;
import lightning.scene.shot.Shot;
import lightning.shot.FrameState;

/** What is told of a film strip's frames. */
final class StripWords {
    private StripWords() {}

    /** How far all are, and who keeps them; empty where they are here and all is done. */
    static String of(FilmStrip strip, Shot shot) {
        int all = shot.last() - shot.first() + 1;
        int current = strip.count(FrameState.CURRENT);
        int failed = strip.count(FrameState.FAILED);
        OptionalInt machines = strip.frames().machines();
        if (machines.isEmpty() && current == all) {
            return "";
        }
        List<String> parts = new ArrayList<>();
        machines.ifPresent(count -> parts.add(count == 0 ? nobody(strip)
                : Texts.count(count, "{0} machine", "{0} machines", count)));
        parts.add(Texts.of("{0} of {1} frames", current, all));
        if (failed > 0) {
            parts.add(Texts.of("{0} failed", failed));
        }
        if (strip.news().hasLost() && machines.orElse(0) > 0) {
            parts.add(Texts.of("a machine is gone, others trace its frames"));
        }
        return String.join(", ", parts);
    }

    private static String nobody(FilmStrip strip) {
        String asked = strip.frames() instanceof FramesElsewhere far ? far.asked() : "";
        return strip.news().hasLost() ? Texts.of("all machines are gone; one that comes goes on")
                : Texts.of("no machine answers at {0}: none is there yet, or it has another certificate", asked);
    }

    /** One frame, for who does not see it. */
    static String ofFrame(FilmStrip strip, int frame) {
        String name = Texts.of("frame {0}", frame);
        return switch (strip.state(frame)) {
            case CURRENT -> name;
            case STALE -> Texts.of("{0}, before the newest edit", name);
            case MISSING -> Texts.of("{0}, not there yet", name);
            case FAILED -> Texts.of("{0} cannot be made: {1}", name, strip.news().problem(frame).orElse(""));
        };
    }
}
