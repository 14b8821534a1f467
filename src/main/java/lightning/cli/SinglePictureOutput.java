package lightning.cli;

import java.nio.file.Path;
import picocli.CommandLine.Option;

/** The options of commands that write one picture. */
final class SinglePictureOutput extends PictureOutput {
    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true,
            description = {"The picture: .png and .xpm as it is displayed, .pfm every linear value in full (32-bit floats),",
                ".exr (OpenEXR) likewise or as halves, .hdr (Radiance) with 8 bits and an exponent."})
    private Path file;

    @Override
    Path file() {
        return file;
    }
}
