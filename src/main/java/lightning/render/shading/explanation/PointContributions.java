package lightning.render.shading.explanation;

import lightning.render.shading.SurfaceFactors;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;

/**
 * Contributions of each term of the lighting equation to a point's color, for display: their sums are rounded once more.
 *
 * @param at      the point
 * @param factors by which it sends light on
 */
public record PointContributions(SurfacePoint at, SurfaceFactors factors) {
    /** Smallest share of a pixel's color for which rays through transparent surfaces are described. */
    private static final double MIN_SHARE = 0.002;

    /** Returns the contributions at a point of a material. */
    public static PointContributions of(Material material, SurfacePoint point) {
        return new PointContributions(point, new SurfaceFactors(point, material));
    }

    /** Returns D·Idiff + (S·Ispec + G·Igraz) of one light, linear, {@code float[3]}; see {@link SurfaceFactors}. */
    public float[] ofLight(LightReport light) {
        return channels(c -> factors.lit(c, light.diffuse()[c], light.highlight()[c], light.sheen()[c]));
    }

    /** Returns D·Idiff of indirect light, linear, {@code float[3]}. */
    public float[] ofIndirect(float[] light) {
        return channels(c -> factors.lit(c, light[c], 0, 0));
    }

    /** Returns the blurred reflection's contribution, linear, {@code float[3]}; parameter as in {@link PointReport}. */
    public float[] ofSurroundings(float[] light) {
        return channels(c -> factors.reflected(c, light[c], light[3 + c]));
    }

    /** Returns the mirrored ray's contribution, kr·Cr for an opaque surface, linear, {@code float[3]}. */
    public float[] reflectedPart(float[] color) {
        return channels(c -> factors.mirrored(c, color[c]));
    }

    /** Returns the refracted ray's contribution, linear, {@code float[3]}. */
    public float[] refractedPart(float[] color) {
        return channels(c -> factors.refracted(c, color[c]));
    }

    private interface Channel {
        float of(int c);
    }

    private static float[] channels(Channel channel) {
        return new float[] {channel.of(0), channel.of(1), channel.of(2)};
    }

    /**
     * Returns whether a description should follow a ray from the point: transparent surfaces split rays in two, recursively, hundreds for
     * a pixel.
     *
     * @param part       the ray's part of the point's color
     * @param color      the point's color
     * @param pointShare approximate share of the pixel's color that the point contributes
     */
    public boolean shouldFollow(float[] part, float[] color, double pointShare) {
        return at.backSide() == null || pointShare * sum(part) >= MIN_SHARE * sum(color);
    }

    /** Returns the approximate share of the pixel's color that a ray from the point contributes; parameters as above. */
    public static double rayShare(float[] part, float[] color, double pointShare) {
        return pointShare * sum(part) / Math.max(sum(color), Float.MIN_NORMAL);
    }

    /** Returns red + green + blue. */
    public static double sum(float[] color) {
        return (double) color[0] + color[1] + color[2];
    }
}
