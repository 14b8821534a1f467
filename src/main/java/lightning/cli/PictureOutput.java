package lightning.cli;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import lightning.base.file.SafeFile;
import lightning.base.text.Quote;
import lightning.base.work.Memory;
import lightning.base.work.Workers;
import lightning.format.picture.CubeReader;
import lightning.format.picture.PictureFile;
import lightning.format.picture.PictureFormat;
import lightning.render.image.Clipping;
import lightning.render.image.DisplayCurve;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** The options that say how pictures are written and how bright they are shown; where they go is said by each kind. */
abstract sealed class PictureOutput permits SinglePicture, FramesOutput {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--bits", paramLabel = "N",
            description = "Of a number in the file: .png 8 or 16, .exr 16 (half) or 32 (float); the first without it.")
    private Integer bits;

    private ViewTransform view = ViewTransform.DEFAULT;

    @Option(names = "--exposure", paramLabel = "STOPS",
            description = "Brightens .png and .xpm: each stop doubles (-1 halves).")
    private void setExposure(double stops) {
        try {
            view = view.withExposure(stops);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(command.commandLine(), "--" + e.getMessage());
        }
    }

    /** What stands behind {@code -o}. */
    abstract Path file();

    @Option(names = "--view", paramLabel = "VIEW", converter = View.class,
            description = {"How .png and .xpm show light: srgb (the default), 1998 for the linear values as they are, filmic or aces for",
                "highlights that roll off, false for a colour for each stop; a .cube table, or one behind one of these: filmic+look.cube."})
    private void setView(ViewTransform shown) {
        view = shown.withExposure(view.exposure());
    }

    /** The names that an artist types, and files. */
    private static final class View implements ITypeConverter<ViewTransform> {
        @Override
        public ViewTransform convert(String text) {
            int plus = text.indexOf('+');
            Optional<DisplayCurve> curve = curve(plus < 0 ? text : text.substring(0, plus));
            String file = curve.isEmpty() ? text : plus < 0 ? "" : text.substring(plus + 1);
            ViewTransform shown = ViewTransform.DEFAULT.withCurve(curve.orElse(DisplayCurve.SRGB));
            if (file.isEmpty()) {
                return shown;
            }
            if (!file.endsWith(CubeReader.ENDING)) {
                throw new TypeConversionException("expected srgb, 1998, filmic, aces, false or a .cube file, found " + Quote.of(file));
            }
            try {
                return shown.withCube(Optional.of(CubeReader.read(Path.of(file))));
            } catch (InvalidPathException | IOException e) {
                throw new TypeConversionException("expected a .cube table: " + e.getMessage());
            }
        }

        private static Optional<DisplayCurve> curve(String word) {
            return Arrays.stream(DisplayCurve.values()).filter(curve -> curve.word().equals(word)).findFirst();
        }
    }

    /** How the picture is shown. */
    ViewTransform view() {
        return view;
    }

    /** Finds out before a long computation whether its result could not be written. */
    void check() throws IOException {
        checkKind(file());
        checkFile(file());
    }

    /** The same of what the ending of a file's name says alone. */
    void checkKind(Path picture) throws IOException {
        PictureFormat.of(picture).requireBits(picture, bits(picture));
    }

    /** Of a number in the file. */
    int bits() throws IOException {
        return bits(file());
    }

    private int bits(Path picture) throws IOException {
        return bits == null ? PictureFormat.of(picture).bits().getFirst() : bits;
    }

    static void checkFile(Path file) throws IOException {
        SafeFile.at(file).check();
    }

    /** The bytes that a picture may take when its output needs some too. */
    long memory(Scene scene) throws IOException {
        return memory(scene, file());
    }

    /** The same where the picture goes to another file than was named. */
    static long memory(Scene scene, Path picture) throws IOException {
        return Memory.available() - PictureFormat.of(picture).bytesToWrite(scene.picture().width(), scene.picture().height());
    }

    /** Writes the picture to another file than was named. */
    void write(Film film, Path picture) throws IOException {
        PictureFile.write(picture, film, view, bits(picture));
    }

    /**
     * Writes the picture, and says how much of it the file cannot show.
     *
     * @param threads how many make it
     */
    void write(Film film, int threads, Console console) throws IOException {
        try (Workers workers = new Workers(threads)) {
            PictureFile.write(file(), film, view, bits(), workers);
        }
        Clipping clipping = Clipping.of(film, view);
        if (clipping.pixels() > 0 && PictureFormat.of(file()).isDisplayed()) {
            console.line("%s: %d of %d pixels (%.1f %%) are cut off at white, the brightest is %.3g times as bright", file(),
                    clipping.pixels(), clipping.all(), 100.0 * clipping.pixels() / clipping.all(), clipping.brightest());
        }
    }
}
