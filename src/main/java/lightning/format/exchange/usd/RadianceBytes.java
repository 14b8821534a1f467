package lightning.format.exchange.usd;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import lightning.base.file.RegularFile;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.asset.EnvironmentMap;

/** Radiance HDR files of environment maps. */
public final class RadianceBytes {
    /** Maximum size of a file, bytes. */
    static final int MAX_BYTES = 64 << 20;

    private RadianceBytes() {}

    /** Returns a Radiance HDR file with the pixels of a map; not its sun. */
    public static byte[] of(EnvironmentMap map) throws IOException {
        float[] rgb = new float[3 * map.width() * map.height()];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = map.channel(i / 3 % map.width(), i / 3 / map.width(), i % 3);
        }
        Path file = Files.createTempFile("lightning-dome", ".hdr");
        try {
            ImageFile.write(file, Film.ofScanlines(map.width(), map.height(), rgb), ViewTransform.DEFAULT);
            return RegularFile.readBytes(file, "an image", MAX_BYTES);
        } finally {
            Files.deleteIfExists(file);
        }
    }
}
