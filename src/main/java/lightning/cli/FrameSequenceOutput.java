package lightning.cli;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Output options of commands that write an image for each frame of a shot. */
final class FrameSequenceOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FOLDER", required = true,
            description = "The folder of the images (.png), created if missing; or a file name to which each frame's number is added: "
                    + "out/bird.exr for out/bird-0001.exr, in an existing folder.")
    private Path output;

    @Override
    Path file() {
        return output;
    }
}
