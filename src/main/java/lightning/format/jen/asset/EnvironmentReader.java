package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import lightning.format.exr.ExrColorReader;
import lightning.format.exr.ExrReader;
import lightning.format.hdr.HdrReader;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.EnvironmentMap;

/** Reader for environment maps: Radiance HDR and OpenEXR images in linear light. */
final class EnvironmentReader {
    /** Maximum size of a file in bytes: 256 MiB, enough for 8192×4096 pixels. */
    static final int MAX_BYTES = 256 << 20;
    /** Maximum number of pixels of a file: 128 Mi. A map has fewer, see {@link EnvironmentMeans}. */
    static final long MAX_PIXELS = 128 << 20;

    private EnvironmentReader() {}

    /**
     * Reads a map. A large image is reduced.
     *
     * @param notes receives a clause if it is reduced, or has values that are not finite
     * @throws MeshException if it is no image in one of the formats, too large, or damaged; the message contains the position
     * @throws IOException if it cannot be read
     */
    static EnvironmentMap read(Path file, Consumer<String> notes) throws IOException, MeshException {
        EnvironmentMeans means = file.toString().toLowerCase(Locale.ROOT).endsWith(".exr") ? readExr(file) : readHdr(file);
        EnvironmentMap map = means.map();
        List<String> changes = new ArrayList<>();
        if (means.isReduced()) {
            changes.add(
                    "the environment has more than " + HdrReader.MAX_PIXELS + " pixels; reduced to " + map.width() + "×" + map.height());
        }
        if (means.infiniteCount() > 0) {
            changes.add("values of the environment that are not finite: " + means.infiniteCount()
                    + "; those that are no numbers count as 0, others as the largest one possible");
        }
        if (!changes.isEmpty()) {
            notes.accept(String.join("; ", changes));
        }
        return map;
    }

    private static EnvironmentMeans readHdr(Path file) throws IOException, MeshException {
        HdrReader reader = HdrReader.open(file, MAX_BYTES, MAX_PIXELS);
        var means = new EnvironmentMeans(reader.width(), reader.height());
        reader.read(means::add);
        return means;
    }

    private static EnvironmentMeans readExr(Path file) throws IOException, MeshException {
        if (Files.size(file) > MAX_BYTES) {
            throw new MeshException(file, "", "an environment must have at most " + MAX_BYTES + " bytes, has " + Files.size(file));
        }
        try (ExrReader reader = new ExrReader(file)) {
            long pixels = (long) reader.header().width() * reader.header().height();
            if (pixels < 1 || pixels > MAX_PIXELS) {
                throw new MeshException(file, "",
                        "an image must have from 1 to " + MAX_PIXELS + " pixels, has " + reader.header().width() + "×"
                                + reader.header().height());
            }
            var means = new EnvironmentMeans(reader.header().width(), reader.header().height());
            ExrColorReader.read(reader, means::add);
            return means;
        } catch (IOException e) {
            throw new MeshException(file, "", String.valueOf(e.getMessage()));
        }
    }
}
