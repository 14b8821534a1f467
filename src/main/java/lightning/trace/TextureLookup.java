package lightning.trace;

import lightning.scene.Texture;
import lightning.scene.TextureMap;

/**
 * The colour of a texture at a point of a shape.
 *
 * <p>Texture coordinates, from the point in the shape's own space: a sphere has its longitude and
 * latitude (u = atan2(x, z)/2π + ½, v = asin(y)/π + ½); the sides of cone and cylinder have
 * their longitude and y; caps x + ½·…, that is (x + 1)/2 and (z + 1)/2; a plane x + ½ and z + ½.
 * Both are multiplied by the repeat counts. The four nearest pixels are mixed bilinearly and the
 * picture repeats endlessly; v runs upwards, from the picture's bottom row.
 */
final class TextureLookup {
    private TextureLookup() {}

    /** Writes the linear RGB, 0…1, at a point of a shape of the given kind to {@code rgb[0…2]}. */
    static void sample(TextureMap map, int kind, double x, double y, double z, float[] rgb) {
        double u;
        double v;
        switch (kind) {
            case ShapeTable.SPHERE -> {
                u = longitude(x, z);
                v = StrictMath.asin(y < -1 ? -1 : y > 1 ? 1 : y) / Math.PI + 0.5;
            }
            case ShapeTable.CONE -> {
                boolean side = Surface.onConeSide(x, y, z);
                u = side ? longitude(x, z) : 0.5 * (x + 1);
                v = side ? y : 0.5 * (z + 1);
            }
            case ShapeTable.CYLINDER -> {
                boolean side = Surface.onCylinderSide(x, y, z);
                u = side ? longitude(x, z) : 0.5 * (x + 1);
                v = side ? y : 0.5 * (z + 1);
            }
            default -> {
                u = x + 0.5;
                v = z + 0.5;
            }
        }
        bilinear(map.image(), u * map.repeatU(), v * map.repeatV(), rgb);
    }

    private static double longitude(double x, double z) {
        return StrictMath.atan2(x, z) / (2 * Math.PI) + 0.5;
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
