package lightning.format.exchange.assembly;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.EnumSet;
import java.util.Set;
import javax.imageio.ImageIO;
import lightning.base.math.SrgbCurve;
import lightning.format.image.ImageFile;
import lightning.format.image.ImageSource;
import lightning.format.jen.asset.TextureFile;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;
import org.jspecify.annotations.Nullable;

/** PNG or JPEG image of an imported scene, with its usages. */
final class UsedImage {
    private static final int MAX_CODE = 255;

    /** Number of pixels. */
    final long pixels;
    final Set<TextureUsage> usages = EnumSet.noneOf(TextureUsage.class);
    private final Content content;

    /** Content of an image file. */
    @FunctionalInterface
    interface Content {
        byte[] read() throws IOException;
    }

    UsedImage(long pixels, Content content) {
        this.pixels = pixels;
        this.content = content;
    }

    /** Returns the number of textures that a scene decodes from it. */
    int usageCount() {
        return usages.size();
    }

    /**
     * Returns it as a PNG file with fewer pixels, each the mean of some: of colors in linear light, of data and opacity as they are.
     *
     * @param maxPixels maximum number of pixels
     */
    byte[] reduced(long maxPixels) throws IOException {
        boolean isColor = !usages.contains(TextureUsage.DATA);
        return ImageFile.read("image", content.read(), TextureFile.REDUCIBLE, image -> {
            Texture colors = TextureFile.reduced(image, isColor ? TextureUsage.COLOR : TextureUsage.DATA);
            return png(colors, image.hasAlpha() ? TextureFile.reduced(image, TextureUsage.OPACITY) : null, isColor, maxPixels);
        });
    }

    private static byte[] png(Texture colors, @Nullable Texture opacity, boolean isColor, long maxPixels) throws IOException {
        int step = ImageSource.step(colors.width(), colors.height(), maxPixels);
        int width = Math.ceilDiv(colors.width(), step);
        int height = Math.ceilDiv(colors.height(), step);
        int bands = opacity == null ? 3 : 4;
        var model = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), opacity != null, false,
                opacity == null ? Transparency.OPAQUE : Transparency.TRANSLUCENT, DataBuffer.TYPE_BYTE);
        WritableRaster raster = model.createCompatibleWritableRaster(width, height);
        int[] row = new int[bands * width];
        for (int y = 0; y < height; y++) {
            int y1 = Math.min((y + 1) * step, colors.height());
            for (int x = 0; x < width; x++) {
                int x1 = Math.min((x + 1) * step, colors.width());
                for (int c = 0; c < 3; c++) {
                    double mean = TextureMeans.mean(colors, x * step, x1, y * step, y1, c);
                    row[bands * x + c] = code(isColor ? SrgbCurve.fromLinear(mean) : mean);
                }
                if (opacity != null) {
                    row[bands * x + 3] = code(TextureMeans.mean(opacity, x * step, x1, y * step, y1, 0));
                }
            }
            raster.setPixels(0, y, width, 1, row);
        }
        var out = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(model, raster, false, null), "png", out);
        return out.toByteArray();
    }

    private static int code(double v) {
        return (int) Math.rint(MAX_CODE * Math.clamp(v, 0, 1));
    }
}
