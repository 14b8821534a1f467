package lightning.render.trace.primitive;

import lightning.base.Initializer;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;

/**
 * Bilinear texture lookup: the four nearest pixels and their weights. The image repeats endlessly unless the map
 * is clamped; v points up from its bottom row. Reused.
 */
final class BilinearLookup {
    private Texture image;
    private int x0;
    private int x1;
    private int y0;
    private int y1;
    private double fractionX;
    private double fractionY;

    /** Sets texture coordinates, which are multiplied by the map's repeat counts. */
    @Initializer
    void setCoordinates(TextureMap map, double u, double v) {
        image = map.image();
        double scaledU = u * map.repeatU();
        double scaledV = v * map.repeatV();
        double column = (scaledU - Math.floor(scaledU)) * image.width() - 0.5;
        double row = (1 - (scaledV - Math.floor(scaledV))) * image.height() - 0.5;
        double left = Math.floor(column);
        double top = Math.floor(row);
        fractionX = column - left;
        fractionY = row - top;
        x0 = wrap((int) left, image.width());
        x1 = wrap((int) left + 1, image.width());
        y0 = wrap((int) top, image.height());
        y1 = wrap((int) top + 1, image.height());
        if (map.isClamped()) {
            clamp(column, row);
        }
    }

    /** Replaces pixels of the opposite edge by those of the near one. */
    private void clamp(double column, double row) {
        x0 = column < 0 ? 0 : x0;
        x1 = column > image.width() - 1 ? image.width() - 1 : x1;
        y0 = row < 0 ? 0 : y0;
        y1 = row > image.height() - 1 ? image.height() - 1 : y1;
    }

    /** Writes the linear RGB, 0…1, to {@code rgb[0…2]}. */
    void readColor(float[] rgb) {
        image.interpolate(x0, y0, x1, y1, fractionX, fractionY, rgb);
    }

    /** Returns the first channel. */
    float red() {
        return image.interpolate(x0, y0, x1, y1, fractionX, fractionY, 0);
    }

    /**
     * Returns the derivative of the luminance over the image's width, as central difference between one pixel to the left and
     * one to the right.
     */
    double slopeU() {
        return (luminance(1, 0) - luminance(-1, 0)) * 0.5 * image.width();
    }

    /** Returns the derivative of the luminance over the image's height, upward. */
    double slopeV() {
        return (luminance(0, -1) - luminance(0, 1)) * 0.5 * image.height();
    }

    private double luminance(int right, int down) {
        return image.luminance(wrap(x0 + right, image.width()), wrap(y0 + down, image.height()), wrap(x1 + right, image.width()),
                wrap(y1 + down, image.height()), fractionX, fractionY);
    }

    private static int wrap(int i, int size) {
        return i < 0 ? i + size : i >= size ? i - size : i;
    }
}
