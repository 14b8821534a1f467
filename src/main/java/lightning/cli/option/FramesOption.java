package lightning.cli.option;

import java.nio.file.Path;
import lightning.cli.output.BadInputException;
import lightning.format.jen.JenDocument;
import lightning.scene.shot.Shot;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** Option {@code --frames}. */
public final class FramesOption {
    @Option(names = "--frames", paramLabel = "FIRST-LAST", converter = FrameRange.Converter.class,
            description = "Frame range, such as 1-240 or 17 (default: all of the shot).")
    private @Nullable FrameRange frames;

    /** Returns the selected frames of a shot. */
    public ShotFrames of(Shot shot) throws BadInputException {
        return ShotFrames.of(shot, frames);
    }

    /** Returns the selected frames of a document. */
    public ShotFrames of(JenDocument document, Path file) throws BadInputException {
        return ShotFrames.of(document, file, frames);
    }
}
