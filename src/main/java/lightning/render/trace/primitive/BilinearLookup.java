package lightning.render.trace.primitive;

import lightning.base.Initializer;
import lightning.scene.asset.Texture;
import lightning.scene.asset.TextureMap;
import lightning.scene.asset.TexturePlacement;
import lightning.scene.asset.TextureWrap.Edge;

/**
 * Bilinear texture lookup: the four nearest pixels and their weights. The map says what follows the image's
 * edges; v points up from its bottom row. Reused.
 */
final class BilinearLookup {
    private Texture image;
    /** Column of the left pixels, at least −1, before it is wrapped. */
    private int left;
    /** Row of the upper pixels. */
    private int top;
    private int x0;
    private int x1;
    private int y0;
    private int y1;
    private double fractionX;
    private double fractionY;
    private Edge wrapU;
    private Edge wrapV;
    private int signU;
    private int signV;
    private TexturePlacement placement = TexturePlacement.NONE;
    /** Placement whose cosine and sine are known. */
    private TexturePlacement turned = TexturePlacement.NONE;
    private double cosine = 1;
    private double sine;

    /** Sets texture coordinates, which are multiplied by the map's repeat counts, and then placed. */
    @Initializer
    void setCoordinates(TextureMap map, double u, double v) {
        image = map.image();
        wrapU = map.wrap().u();
        wrapV = map.wrap().v();
        // Negative counts mirror the image at its own place.
        double scaledU = u * map.repeatU() + (wrapU != Edge.REPEAT && map.repeatU() < 0 ? 1 : 0);
        double scaledV = v * map.repeatV() + (wrapV != Edge.REPEAT && map.repeatV() < 0 ? 1 : 0);
        placement = map.placement();
        if (placement != TexturePlacement.NONE) {
            turn(placement);
            double turnedU = cosine * scaledU - sine * scaledV + placement.offsetU();
            scaledV = sine * scaledU + cosine * scaledV + placement.offsetV();
            scaledU = turnedU;
        }
        signU = sign(scaledU, wrapU);
        signV = sign(scaledV, wrapV);
        double column = fold(scaledU, wrapU) * image.width() - 0.5;
        double row = (1 - fold(scaledV, wrapV)) * image.height() - 0.5;
        left = (int) Math.floor(column);
        top = (int) Math.floor(row);
        fractionX = column - left;
        fractionY = row - top;
        x0 = wrap(left, image.width(), wrapU);
        x1 = wrap(left + 1, image.width(), wrapU);
        y0 = wrap(top, image.height(), wrapV);
        y1 = wrap(top + 1, image.height(), wrapV);
    }

    private void turn(TexturePlacement next) {
        if (next != turned) {
            turned = next;
            cosine = next.cosine();
            sine = next.sine();
        }
    }

    /** Returns the place in the image, 0…1, that a surface shows at a coordinate. */
    private static double fold(double s, Edge wrap) {
        return switch (wrap) {
            case REPEAT -> s - Math.floor(s);
            case CLAMP -> Math.clamp(s, 0, 1);
            case MIRROR -> {
                double t = s - 2 * Math.floor(0.5 * s);
                yield t > 1 ? 2 - t : t;
            }
        };
    }

    /** Returns the derivative of {@link #fold}. */
    private static int sign(double s, Edge wrap) {
        return switch (wrap) {
            case REPEAT -> 1;
            case CLAMP -> s >= 0 && s <= 1 ? 1 : 0;
            case MIRROR -> s - 2 * Math.floor(0.5 * s) > 1 ? -1 : 1;
        };
    }

    /** Writes the linear RGB, 0…1, to {@code rgb[0…2]}. */
    void readColor(float[] rgb) {
        image.interpolate(x0, y0, x1, y1, fractionX, fractionY, rgb);
    }

    /** Returns the first channel. */
    float red() {
        return image.interpolate(x0, y0, x1, y1, fractionX, fractionY, 0);
    }

    /** Returns the part of a direction in the image along the surface's u, for one of {@code x} to the right and {@code y} up. */
    double alongU(double x, double y) {
        return placement == TexturePlacement.NONE ? x : cosine * x + sine * y;
    }

    /** Returns the part of a direction in the image along the surface's v, as {@link #alongU}. */
    double alongV(double x, double y) {
        return placement == TexturePlacement.NONE ? y : cosine * y - sine * x;
    }

    /**
     * Returns the derivative of the luminance over the image's width, as central difference between one pixel to the left and
     * one to the right; 0 beside a clamped image.
     */
    double slopeU() {
        return (luminance(1, 0) - luminance(-1, 0)) * 0.5 * image.width() * signU;
    }

    /** Returns the derivative of the luminance over the image's height, upward. */
    double slopeV() {
        return (luminance(0, -1) - luminance(0, 1)) * 0.5 * image.height() * signV;
    }

    private double luminance(int right, int down) {
        return image.luminance(wrap(left + right, image.width(), wrapU), wrap(top + down, image.height(), wrapV),
                wrap(left + 1 + right, image.width(), wrapU), wrap(top + 1 + down, image.height(), wrapV), fractionX, fractionY);
    }

    /** Returns the pixel that an image shows for an index that is at most two pixels outside. */
    private static int wrap(int i, int size, Edge wrap) {
        return i >= 0 && i < size ? i : switch (wrap) {
            case REPEAT -> Math.floorMod(i, size);
            case CLAMP -> i < 0 ? 0 : size - 1;
            case MIRROR -> Math.clamp(i < 0 ? -1 - i : 2 * size - 1 - i, 0, size - 1);
        };
    }
}
