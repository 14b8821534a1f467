package lightning.format.jen.asset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.base.text.Quote;
import lightning.format.exr.ExrColorReader;
import lightning.format.exr.ExrReader;
import lightning.format.hdr.HdrReader;
import lightning.format.mesh.MeshException;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.value.SceneLimits;

/** Reader for images of linear values, Radiance HDR and OpenEXR, and for all images that a scene may name. */
public final class LinearTextureReader {
    private static final List<String> ALPHA = List.of("A");

    private LinearTextureReader() {}

    /**
     * Reads an image in linear light, with the limits of textures; values are limited to 0 … {@link SceneLimits#MAX_EMISSION}.
     *
     * @param name name of the file in messages; its extension says the format
     * @throws UnusableFileException if it is too large, damaged or of another format
     */
    public static Texture read(String name, Path path) throws IOException, UnusableFileException {
        return isLinear(name) ? readLinear(name, path, TextureUsage.EMISSION)
                : TextureDecoder.decode(name, TextureDecoder.readFile(name, path), TextureUsage.COLOR);
    }

    /**
     * Reads an image of linear values, limited to 0 … {@link SceneLimits#MAX_EMISSION}.
     *
     * @param name  name of the file in messages
     * @param usage meaning of the samples; an opacity is the alpha channel, if there is one
     * @throws UnusableFileException if it is too large, damaged or of another format
     */
    static Texture readLinear(String name, Path path, TextureUsage usage) throws IOException, UnusableFileException {
        return hasExtension(name, ".hdr") ? readHdr(path) : readExr(name, path, usage);
    }

    /** Returns whether a file of this name has linear values: Radiance HDR or OpenEXR. */
    public static boolean isLinear(String name) {
        return hasExtension(name, ".hdr") || hasExtension(name, ".exr");
    }

    private static boolean hasExtension(String name, String extension) {
        return name.toLowerCase(Locale.ROOT).endsWith(extension);
    }

    private static Texture readHdr(Path path) throws IOException, UnusableFileException {
        try {
            EnvironmentMap image = HdrReader.read(path);
            float[] rgb = new float[3 * image.width() * image.height()];
            for (int i = 0; i < rgb.length; i++) {
                rgb[i] = image.channel(i / 3 % image.width(), i / 3 / image.width(), i % 3);
            }
            return new Texture(image.width(), image.height(), rgb);
        } catch (MeshException e) {
            throw new UnusableFileException(String.valueOf(e.getMessage()));
        }
    }

    private static Texture readExr(String name, Path path, TextureUsage usage) throws IOException, UnusableFileException {
        if (Files.size(path) > JenLimits.TEXTURE_BYTES) {
            throw unusable(name, "must have at most " + JenLimits.TEXTURE_BYTES + " bytes, has " + Files.size(path));
        }
        try (ExrReader reader = new ExrReader(path)) {
            int width = reader.header().width();
            int height = reader.header().height();
            if (width < 1 || height < 1 || (long) width * height > JenLimits.TEXTURE_PIXELS) {
                throw unusable(name, "must have from 1 to " + JenLimits.TEXTURE_PIXELS + " pixels, has " + width + "×" + height);
            }
            float[] rgb = new float[3 * width * height];
            ExrReader.PixelConsumer sink = (x, y, values) -> {
                for (int c = 0; c < 3; c++) {
                    rgb[3 * (y * width + x) + c] = limited(values[c % values.length]);
                }
            };
            if (usage == TextureUsage.OPACITY && reader.header().channels().stream().anyMatch(c -> ALPHA.contains(c.name()))) {
                reader.read(ALPHA, sink);
            } else {
                ExrColorReader.read(reader, sink);
            }
            return new Texture(width, height, rgb);
        } catch (IOException e) {
            throw unusable(name, String.valueOf(e.getMessage()));
        }
    }

    /** Limits a value; not a number becomes 0. */
    static float limited(float value) {
        return value > 0 ? Math.min(value, (float) SceneLimits.MAX_EMISSION) : 0;
    }

    private static UnusableFileException unusable(String name, String reason) {
        return new UnusableFileException("texture " + Quote.of(name) + " " + reason);
    }
}
