package lightning.cli;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** Output options of commands that write one image. */
final class SinglePictureOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true,
            description = "Output image: .png and .xpm with the view transform, .pfm linear 32-bit floats, .exr (OpenEXR) linear "
                    + "floats or halves, .hdr (Radiance) 8 bits with a shared exponent.")
    private Path file;

    @Override
    Path file() {
        return file;
    }
}
