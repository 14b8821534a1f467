package lightning.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import lightning.file.SafeFile;
import lightning.image.Clipping;
import lightning.image.DisplayCurve;
import lightning.image.Film;
import lightning.image.PictureFile;
import lightning.image.ViewTransform;
import lightning.scene.Scene;
import lightning.text.Quote;
import lightning.work.Memory;
import picocli.CommandLine.ITypeConverter;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.TypeConversionException;

/** The options that say where a picture goes and how bright it is shown. */
final class PictureOutput {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = {"-o", "--output"}, paramLabel = "FILE", required = true,
            description = {"The picture: .png and .xpm as it is displayed, .pfm every linear value in full (32-bit floats),",
                ".exr (OpenEXR) likewise or as halves, .hdr (Radiance) with 8 bits and an exponent."})
    private Path file;

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

    Path file() {
        return file;
    }

    @Option(names = "--view", paramLabel = "CURVE", converter = Curve.class,
            description = {"How .png and .xpm show light: srgb (the default), 1998 for the linear values as they are, filmic or aces for",
                "highlights that roll off, false for a colour for each stop."})
    private void setCurve(DisplayCurve curve) {
        view = view.withCurve(curve);
    }

    /** The names that an artist types. */
    private static final class Curve implements ITypeConverter<DisplayCurve> {
        @Override
        public DisplayCurve convert(String text) {
            return Arrays.stream(DisplayCurve.values()).filter(curve -> curve.word().equals(text)).findFirst()
                    .orElseThrow(() -> new TypeConversionException("expected srgb, 1998, filmic, aces or false, found " + Quote.of(text)));
        }
    }

    /** How the picture is shown. */
    ViewTransform view() {
        return view;
    }

    /** Finds out before a long computation whether its result could not be written. */
    void check() throws IOException {
        PictureFile.requireKnownExtension(file);
        PictureFile.requireBits(file, bits());
        checkFile(file);
    }

    /** Of a number in the file. */
    int bits() throws IOException {
        return bits == null ? PictureFile.bits(file).getFirst() : bits;
    }

    static void checkFile(Path file) throws IOException {
        SafeFile.at(file).check();
    }

    /** The bytes that a picture may take when its output needs some too. */
    long memory(Scene scene) throws IOException {
        return Memory.available() - PictureFile.bytesToWrite(file, scene.picture().width(), scene.picture().height());
    }

    /** Writes the picture, and says how much of it the file cannot show. */
    void write(Film film, Console console) throws IOException {
        PictureFile.write(file, film, view, bits());
        Clipping clipping = Clipping.of(film, view);
        if (clipping.pixels() > 0 && PictureFile.isDisplayed(file)) {
            console.line("%s: %d of %d pixels (%.1f %%) are cut off at white, the brightest is %.3g times as bright", file,
                    clipping.pixels(), clipping.all(), 100.0 * clipping.pixels() / clipping.all(), clipping.brightest());
        }
    }
}
