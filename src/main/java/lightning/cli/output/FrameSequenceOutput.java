package lightning.cli.output;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Output options of commands that write an image for each frame of a shot. */
public final class FrameSequenceOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FOLDER", required = true,
            description = "Output folder for PNG images, created if missing. Or a file name in an existing folder, to which each "
                    + "frame's number is added: out/bird.exr writes out/bird-0001.exr and so on.")
    private Path output;

    @Override
    public Path file() {
        return output;
    }
}
