package lightning.trace.primitive;

import lightning.scene.Texture;
import lightning.scene.TextureMap;

/**
 * The colour of a texture at a place.
 *
 * <p>Texture coordinates are multiplied by the repeat counts. The four nearest pixels are mixed bilinearly and the
 * picture repeats endlessly; v runs upwards, from the picture's bottom row.
 */
final class TextureLookup {
    private TextureLookup() {}

    /** Writes the linear RGB, 0…1, at texture coordinates, before they are repeated, to {@code rgb[0…2]}. */
    static void sample(TextureMap map, double u, double v, float[] rgb) {
        bilinear(map.image(), u * map.repeatU(), v * map.repeatV(), rgb);
    }

    private static void bilinear(Texture image, double u, double v, float[] rgb) {
        int width = image.width();
        int height = image.height();
        double column = (u - Math.floor(u)) * width - 0.5;
        double row = (1 - (v - Math.floor(v))) * height - 0.5;
        double left = Math.floor(column);
        double top = Math.floor(row);
        double across = column - left;
        double along = row - top;
        int x0 = wrap((int) left, width);
        int x1 = wrap((int) left + 1, width);
        int y0 = wrap((int) top, height);
        int y1 = wrap((int) top + 1, height);
        image.mix(x0, y0, x1, y1, across, along, rgb);
    }

    private static int wrap(int i, int size) {
        return i < 0 ? i + size : i >= size ? i - size : i;
    }
}
