package lightning.cli;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Output options of commands that write one image, or one after each group of edits. */
final class StepPictureOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true,
            description = "Output image after the last edit: .png, .xpm, .pfm, .exr or .hdr. With %%d in its name, which becomes a number "
                    + "from 1, an image after each group of edits: step-%%d.png. So does a folder for PNG images, created if missing.")
    private Path file;

    @Override
    Path file() {
        return file;
    }
}
