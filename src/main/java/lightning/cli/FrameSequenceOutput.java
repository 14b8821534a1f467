package lightning.cli;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** The options of commands that write a picture for each frame of a shot. */
final class FrameSequenceOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FOLDER", required = true,
            description = {
                "The folder of the pictures, which are .png; made if it is not there. Or a name with an ending, before which each",
                "picture gets its number: out/bird.exr for out/bird-0001.exr, in a folder that is there."})
    private Path output;

    @Override
    Path file() {
        return output;
    }
}
