package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Consumer;
import lightning.base.work.HeapBudget;
import lightning.format.exr.ExrColorReader;
import lightning.format.exr.ExrReader;
import lightning.format.hdr.HdrReader;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.EnvironmentMap;

/** Reader for environment maps: Radiance HDR and OpenEXR images in linear light. */
public final class EnvironmentReader {
    /** Maximum size of a Radiance file in bytes: 640 MiB, more than 16384×8192 pixels of 4 bytes. */
    static final int MAX_HDR_BYTES = 640 << 20;
    /** Maximum size of an OpenEXR file in bytes: 2 GiB, 16384×8192 pixels of 16 bytes. */
    static final long MAX_EXR_BYTES = 2L << 30;
    /** Maximum number of pixels of a file: 128 Mi, 16384×8192. */
    static final long MAX_PIXELS = 128 << 20;

    private EnvironmentReader() {}

    /**
     * Reads a map of a scene that has no other.
     *
     * @param notes receives a clause if it has values that are not finite
     * @throws MeshException as {@link #read(Path, long, Consumer)}
     * @throws IOException if it cannot be read
     */
    public static EnvironmentMap read(Path file, Consumer<String> notes) throws IOException, MeshException {
        return read(file, 0, notes);
    }

    /**
     * Reads a map.
     *
     * @param others memory of the other maps of the scene, bytes
     * @param notes receives a clause if it has values that are not finite
     * @throws MeshException if it is no image in one of the formats, too large, or damaged; the message contains the position
     * @throws IOException if it cannot be read
     */
    public static EnvironmentMap read(Path file, long others, Consumer<String> notes) throws IOException, MeshException {
        EnvironmentMeans means = file.toString().toLowerCase(Locale.ROOT).endsWith(".exr") ? readExr(file, others) : readHdr(file, others);
        EnvironmentMap map = means.map();
        if (means.infiniteCount() > 0) {
            notes.accept("values of the environment that are not finite: " + means.infiniteCount()
                    + "; those that are no numbers count as 0, others as the largest one possible");
        }
        return map;
    }

    private static EnvironmentMeans readHdr(Path file, long others) throws IOException, MeshException {
        HdrReader reader = HdrReader.open(file, MAX_HDR_BYTES, MAX_PIXELS);
        checkMemory(file, reader.width(), reader.height(), EnvironmentMeans.bytes(reader.width(), reader.height()), others);
        var means = new EnvironmentMeans(reader.width(), reader.height());
        reader.read(means::add);
        return means;
    }

    private static EnvironmentMeans readExr(Path file, long others) throws IOException, MeshException {
        if (Files.size(file) > MAX_EXR_BYTES) {
            throw new MeshException(file, "", "an environment must have at most " + MAX_EXR_BYTES + " bytes, has " + Files.size(file));
        }
        try (ExrReader reader = new ExrReader(file)) {
            long pixels = (long) reader.header().width() * reader.header().height();
            if (pixels < 1 || pixels > MAX_PIXELS) {
                throw new MeshException(file, "",
                        "an image must have from 1 to " + MAX_PIXELS + " pixels, has " + reader.header().width() + "×"
                                + reader.header().height());
            }
            checkMemory(file, reader.header().width(), reader.header().height(),
                    EnvironmentMeans.bytes(reader.header().width(), reader.header().height()), others);
            var means = new EnvironmentMeans(reader.header().width(), reader.header().height());
            ExrColorReader.read(reader, means::add);
            return means;
        } catch (IOException e) {
            throw new MeshException(file, "", String.valueOf(e.getMessage()));
        }
    }

    /**
     * Rejects a map that would take more than half of the memory for pictures, with the other maps of the scene.
     *
     * @param bytes  its own memory
     * @param others memory of the other maps, bytes
     */
    static void checkMemory(Path file, int width, int height, long bytes, long others) throws MeshException {
        long limit = HeapBudget.availableBytes() / 2;
        if (bytes + others > limit) {
            throw new MeshException(file, "", "an environment of " + width + "×" + height + " pixels takes " + (bytes >> 20)
                    + " MiB of memory, " + (others == 0 ? "" : "and with the other environments of the scene ")
                    + "more than half of what is available; use a smaller image, or more memory");
        }
    }
}
