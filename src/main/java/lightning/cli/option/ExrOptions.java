package lightning.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Collectors;
import lightning.base.text.Quote;
import lightning.cli.output.BadInputException;
import lightning.cli.output.Console;
import lightning.cli.output.PictureOutput;
import lightning.format.exr.ExrCompression;
import lightning.format.image.ImageFormat;
import lightning.layer.ExrLayout;
import lightning.layer.ImageCrop;
import lightning.scene.PictureSettings;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options for the storage of written OpenEXR files. */
public final class ExrOptions {
    private static final String COMPRESSION = "--exr-compression";
    private static final String PARTS = "--exr-parts";
    private static final String CROP = "--crop";

    @Spec(Spec.Target.MIXEE)
    private CommandSpec command;

    private ExrCompression compression = ExrCompression.ZIP;

    @Option(names = COMPRESSION, paramLabel = "NAME",
            description = "Compression of a written .exr: none, rle, zips, zip or dwaa. dwaa loses details of colors, and needs 16 bits "
                    + "(default: zip).")
    private void setCompression(String word) {
        compression = ExrCompression.writable().stream().filter(c -> c.word().equals(word)).findFirst()
                .orElseThrow(() -> new ParameterException(command.commandLine(), COMPRESSION + ": expected "
                        + ExrCompression.writable().stream().map(ExrCompression::word).collect(Collectors.joining(", ")) + ", found "
                        + Quote.of(word)));
    }

    @Option(names = PARTS, description = "Write each layer of an .exr as a part of its own, so that programs read only those they show.")
    private boolean parts;

    @Option(names = CROP, paramLabel = "X,Y,W,H", converter = PixelRegion.Converter.class,
            description = "Write only a rectangle of the picture to an .exr; its display window is the whole picture.")
    private @Nullable PixelRegion crop;

    /** Returns an option that was used, for messages. */
    Optional<String> usedOption() {
        return compression != ExrCompression.ZIP ? Optional.of(COMPRESSION) : parts ? Optional.of(PARTS)
                : crop != null ? Optional.of(CROP) : Optional.empty();
    }

    /**
     * Checks the options against the format of a picture, before a long computation.
     *
     * @param hasMattes whether there is a file of mattes, which they apply to as well
     */
    void checkFormat(PictureOutput output, Path picture, boolean hasMattes) throws IOException, BadInputException {
        boolean isExr = ImageFormat.of(picture).canHaveLayers();
        Optional<String> missing =
                isExr ? Optional.empty() : crop != null ? Optional.of(CROP) : hasMattes ? Optional.empty() : usedOption();
        if (missing.isPresent()) {
            throw new BadInputException(Console.text("%s: %s needs an .exr file", picture, missing.get()));
        }
        if (compression.isDwa() && isExr && output.bits(picture) > Short.SIZE) {
            throw new BadInputException(
                    COMPRESSION + " " + compression.word() + " stores colors of 16 bits; leave out --bits or choose zip");
        }
    }

    /** Checks that the crop is inside a picture, before a long computation. */
    void checkSize(PictureSettings picture) throws BadInputException {
        if (crop != null
                && ((long) crop.x() + crop.width() > picture.width() || (long) crop.y() + crop.height() > picture.height())) {
            throw new BadInputException(
                    Console.text("%s: expected a rectangle inside the picture of %d x %d pixels, found %d,%d,%d,%d", CROP,
                            picture.width(), picture.height(), crop.x(), crop.y(), crop.width(), crop.height()));
        }
    }

    /** Returns the storage of files. */
    ExrLayout layout() {
        return new ExrLayout(compression, parts, Optional.ofNullable(crop)
                .map(c -> new ImageCrop(c.x(), c.y(), c.x() + c.width(), c.y() + c.height())));
    }
}
