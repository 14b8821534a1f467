package lightning.cli.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import lightning.base.file.AtomicFile;
import lightning.base.text.Quote;
import lightning.base.text.RefusalException;
import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;
import lightning.format.exr.ExrPrimaries;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.jen.InputFiles;
import lightning.layer.FrameTime;
import lightning.layer.SceneMetadata;
import lightning.render.image.Clipping;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options for the format and display transform of written images; subclasses add the output path. */
public abstract sealed class PictureOutput permits SinglePictureOutput, StepPictureOutput, FrameSequenceOutput {
    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Option(names = "--bits", paramLabel = "N",
            description = "Bits per channel: PNG 8 or 16, EXR 16 (half) or 32 (float) (default: the smaller number).")
    private @Nullable Integer bits;

    private ExrPrimaries primaries = ExrPrimaries.REC_709;

    @Option(names = "--primaries", paramLabel = "NAME",
            description = "Primaries of a written .exr: rec709 or acescg (ACEScg) (default: rec709).")
    private void setPrimaries(String word) {
        primaries = Arrays.stream(ExrPrimaries.values()).filter(p -> p.word().equals(word)).findFirst().orElseThrow(
                () -> new ParameterException(command.commandLine(), "--primaries: expected rec709 or acescg, found " + Quote.of(word)));
    }

    private @Nullable Double exposure;

    @Option(names = "--exposure", paramLabel = "STOPS",
            description = "Exposure in stops, for PNG and XPM (default: the scene's).")
    private void setExposure(double stops) {
        try {
            exposure = ViewTransform.DEFAULT.withExposure(stops).exposure();
        } catch (RefusalException e) {
            throw new ParameterException(command.commandLine(), "--" + e.getMessage());
        }
    }

    /** Returns the output path of {@code -o}. */
    abstract Path file();

    @Mixin
    private ViewOption view;

    /** Returns the view transform of a scene's image: the options', else the scene's. */
    public ViewTransform view(Scene scene) {
        ViewTransform chosen = view.of(scene);
        return exposure == null ? chosen : chosen.withExposure(exposure);
    }

    /** Checks that the output can be written, before a long computation. */
    public void check() throws IOException {
        checkFormat(file());
        checkFile(file());
    }

    /** Checks the options against the format of a file's extension. */
    public void checkFormat(Path picture) throws IOException {
        ImageFormat.of(picture).requireBitDepth(picture, bits(picture));
        if (primaries != ExrPrimaries.REC_709 && ImageFormat.of(picture) != ImageFormat.EXR) {
            throw new IOException(Quote.path(picture) + ": --primaries " + primaries.word() + " needs an .exr file");
        }
    }

    /** Returns the color space of an OpenEXR file. */
    public ExrPrimaries primaries() {
        return primaries;
    }

    /** Returns the bits per channel of a file. */
    public int bits(Path picture) throws IOException {
        return bits == null ? ImageFormat.of(picture).bitDepths().getFirst() : bits;
    }

    public static void checkFile(Path file) throws IOException {
        AtomicFile.of(file).check();
    }

    /** Checks that a file can be written, and is not one that the command reads. */
    public static void checkFile(Path file, InputFiles inputs) throws IOException {
        inputs.check(file);
        checkFile(file);
    }

    /** Adds the lookup table of the view to the files that the command reads. */
    public InputFiles withViewFile(InputFiles inputs) {
        return view.withFile(inputs);
    }

    /** Prints what there is to say about the accuracy of the view. */
    public void printViewNotes(Console console) {
        view.printNotes(console);
    }

    /** Returns the memory in bytes available for rendering, after subtracting what writing the image needs. */
    public long availableMemory(Scene scene) throws IOException {
        return availableMemory(scene, file());
    }

    /** Returns the memory in bytes available for rendering if the image is written to another file than {@link #file}. */
    public static long availableMemory(Scene scene, Path picture) throws IOException {
        return HeapBudget.availableBytes() - ImageFormat.of(picture).bytesToWrite(scene.picture().width(), scene.picture().height());
    }

    /**
     * Writes an image to another file than {@link #file}.
     *
     * @param time time of the image in its shot; empty if it is not part of one
     */
    public void write(Scene scene, Film film, Path picture, Optional<FrameTime> time) throws IOException {
        try (WorkerPool singleWorker = new WorkerPool(1)) {
            write(scene, film, picture, time, singleWorker);
        }
    }

    /**
     * Writes an image to another file than {@link #file}.
     *
     * @param time time of the image in its shot; empty if it is not part of one
     */
    public void write(Scene scene, Film film, Path picture, Optional<FrameTime> time, WorkerPool workers) throws IOException {
        if (ImageFormat.of(picture) == ImageFormat.EXR) {
            ImageFile.writeExr(picture, film, bits(picture), SceneMetadata.of(scene, time), primaries);
        } else {
            ImageFile.write(picture, film, view(scene), bits(picture), workers);
        }
    }

    /** Returns how many pixels a file of a displayed format clips. */
    public Optional<Clipping> clipping(Scene scene, Film film, Path picture) throws IOException {
        return ImageFormat.of(picture).isDisplayReferred() ? Optional.of(Clipping.of(film, view(scene))) : Optional.empty();
    }

    /** Prints how many pixels a file clips. */
    public void printClipping(Scene scene, Film film, Path picture, Console console) throws IOException {
        Clipping clipping = clipping(scene, film, picture).orElse(null);
        if (clipping != null && clipping.clippedPixels() > 0) {
            console.print("%s: %d of %d pixels (%.1f %%) are clipped, the peak is %.3g times white", picture,
                    clipping.clippedPixels(), clipping.totalPixels(), 100.0 * clipping.clippedPixels() / clipping.totalPixels(),
                    clipping.brightest());
        }
    }
}
