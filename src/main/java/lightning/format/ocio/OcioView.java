package lightning.format.ocio;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import lightning.base.file.AtomicFile;
import lightning.base.file.RegularFile;
import lightning.base.text.Quote;
import lightning.base.work.Progress;
import lightning.format.image.CubeLutReader;
import lightning.render.image.CubeLut;
import lightning.render.image.ViewTransform;

/**
 * View of an OpenColorIO configuration as a table, and how far it is from the exact view.
 *
 * @param table table with its logarithm
 * @param cube  the table as a .cube file, whose comments say where it comes from
 * @param facts range and error
 */
public record OcioView(String display, String view, CubeLut table, byte[] cube, Facts facts) {
    // The array is never changed.
    private static final int MAX_NAME_LENGTH = 60;

    /**
     * Properties of a table. Errors are the largest of the three channels, in steps of 8 bits.
     *
     * @param note         what was assumed; empty if nothing was
     * @param low          stops below middle gray that are shown as black
     * @param high         stops above middle gray after which colors do not change
     * @param largestError largest error of the compared colors
     * @param error99      error that 99 % of them do not exceed
     * @param meanError    mean error
     * @param colors       number of compared random colors
     */
    public record Facts(String note, double low, double high, double largestError, double error99, double meanError, int colors) {}

    /**
     * Makes the table of a view.
     *
     * @throws IOException if OpenColorIO cannot read the configuration or use the view, or there is no Python with it; the message is a
     *     sentence
     */
    public static OcioView bake(OcioConfig config, OcioConfig.Choice choice, Progress progress) throws IOException {
        String display = config.display(choice);
        String view = config.view(choice);
        return OcioConverter.installed().convert(config.source(), List.of(choice.display(), choice.view()), progress, folder -> {
            Path file = folder.resolve("table.cube");
            byte[] cube = RegularFile.readBytes(file, "a file of the converter", CubeLutReader.MAX_BYTES);
            return new OcioView(display, view, CubeLutReader.read(file).withFile(Path.of(fileName("", display, view))), cube,
                    OcioConverter.readJson(folder.resolve("table.json"), Facts.class));
        });
    }

    /**
     * Makes the table of the view that a reference names.
     *
     * @throws IOException as {@link #bake}, or if the configuration has no such view
     */
    public static OcioView bake(OcioReference reference, Progress progress) throws IOException {
        OcioConfig config = OcioConfig.read(reference.config(), progress);
        return bake(config, config.find(reference.view()), progress);
    }

    /** Returns the view transform. */
    public ViewTransform transform() {
        return ViewTransform.DEFAULT.withLut(Optional.of(table));
    }

    /** Writes the table as a .cube file; returns the view with the table of this file. */
    public OcioView write(Path file) throws IOException {
        AtomicFile.of(file).write(cube);
        return new OcioView(display, view, table.withFile(file), cube, facts);
    }

    /** Returns the name of the table's file next to a scene, such as {@code bird.sRGB-Film.cube}. */
    public String fileName(String scene) {
        return fileName(scene + ".", display, view);
    }

    private static String fileName(String start, String display, String view) {
        return start + safe(display) + "-" + safe(view) + CubeLutReader.EXTENSION;
    }

    /** Returns a name that each file system accepts within a file's name. */
    private static String safe(String name) {
        String safe = name.replaceAll("[^\\p{L}\\p{N} ._()+-]", "_");
        return safe.length() > MAX_NAME_LENGTH ? safe.substring(0, safe.offsetByCodePoints(0, MAX_NAME_LENGTH / 2)) + "…" : safe;
    }

    /** Returns a sentence with the error of the table. */
    public String errorText() {
        return String.format(Locale.ROOT,
                "a table of %s colors stands for this view; its error in steps of 8 bits is %.2f on average, below %.2f for 99 %% of colors "
                        + "and at most %.1f (%d random colors)",
                table.sizeText(), facts.meanError, facts.error99, facts.largestError, facts.colors);
    }

    /** Returns the title of the view in messages. */
    public String title() {
        return Quote.of(display) + ", " + Quote.of(view);
    }
}
