package lightning.cli;

import java.io.IOException;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import lightning.base.file.AtomicFile;
import lightning.base.text.Quote;
import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;
import lightning.format.image.CubeLutReader;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
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
abstract sealed class PictureOutput permits SinglePictureOutput, FrameSequenceOutput {
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

    @Option(names = "--view", paramLabel = "VIEW", converter = ViewConverter.class,
            description = {"How .png and .xpm show light: srgb (the default), 1998 for the linear values as they are, filmic or aces for",
                "highlights that roll off, false for a color for each stop; a .cube table, or one behind one of these: filmic+look.cube."})
    private void setView(ViewTransform newView) {
        view = newView.withExposure(view.exposure());
    }

    /** The names that an artist types, and files. */
    private static final class ViewConverter implements ITypeConverter<ViewTransform> {
        @Override
        public ViewTransform convert(String text) {
            int plus = text.indexOf('+');
            Optional<DisplayCurve> curve = curve(plus < 0 ? text : text.substring(0, plus));
            String file = curve.isEmpty() ? text : plus < 0 ? "" : text.substring(plus + 1);
            ViewTransform shown = ViewTransform.DEFAULT.withCurve(curve.orElse(DisplayCurve.SRGB));
            if (file.isEmpty()) {
                return shown;
            }
            if (!file.endsWith(CubeLutReader.EXTENSION)) {
                throw new TypeConversionException("expected srgb, 1998, filmic, aces, false or a .cube file, found " + Quote.of(file));
            }
            try {
                return shown.withLut(Optional.of(CubeLutReader.read(Path.of(file))));
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
        checkFormat(file());
        checkFile(file());
    }

    /** The same of what the ending of a file's name says alone. */
    void checkFormat(Path picture) throws IOException {
        ImageFormat.of(picture).requireBitDepth(picture, bits(picture));
    }

    /** Of a number in the file. */
    int bits() throws IOException {
        return bits(file());
    }

    private int bits(Path picture) throws IOException {
        return bits == null ? ImageFormat.of(picture).bitDepths().getFirst() : bits;
    }

    static void checkFile(Path file) throws IOException {
        AtomicFile.of(file).check();
    }

    /** The bytes that a picture may take when its output needs some too. */
    long availableMemory(Scene scene) throws IOException {
        return availableMemory(scene, file());
    }

    /** The same where the picture goes to another file than was named. */
    static long availableMemory(Scene scene, Path picture) throws IOException {
        return HeapBudget.availableBytes() - ImageFormat.of(picture).bytesToWrite(scene.picture().width(), scene.picture().height());
    }

    /** Writes the picture to another file than was named. */
    void write(Film film, Path picture) throws IOException {
        ImageFile.write(picture, film, view, bits(picture));
    }

    /**
     * Writes the picture, and says how much of it the file cannot show.
     *
     * @param threads how many make it
     */
    void write(Film film, int threads, Console console) throws IOException {
        try (WorkerPool workers = new WorkerPool(threads)) {
            ImageFile.write(file(), film, view, bits(), workers);
        }
        Clipping clipping = Clipping.of(film, view);
        if (clipping.clippedPixels() > 0 && ImageFormat.of(file()).isDisplayReferred()) {
            console.print("%s: %d of %d pixels (%.1f %%) are cut off at white, the brightest is %.3g times as bright", file(),
                    clipping.clippedPixels(), clipping.totalPixels(), 100.0 * clipping.clippedPixels() / clipping.totalPixels(),
                    clipping.brightest());
        }
    }
}
