package lightning.cli;

import java.nio.file.Path;
import lightning.format.jen.JenDocument;
import picocli.CommandLine.Option;

/** Option {@code --frames}. */
final class FramesOption {
    @Option(names = "--frames", paramLabel = "FIRST-LAST", converter = FrameRange.Converter.class,
            description = "Frame range, such as 1-240 or 17 (default: all of the shot).")
    private FrameRange frames;

    /** Returns the selected frames of a document. */
    ShotFrames of(JenDocument document, Path file) throws BadInputException {
        return ShotFrames.of(document, file, frames);
    }
}
