package lightning.format.exchange.assembly;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import javax.imageio.ImageIO;
import lightning.format.jen.asset.TextureDecoder;
import lightning.format.jen.asset.UnusableFileException;

/** Conversion of images that a scene cannot have to PNG. */
final class ConvertedImage {
    private static final Set<String> FORMATS = Set.of("webp", "tga", "bmp", "gif", "tif", "tiff");

    private ConvertedImage() {}

    /**
     * Returns an image as PNG, with fewer pixels if it has more than a texture may have; empty if its format is unknown, or it is damaged,
     * wider than a texture may be, or too large for the memory.
     */
    static Optional<byte[]> png(byte[] file) {
        try {
            return WebpSize.isWebp(file) && !WebpSize.isPlausible(file) ? Optional.empty()
                    : Optional.of(TextureDecoder.read("image", file, FORMATS, in -> encoded(TextureDecoder.readReduced("image", in))));
        } catch (UnusableFileException e) {
            return Optional.empty();
        }
    }

    private static byte[] encoded(BufferedImage image) throws IOException {
        var out = new ByteArrayOutputStream();
        if (!ImageIO.write(image, "png", out)) {
            var plain = new BufferedImage(image.getWidth(), image.getHeight(),
                    image.getColorModel().hasAlpha() ? BufferedImage.TYPE_INT_ARGB : BufferedImage.TYPE_INT_RGB);
            plain.getGraphics().drawImage(image, 0, 0, null);
            ImageIO.write(plain, "png", out);
        }
        return out.toByteArray();
    }
}
