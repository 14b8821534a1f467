package lightning.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.image.Clipping;
import lightning.image.Film;
import lightning.image.PictureFile;
import lightning.image.ViewTransform;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** The options that say where a picture goes and how bright it is shown. */
final class PictureOutput {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true,
            description = "The picture: .png and .xpm as it is displayed, .pfm every linear value in full (32-bit floats).")
    private Path file;

    private ViewTransform view = ViewTransform.DEFAULT;

    @Option(names = "--exposure", paramLabel = "STOPS",
            description = "Brightens .png and .xpm: each stop doubles (-1 halves).")
    private void setExposure(double stops) {
        try {
            view = new ViewTransform(stops);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command.commandLine(), "--" + e.getMessage());
        }
    }

    Path file() {
        return file;
    }

    /** Stops. */
    double exposure() {
        return view.exposure();
    }

    /** Finds out before a long computation whether its result could not be written. */
    void check() throws IOException, BadInput {
        PictureFile.requireKnownExtension(file);
        checkFolder(file);
    }

    static void checkFolder(Path file) throws BadInput {
        Path folder = file.toAbsolutePath().getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            throw new BadInput(file + ": there is no folder " + folder);
        }
        if (Files.isDirectory(file)) {
            throw new BadInput(file + ": is a folder, expected a file");
        }
        if (!Files.isWritable(folder)) {
            throw new BadInput(file + ": permission denied to write into " + folder);
        }
    }

    /** Writes the picture, and says how much of it the file cannot show. */
    void write(Film film, Console console) throws IOException {
        PictureFile.write(file, film, view);
        Clipping clipping = Clipping.of(film, view);
        if (clipping.pixels() > 0 && PictureFile.isDisplayed(file)) {
            console.line("%s: %d of %d pixels (%.1f %%) are cut off at white, the brightest is %.3g times as bright", file,
                    clipping.pixels(), clipping.all(), 100.0 * clipping.pixels() / clipping.all(), clipping.brightest());
        }
    }
}
