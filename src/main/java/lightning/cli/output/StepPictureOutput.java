package lightning.cli.output;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Output options of commands that write one image, or one after each group of edits. */
public final class StepPictureOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true,
            description = "Output image: .png or .xpm (with the view transform), .pfm (linear floats), .exr (linear halves or floats) or "
                    + ".hdr (8 bits with a shared exponent). With %%d in its name, which becomes a number from 1, an image after each "
                    + "group of edits, else after the last. A name without an extension is a folder for such PNG images.")
    private Path file;

    @Override
    public Path file() {
        return file;
    }
}
