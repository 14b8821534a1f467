package lightning.format.exchange.usd;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import lightning.base.file.RegularFile;
import lightning.format.exchange.assembly.SceneAssembler;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrColorReader;
import lightning.format.exr.ExrReader;
import lightning.format.jen.asset.JenLimits;
import lightning.format.jen.asset.TextureDecoder;
import lightning.format.jen.asset.UnusableFileException;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import lightning.scene.value.SceneLimits;

/** Reader of the images that stages name: PNG, JPEG and OpenEXR. */
final class UsdImages {
    private static final float MAX_VALUE = (float) SceneLimits.MAX_EMISSION;
    private static final int MAX_EXR_PIXELS = 64 << 20;
    private static final List<String> COLORS = List.of("R", "G", "B");

    private UsdImages() {}

    static boolean isExr(Path file) {
        return file.toString().toLowerCase(Locale.ROOT).endsWith(".exr");
    }

    /**
     * Returns the number of pixels.
     *
     * @throws UnusableFileException if the format is not supported, or the file too large or damaged
     */
    static long pixels(Path file) throws IOException, UnusableFileException {
        if (!isExr(file)) {
            return TextureDecoder.pixels(file.toString(), bytes(file));
        }
        try (var exr = new ExrReader(file)) {
            return (long) exr.header().width() * exr.header().height();
        } catch (IOException | RuntimeException e) {
            throw new UnusableFileException(String.valueOf(e.getMessage()));
        }
    }

    /**
     * Decodes an image. Larger ones than textures can be lose rows and columns. Values of OpenEXR can be beyond 0…1.
     *
     * @throws UnusableFileException if the format is not supported, or the file too large or damaged
     */
    static Texture read(Path file, TextureUsage usage) throws IOException, UnusableFileException {
        if (!isExr(file)) {
            return TextureDecoder.decodeReduced(file.toString(), bytes(file), usage);
        }
        try (var exr = new ExrReader(file)) {
            return decoded(exr, usage);
        } catch (IOException | RuntimeException e) {
            throw new UnusableFileException(String.valueOf(e.getMessage()));
        }
    }

    /**
     * Returns whether an image has an alpha channel.
     *
     * @throws UnusableFileException as {@link #read}
     */
    static boolean hasAlpha(Path file) throws IOException, UnusableFileException {
        if (!isExr(file)) {
            return TextureDecoder.hasAlpha(bytes(file));
        }
        try (var exr = new ExrReader(file)) {
            return exr.header().channels().stream().anyMatch(channel -> channel.name().equals("A"));
        } catch (IOException | RuntimeException e) {
            throw new UnusableFileException(String.valueOf(e.getMessage()));
        }
    }

    private static byte[] bytes(Path file) throws IOException, UnusableFileException {
        if (Files.size(file) > JenLimits.TEXTURE_BYTES) {
            throw new UnusableFileException(file + " has more than 64 MiB");
        }
        byte[] bytes = RegularFile.readBytes(file, "an image", JenLimits.TEXTURE_BYTES);
        if (!SceneAssembler.isPngOrJpeg(bytes)) {
            throw new UnusableFileException(file + " is not an image that can be read");
        }
        return bytes;
    }

    private static Texture decoded(ExrReader exr, TextureUsage usage) throws IOException {
        int width = exr.header().width();
        int height = exr.header().height();
        if (width < 1 || height < 1 || (long) width * height > MAX_EXR_PIXELS) {
            throw new IOException("has " + width + "×" + height + " pixels");
        }
        int step = TextureDecoder.step(width, height, JenLimits.TEXTURE_PIXELS);
        int columns = Math.ceilDiv(width, step);
        int rows = Math.ceilDiv(height, step);
        float[] rgb = new float[3 * columns * rows];
        List<String> channels = channels(exr.header().channels().stream().map(ExrChannel::name).toList(), usage);
        ExrReader.PixelConsumer sink = (x, y, values) -> {
            if (x % step == 0 && y % step == 0) {
                for (int c = 0; c < 3; c++) {
                    float v = values[Math.min(c, values.length - 1)];
                    rgb[3 * (y / step * columns + x / step) + c] = Float.isNaN(v) ? 0 : Math.clamp(v, -MAX_VALUE, MAX_VALUE);
                }
            }
        };
        if (channels.equals(COLORS) && (usage == TextureUsage.COLOR || usage == TextureUsage.EMISSION)) {
            ExrColorReader.read(exr, sink);
        } else {
            exr.read(channels, sink);
        }
        return new Texture(columns, rows, rgb);
    }

    private static List<String> channels(List<String> all, TextureUsage usage) {
        if (usage == TextureUsage.OPACITY && all.contains("A")) {
            return List.of("A");
        }
        return all.containsAll(COLORS) ? COLORS : List.of(all.contains("Y") ? "Y" : all.getFirst());
    }
}
