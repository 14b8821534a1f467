package lightning.bench.report;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import lightning.bench.result.BenchResults;
import lightning.bench.result.SceneResult;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;

/**
 * Images of a report, each once in the page as a block of data, however often it is shown. They are compressed lossily; the files next to
 * the report have the exact pixels.
 */
final class EmbeddedPictures {
    private static final float JPEG_QUALITY = 0.92f;
    /** Mask of the bits per channel of false-color images, which limits the number of colors. */
    private static final int COARSE = 0xF8F8F8;

    private final Path folder;
    private final Map<String, String> blockOfFile = new LinkedHashMap<>();
    private final Map<String, String> blockOfContent = new LinkedHashMap<>();

    private EmbeddedPictures(Path folder) {
        this.folder = folder;
    }

    /**
     * Reads the images that the report shows: those of the first value of each edit. Missing and unreadable ones are omitted.
     *
     * @param folder base folder of image names
     */
    static EmbeddedPictures of(BenchResults results, Path folder) {
        var pictures = new EmbeddedPictures(folder);
        for (SceneResult scene : results.scenes()) {
            pictures.add(scene.before(), false);
            scene.edits().stream().flatMap(edit -> edit.values().stream().limit(1)).flatMap(value -> value.rungs().stream())
                    .forEach(point -> {
                        pictures.add(point.picture(), false);
                        pictures.add(point.difference(), true);
                    });
        }
        return pictures;
    }

    private void add(@Nullable String file, boolean hasFalseColors) {
        if (file == null || blockOfFile.containsKey(file)) {
            return;
        }
        try {
            Film film = ImageFile.read(folder.resolve(file));
            String content = hasFalseColors ? "png;base64," + text(png(film)) : "jpeg;base64," + text(jpeg(film));
            blockOfFile.put(file, blockOfContent.computeIfAbsent(content, _ -> "picture-" + blockOfContent.size()));
        } catch (IOException | RuntimeException e) {
            // An invalid name or a missing image; the page omits it.
        }
    }

    /** Returns the block of each image file, by the id of its element. */
    Map<String, String> blockOfFile() {
        return blockOfFile;
    }

    /** Returns the blocks as HTML. Base64 has no character with a meaning in HTML. */
    String blocks() {
        var blocks = new StringBuilder();
        blockOfContent.forEach((content, id) -> blocks.append("<script type=\"text/plain\" id=\"").append(id).append("\">data:image/")
                .append(content).append("</script>\n"));
        return blocks.toString();
    }

    private static byte[] jpeg(Film film) throws IOException {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        ImageWriteParam quality = writer.getDefaultWriteParam();
        quality.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        quality.setCompressionQuality(JPEG_QUALITY);
        var out = new ByteArrayOutputStream();
        try (var stream = ImageIO.createImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image(film, 0xFFFFFF, BufferedImage.TYPE_INT_RGB, null), null, null), quality);
        } finally {
            writer.dispose();
        }
        return out.toByteArray();
    }

    private static byte[] png(Film film) throws IOException {
        int[] colors = Arrays.stream(ViewTransform.DEFAULT.toPixels(film)).map(rgb -> rgb & COARSE).distinct().toArray();
        BufferedImage image = colors.length > 256 ? image(film, COARSE, BufferedImage.TYPE_INT_RGB, null)
                : image(film, COARSE, BufferedImage.TYPE_BYTE_INDEXED,
                        new IndexColorModel(8, colors.length, colors, 0, false, -1, DataBuffer.TYPE_BYTE));
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private static BufferedImage image(Film film, int bits, int type, @Nullable IndexColorModel colors) {
        BufferedImage image = colors == null ? new BufferedImage(film.width(), film.height(), type)
                : new BufferedImage(film.width(), film.height(), type, colors);
        int[] pixels = ViewTransform.DEFAULT.toPixels(film);
        Arrays.setAll(pixels, i -> pixels[i] & (0xFF000000 | bits));
        image.setRGB(0, 0, film.width(), film.height(), pixels, 0, film.width());
        return image;
    }

    private static String text(byte[] bytes) {
        return Base64.getEncoder().encodeToString(bytes);
    }
}
