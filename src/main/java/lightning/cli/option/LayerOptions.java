package lightning.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import lightning.base.work.HeapBudget;
import lightning.base.work.WorkerPool;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.PictureOutput;
import lightning.cli.output.ProgressBar;
import lightning.format.exr.ExrType;
import lightning.format.image.ImageFormat;
import lightning.layer.ExrContent;
import lightning.layer.LayeredExrWriter;
import lightning.layer.ShotFrame;
import lightning.layer.WriteEstimate;
import lightning.render.cache.PixelCache;
import lightning.render.engine.EngineChoice;
import lightning.render.relight.MemoryEstimate;
import lightning.scene.PictureSettings;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options for layers and mattes of written images. */
public final class LayerOptions {
    /** Uncompressed bytes from which on a file's size, memory and time are printed before it is written. */
    private static final long LONG_WRITE_BYTES = 128_000_000;

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    @Mixin
    private ExrOptions storage;

    @Option(names = "--layers",
            description = "Also write layers to the .exr: background, ambient, emission, each light's diffuse, specular, indirect light, "
                    + "reflections and fog (which add up to the image), alpha, normals, positions, depth, texture coordinates, objects, "
                    + "materials, and motion vectors in a shot.")
    private boolean layers;

    @Option(names = "--light-groups", description = "With --layers: layers of each light group in place of its lights.")
    private boolean grouped;

    @Option(names = "--cryptomatte", paramLabel = "FILE",
            description = "Also write mattes of objects, materials and assets (Cryptomatte) to an .exr file, named like that of -o; the "
                    + "same name adds them to the image's file.")
    private @Nullable Path mattes;

    private int levels = ExrContent.DEFAULT_MATTE_LEVELS;

    @Option(names = "--cryptomatte-levels", paramLabel = "N",
            description = "Objects per pixel that mattes have room for: even, 2 to " + ExrContent.MAX_MATTE_LEVELS + " (default: "
                    + ExrContent.DEFAULT_MATTE_LEVELS + ").")
    private void setLevels(int value) {
        if (value < 2 || value > ExrContent.MAX_MATTE_LEVELS || value % 2 != 0) {
            throw new ParameterException(command.commandLine(),
                    "--cryptomatte-levels must be an even number from 2 to " + ExrContent.MAX_MATTE_LEVELS + ", was " + value);
        }
        levels = value;
    }

    /** Returns the file for mattes, or the pattern of its name. */
    public Optional<Path> mattes() {
        return Optional.ofNullable(mattes);
    }

    /** Returns an option that was used, for messages. */
    public Optional<String> usedOption() {
        return layers ? Optional.of("--layers") : mattes().map(_ -> "--cryptomatte").or(storage::usedOption);
    }

    /** Returns what a picture without a cache lacks for the used options. */
    public String requiredContent() {
        return layers || mattes == null ? "layers" : "mattes";
    }

    /** Checks the options against the formats of the files, before a long computation. */
    public void checkFormats(PictureOutput output, Path picture) throws IOException, BadInputException {
        storage.checkFormat(output, picture, mattes != null);
        if (layers && !ImageFormat.of(picture).canHaveLayers()) {
            throw new BadInputException(Console.text("%s: layers are written to .exr", picture));
        }
        if (grouped && !layers) {
            throw new BadInputException("--light-groups needs --layers");
        }
        if (mattes != null && !ImageFormat.find(mattes).map(ImageFormat::canHaveLayers).orElse(false)) {
            throw new BadInputException(Console.text("%s: mattes are written to .exr", mattes));
        }
    }

    /** Checks the options against the size of the picture, before a long computation. */
    public void checkSize(PictureSettings picture) throws BadInputException {
        storage.checkSize(picture);
    }

    /**
     * Writes an image with its layers and mattes.
     *
     * @param cache  cache of the finished image
     * @param picture file of the image; empty to write only mattes
     * @param matteFile file of the mattes; empty to write none
     * @param frame frame of the image in its shot; empty if it is not part of one
     */
    public void write(PictureOutput output, PixelCache cache, EngineChoice engines, Optional<Path> picture, Optional<Path> matteFile,
            Optional<ShotFrame> frame, WorkerPool workers, Console console) throws IOException {
        boolean sameFile = picture.isPresent() && picture.map(LayerOptions::normalized).equals(matteFile.map(LayerOptions::normalized));
        if (picture.isPresent()) {
            boolean isStoredByOptions = storage.usedOption().isPresent() && ImageFormat.of(picture.get()).canHaveLayers();
            if (layers || sameFile || isStoredByOptions) {
                ExrType type = output.bits(picture.get()) == Short.SIZE ? ExrType.HALF : ExrType.FLOAT;
                // All frames of a shot have the same layers, because compositing programs read them from the first one.
                ExrContent.Layers choice =
                        !layers ? ExrContent.Layers.NONE : frame.isPresent() ? ExrContent.Layers.ALL : ExrContent.Layers.LIT;
                writeExr(picture.get(), cache, engines, new ExrContent(type, choice, grouped, sameFile ? levels : 0, output.primaries()),
                        frame, workers, console);
            } else {
                output.write(cache.scene(), cache.film(), picture.get(), frame.map(ShotFrame::time), workers);
            }
        }
        if (matteFile.isPresent() && !sameFile) {
            writeExr(matteFile.get(), cache, engines, ExrContent.mattes(levels, output.primaries()), frame, workers, console);
        }
    }

    private static Path normalized(Path file) {
        return file.toAbsolutePath().normalize();
    }

    private void writeExr(Path file, PixelCache cache, EngineChoice engines, ExrContent content, Optional<ShotFrame> frame,
            WorkerPool workers, Console console) throws IOException {
        long start = System.nanoTime();
        LayeredExrWriter writer = new LayeredExrWriter(cache, engines, content, storage.layout(), frame);
        long memory = HeapBudget.availableBytes() - MemoryEstimate.usedBytes(cache);
        try (ProgressBar bar = new ProgressBar(console, "writing")) {
            if (writer.uncompressedBytes() >= LONG_WRITE_BYTES) {
                printEstimate(file, writer, writer.estimate(memory, workers, bar), console);
            }
            writer.write(file, memory, workers, bar);
        }
        boolean hasLayers = content.layers() != ExrContent.Layers.NONE;
        String parts = hasLayers ? Console.count(writer.layerCount(), "layer") : content.matteLevels() > 0 ? "mattes" : "picture";
        console.print("%s: %s%s of %d x %d pixels, written in %.1f ms", file, parts,
                hasLayers && content.matteLevels() > 0 ? " and mattes" : "", cache.scene().picture().width(),
                cache.scene().picture().height(), (System.nanoTime() - start) / 1e6);
        if (writer.crowdedPixels() > 0) {
            console.warn("%s: %s with too many objects or materials for %s; --cryptomatte-levels=%s has room for all", file,
                    Console.count(writer.crowdedPixels(), "pixel"), Console.count(levels, "level"),
                    writer.maxIds() + writer.maxIds() % 2);
        }
    }

    private static void printEstimate(Path file, LayeredExrWriter writer, WriteEstimate estimate, Console console) {
        console.print("%s: about %.0f MB for %s, %.0f MB of memory and %s", file, estimate.fileBytes() / 1e6,
                Console.count(writer.channelCount(), "channel"), estimate.memoryBytes() / 1e6, ProgressBar.duration(estimate.seconds()));
    }
}
