package lightning.render.shading.explanation;

import lightning.base.math.Rgb;
import lightning.render.shading.SurfaceWeights;
import lightning.render.trace.SurfacePoint;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Contributions of each term of the lighting equation to a point's color, for display: their sums are rounded once more.
 *
 * @param at           the point
 * @param reflectivity of its material, {@code float[3]}
 * @param surfaceShare weights of the surface and of what is behind it
 * @param principled   weights of a principled surface; null for others
 */
public record PointContributions(SurfacePoint at, float[] reflectivity, SurfaceWeights surfaceShare,
        @Nullable PrincipledPoint principled) {
    /** Smallest share of a pixel's color for which rays through transparent surfaces are described. */
    private static final double MIN_SHARE = 0.002;

    /** Returns the contributions at a point of a material. */
    public static PointContributions of(Material material, SurfacePoint point) {
        return new PointContributions(point, toFloats(material.reflective()), new SurfaceWeights(point),
                PrincipledPoint.of(material, point));
    }

    /**
     * Returns kd·Idiff·(1 − kr) + (ks·Ispec + Igraz) of one light, linear, {@code float[3]}; scaled by the surface share of
     * a transparent surface, and by the weights of a principled one.
     */
    public float[] ofLight(LightReport light) {
        float[] added = new float[3];
        for (int c = 0; c < 3; c++) {
            if (principled != null) {
                added[c] = principled.color(c, 0, light.diffuse()[c], light.highlight()[c], light.sheen()[c], null, 0);
                continue;
            }
            added[c] = surfaceShare.body(at.diffuse()[c] * light.diffuse()[c], reflectivity[c], c)
                    + (at.specular()[c] * light.highlight()[c] + light.sheen()[c]) * surfaceShare.interiorTint(c);
        }
        return added;
    }

    /** Returns kd·Idiff·(1 − kr) of indirect light, linear, {@code float[3]}; scaled as above. */
    public float[] ofIndirect(float[] light) {
        float[] added = new float[3];
        for (int c = 0; c < 3; c++) {
            added[c] = principled != null ? principled.color(c, 0, light[c], 0, 0, null, 0)
                    : surfaceShare.body(at.diffuse()[c] * light[c], reflectivity[c], c);
        }
        return added;
    }

    /** Returns the blurred reflection's contribution, linear, {@code float[3]}; parameter as in {@link PointReport}. */
    public float[] ofSurroundings(float[] light) {
        float[] added = new float[3];
        for (int c = 0; c < 3 && principled != null; c++) {
            added[c] = principled.color(c, 0, 0, 0, 0, light, 0);
        }
        return added;
    }

    /** Returns the mirrored ray's contribution, kr·Cr for an opaque surface, linear, {@code float[3]}. */
    public float[] reflectedPart(float[] color) {
        if (principled != null) {
            return new float[] {principled.color(0, 0, 0, 0, 0, null, color[0]), principled.color(1, 0, 0, 0, 0, null, color[1]),
                principled.color(2, 0, 0, 0, 0, null, color[2])};
        }
        return new float[] {surfaceShare.mirrored(color[0], reflectivity[0], 0),
            surfaceShare.mirrored(color[1], reflectivity[1], 1),
            surfaceShare.mirrored(color[2], reflectivity[2], 2)};
    }

    /** Returns the refracted ray's contribution, linear, {@code float[3]}. */
    public float[] refractedPart(float[] color) {
        return new float[] {surfaceShare.refracted(color[0], reflectivity[0], 0),
            surfaceShare.refracted(color[1], reflectivity[1], 1),
            surfaceShare.refracted(color[2], reflectivity[2], 2)};
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

    private static float[] toFloats(Rgb c) {
        return new float[] {(float) c.r(), (float) c.g(), (float) c.b()};
    }
}
