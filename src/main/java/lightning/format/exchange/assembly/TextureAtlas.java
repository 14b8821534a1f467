package lightning.format.exchange.assembly;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;
import lightning.base.math.SrgbCurve;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureUsage;

/**
 * Image of equal tiles, written as PNG. Each pixel of a tile is the mean of its pixels in the tile's image, in linear light, and the
 * image's own pixel if their sizes are equal.
 */
public final class TextureAtlas {
    private static final int BYTE = 8;
    private static final int SHORT = 16;

    private final int tileWidth;
    private final int tileHeight;
    private final boolean isColor;
    private final double max;
    private final WritableRaster raster;
    private final BufferedImage image;
    private boolean isClamped;

    /** @param isDeep 16 bits for each channel, else 8 */
    public TextureAtlas(int columns, int rows, int tileWidth, int tileHeight, TextureUsage usage, boolean isDeep) {
        this.tileWidth = tileWidth;
        this.tileHeight = tileHeight;
        isColor = usage == TextureUsage.COLOR;
        int bits = isDeep ? SHORT : BYTE;
        max = (1 << bits) - 1;
        var model = new ComponentColorModel(ColorSpace.getInstance(ColorSpace.CS_sRGB), new int[] {bits, bits, bits}, false, false,
                Transparency.OPAQUE, isDeep ? DataBuffer.TYPE_USHORT : DataBuffer.TYPE_BYTE);
        raster = model.createCompatibleWritableRaster(columns * tileWidth, rows * tileHeight);
        image = new BufferedImage(model, raster, false, null);
    }

    /** Draws a tile; rows count from the top. */
    public void draw(Texture tile, int column, int row) {
        int[] line = new int[3 * tileWidth];
        for (int y = 0; y < tileHeight; y++) {
            int y0 = (int) ((long) y * tile.height() / tileHeight);
            int y1 = Math.max(y0 + 1, (int) ((long) (y + 1) * tile.height() / tileHeight));
            for (int x = 0; x < tileWidth; x++) {
                int x0 = (int) ((long) x * tile.width() / tileWidth);
                int x1 = Math.max(x0 + 1, (int) ((long) (x + 1) * tile.width() / tileWidth));
                for (int c = 0; c < 3; c++) {
                    line[3 * x + c] = code(TextureMeans.mean(tile, x0, x1, y0, y1, c));
                }
            }
            raster.setPixels(column * tileWidth, row * tileHeight + y, tileWidth, 1, line);
        }
    }

    /** Returns the code of a linear value: sRGB for colors. */
    private int code(double v) {
        isClamped |= v > 1;
        double s = isColor ? SrgbCurve.fromLinear(v) : v;
        return (int) Math.rint(Math.clamp(s, 0, 1) * max);
    }

    /** Returns whether values above 1 were drawn as 1. */
    public boolean isClamped() {
        return isClamped;
    }

    /** Returns the file. */
    public byte[] png() throws IOException {
        var out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }
}
