package lightning.cli;

import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.format.jen.JenDocument;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;

/** The frames that are asked for. */
record ShotFrames(Shot shot, FrameRange range) {
    /**
     * The frames of a document.
     *
     * @param asked null for all frames of the shot
     */
    static ShotFrames of(JenDocument document, Path file, FrameRange asked) throws BadInput {
        Shot shot = document.shot().orElseThrow(() -> new BadInput(Console.text(
                "%s: has no shot; docs/jen-format.md tells how a shot block says one", file)));
        FrameRange range = asked == null ? new FrameRange(shot.first(), shot.last()) : asked;
        if (range.count() > FrameRange.MOST) {
            throw new BadInput("the shot has " + range.count() + " frames; choose at most " + FrameRange.MOST + " of them with --frames");
        }
        return new ShotFrames(shot, range);
    }

    /** Refuses a scene that is none in some frame, before the first picture is begun. */
    void check(Scene scene) throws BadInput {
        for (int frame = range.first(); frame <= range.last(); frame++) {
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException();
            }
            at(scene, frame);
        }
    }

    Scene at(Scene scene, int frame) throws BadInput {
        try {
            return shot.at(scene, frame);
        } catch (IllegalArgumentException e) {
            throw new BadInput(e.getMessage());
        }
    }
}
