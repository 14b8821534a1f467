package lightning.format.exchange.assembly;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Iterator;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;
import lightning.format.jen.asset.JenLimits;

/** Conversion of images that a scene cannot have to PNG. */
final class ConvertedImage {
    private static final Set<String> FORMATS = Set.of("webp", "tga", "bmp", "gif", "tif", "tiff");

    private ConvertedImage() {}

    /**
     * Returns an image as PNG, with fewer pixels if it has more than a texture may have; empty if its format is unknown, or it is damaged or
     * wider than a texture may be.
     */
    static Optional<byte[]> png(byte[] file) {
        try (ImageInputStream in = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            Iterator<ImageReader> readers = ImageIO.getImageReaders(in);
            while (readers.hasNext()) {
                ImageReader reader = readers.next();
                try {
                    if (FORMATS.contains(reader.getFormatName().toLowerCase(Locale.ROOT))) {
                        reader.setInput(in, true, true);
                        return read(reader).map(ConvertedImage::encoded);
                    }
                } finally {
                    reader.dispose();
                }
            }
        } catch (IOException | RuntimeException e) {
            // The decoders throw arbitrary runtime exceptions for some damaged files.
            return Optional.empty();
        }
        return Optional.empty();
    }

    private static Optional<BufferedImage> read(ImageReader reader) throws IOException {
        int width = reader.getWidth(0);
        int height = reader.getHeight(0);
        if (width < 1 || height < 1 || width > JenLimits.TEXTURE_SIDE || height > JenLimits.TEXTURE_SIDE) {
            return Optional.empty();
        }
        int step = 1;
        while ((long) Math.ceilDiv(width, step) * Math.ceilDiv(height, step) > JenLimits.TEXTURE_PIXELS) {
            step++;
        }
        ImageReadParam reduction = reader.getDefaultReadParam();
        reduction.setSourceSubsampling(step, step, 0, 0);
        return Optional.of(reader.read(0, reduction));
    }

    private static byte[] encoded(BufferedImage image) {
        try {
            var out = new ByteArrayOutputStream();
            if (!ImageIO.write(image, "png", out)) {
                var plain = new BufferedImage(image.getWidth(), image.getHeight(),
                        image.getColorModel().hasAlpha() ? BufferedImage.TYPE_INT_ARGB : BufferedImage.TYPE_INT_RGB);
                plain.getGraphics().drawImage(image, 0, 0, null);
                ImageIO.write(plain, "png", out);
            }
            return out.toByteArray();
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
    }
}
