package lightning.cli.output;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Output options of commands that write one image. */
public final class SinglePictureOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true,
            description = "Output image: .png or .xpm (with the view transform), .pfm (linear floats), .exr (linear halves or "
                    + "floats) or .hdr (8 bits with a shared exponent).")
    private Path file;

    @Override
    public Path file() {
        return file;
    }
}
