package lightning.bench.report;

import static java.util.Objects.requireNonNull;

import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.awt.image.IndexColorModel;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;

/**
 * Images embedded once in the page as backgrounds of style sheet classes, however often they are shown. They are compressed lossily; the
 * files next to the report have the exact pixels.
 */
final class EmbeddedPictures {
    private static final float JPEG_QUALITY = 0.92f;
    /** Mask of the bits per channel of false-color images, which limits the number of colors. */
    private static final int COARSE = 0xF8F8F8;

    private final @Nullable Path folder;
    private final Map<String, String> byFile = new HashMap<>();
    private final Map<String, String> byContent = new LinkedHashMap<>();

    /** @param folder base folder of image names */
    EmbeddedPictures(@Nullable Path folder) {
        this.folder = folder;
    }

    /** Returns the class of an image; null if it is missing or unreadable. */
    @Nullable
    String picture(@Nullable String file) {
        return add(file, false);
    }

    /** Returns the class of a false-color image; null if it is missing or unreadable. */
    @Nullable
    String difference(@Nullable String file) {
        return add(file, true);
    }

    private @Nullable String add(@Nullable String file, boolean fewColors) {
        if (file == null) {
            return null;
        }
        return byFile.computeIfAbsent(file, name -> {
            try {
                Film film = ImageFile.read(requireNonNull(folder).resolve(name));
                String encoded = fewColors ? "png;base64," + text(png(film)) : "jpeg;base64," + text(jpeg(film));
                return byContent.computeIfAbsent(encoded, _ -> "p" + byContent.size());
            } catch (IOException | RuntimeException e) {
                // An invalid name or a missing image; the page omits it.
                return null;
            }
        });
    }

    /** Returns the style sheet rules with the images. */
    String styleRules() {
        StringBuilder rules = new StringBuilder();
        byContent.forEach((encoded, name) -> rules.append('.').append(name).append("{background-image:url(data:image/")
                .append(encoded).append(")}\n"));
        return rules.toString();
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
