package lightning.format.exchange.assembly;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import lightning.scene.asset.TextureUsage;
import org.junit.jupiter.api.Test;

/** Images with fewer pixels. */
class UsedImageTest {
    /** Four by two pixels: white and black ones on the left, and red ones of different opacity on the right. */
    private static final int[] PIXELS = {0xFFFFFFFF, 0xFF000000, 0xFFFF0000, 0x00FF0000, 0xFF000000, 0xFFFFFFFF, 0x80FF0000, 0x80FF0000};

    private static BufferedImage reduced(TextureUsage usage) throws IOException {
        var image = new BufferedImage(4, 2, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, 4, 2, PIXELS, 0, 4);
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        var used = new UsedImage(8, out::toByteArray);
        used.usages.add(usage);
        return ImageIO.read(new ByteArrayInputStream(used.reduced(2)));
    }

    /** Half of white in linear light is 188 in sRGB. */
    @Test
    void colors_areMeansInLinearLight() throws IOException {
        assertThat(reduced(TextureUsage.COLOR).getRGB(0, 0)).isEqualTo(0xFFBCBCBC);
    }

    @Test
    void numbers_areMeansOfTheirValues() throws IOException {
        assertThat(reduced(TextureUsage.DATA).getRGB(0, 0)).isEqualTo(0xFF808080);
    }

    /** (255 + 0 + 128 + 128) / 4 rounds to 128. */
    @Test
    void opacity_isKept() throws IOException {
        assertThat(reduced(TextureUsage.COLOR).getRGB(1, 0)).isEqualTo(0x80FF0000);
    }
}
