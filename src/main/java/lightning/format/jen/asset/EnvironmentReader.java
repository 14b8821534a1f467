package lightning.format.jen.asset;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import lightning.base.file.UnusableFileException;
import lightning.base.text.Quote;
import lightning.base.work.HeapBudget;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageFormat;
import lightning.format.image.ImageLimits;
import lightning.scene.asset.EnvironmentMap;

/** Reader for environment maps: Radiance HDR and OpenEXR images in linear light. */
public final class EnvironmentReader {
    /** Files of at most 2 GiB, enough for the maximum size, 16384×8192 pixels, of 16 bytes. */
    static final ImageLimits LIMITS =
            new ImageLimits("environment", List.of(ImageFormat.HDR, ImageFormat.EXR), 2L << 30, 1 << 16, 128 << 20);

    private EnvironmentReader() {}

    /**
     * Reads a map.
     *
     * @param name name of the file in messages; its extension says the format
     * @param others memory of the other maps of the scene, bytes
     * @param notes receives a clause if it has values that are not finite
     * @throws UnusableFileException if it is no image in one of the formats, too large, or damaged; the message contains the position
     */
    public static EnvironmentMap read(String name, Path file, long others, Consumer<String> notes)
            throws UnusableFileException {
        EnvironmentMeans means = ImageFile.read(name, file, LIMITS, image -> {
            checkMemory(name, image.width(), image.height(), EnvironmentMeans.bytes(image.width(), image.height()), others);
            var sums = new EnvironmentMeans(image.width(), image.height());
            image.read(sums::add);
            return sums;
        });
        EnvironmentMap map = means.map();
        if (means.infiniteCount() > 0) {
            notes.accept("values of the environment that are not finite: " + means.infiniteCount()
                    + "; those that are no numbers count as 0, others as the largest one possible");
        }
        return map;
    }

    /**
     * Rejects a map that would take more than half of the memory for pictures, with the other maps of the scene.
     *
     * @param bytes  its own memory
     * @param others memory of the other maps, bytes
     */
    static void checkMemory(String name, int width, int height, long bytes, long others) throws UnusableFileException {
        long limit = HeapBudget.availableBytes() / 2;
        if (bytes + others > limit) {
            throw new UnusableFileException(
                    "environment " + Quote.of(name) + " of " + width + "×" + height + " pixels takes " + (bytes >> 20)
                            + " MiB of memory, " + (others == 0 ? "" : "and with the other environments of the scene ")
                            + "more than half of what is available; use a smaller image, or more memory");
        }
    }
}
