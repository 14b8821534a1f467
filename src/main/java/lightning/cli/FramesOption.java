package lightning.cli;

import java.nio.file.Path;
import lightning.format.jen.JenDocument;
import picocli.CommandLine.Option;

/** The option {@code --frames}. */
final class FramesOption {
    @Option(names = "--frames", paramLabel = "FIRST-LAST", converter = FrameRange.Converter.class,
            description = "Which frames, as in 1-240 or 17; those of the shot without it.")
    private FrameRange frames;

    /** The frames of a document. */
    ShotFrames of(JenDocument document, Path file) throws BadInputException {
        return ShotFrames.of(document, file, frames);
    }
}
