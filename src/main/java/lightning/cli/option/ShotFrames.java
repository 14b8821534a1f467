package lightning.cli.option;

import java.nio.file.Path;
import java.util.concurrent.CancellationException;
import lightning.base.text.RefusalException;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.format.jen.JenDocument;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import org.jspecify.annotations.Nullable;

/** Selected frames of a shot. */
public record ShotFrames(Shot shot, FrameRange range) {
    /**
     * Returns the selected frames of a document.
     *
     * @param requested selected frames, or null for all frames of the shot
     */
    static ShotFrames of(JenDocument document, Path file, @Nullable FrameRange requested) throws BadInputException {
        Shot shot = document.shot().orElseThrow(() -> new BadInputException(Console.text(
                "%s: has no shot block (see docs/jen-format.md)", file)));
        return of(shot, requested);
    }

    /** Returns the selected frames of a shot, as above. */
    static ShotFrames of(Shot shot, @Nullable FrameRange requested) throws BadInputException {
        FrameRange range = requested == null ? new FrameRange(shot.first(), shot.last()) : requested;
        if (range.count() > FrameRange.MAX_FRAMES) {
            throw new BadInputException(
                    "the shot has " + range.count() + " frames; choose at most " + FrameRange.MAX_FRAMES + " of them with --frames");
        }
        return new ShotFrames(shot, range);
    }

    /** Checks that every selected frame gives a valid scene, before the first image is rendered. */
    public void check(Scene scene) throws BadInputException {
        for (int frame = range.first(); frame <= range.last(); frame++) {
            if (Thread.currentThread().isInterrupted()) {
                throw new CancellationException();
            }
            sceneAt(scene, frame);
        }
    }

    Scene sceneAt(Scene scene, int frame) throws BadInputException {
        try {
            return shot.sceneAt(scene, frame);
        } catch (RefusalException e) {
            throw new BadInputException(e.getMessage());
        }
    }
}
