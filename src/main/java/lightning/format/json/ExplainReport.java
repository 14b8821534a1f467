package lightning.format.json;

import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Explanation of a pixel. Colors are linear red, green, blue.
 *
 * @param center          the ray through the pixel's center
 * @param rays            rays of the pixel's center
 * @param indirect        indirect light of the whole image; absent without it
 * @param samplesPerPixel rays of which the pixel may be the mean
 * @param colorLinear     the pixel in the film
 * @param displayed       the pixel as displayed, 0 to 255
 */
public record ExplainReport(int x, int y, int widthPixels, int heightPixels, Point center, Rays rays, @Nullable Indirect indirect,
        int samplesPerPixel,
        float[] colorLinear, int[] displayed) {
    /**
     * A point that a ray hits.
     *
     * @param object       absent if the ray shows the background, as all but the color is then
     * @param throughHoles objects through whose cutouts the ray passed
     * @param position     scene units
     * @param normal       shading normal, of length 1
     * @param ambient      what ambient light adds
     * @param indirect     what indirect light adds; absent if there is none
     * @param reflection   what a blurred reflection adds; absent if there is none
     * @param color        sum of all, with fog
     * @param fog          fog before the point; absent if there is none
     */
    public record Point(@Nullable String object, @Nullable String material, List<String> throughHoles, double @Nullable [] position,
            double @Nullable [] normal, @Nullable Normals normals,
            float @Nullable [] ambient, float @Nullable [] glow, @Nullable List<LightShare> lights, float @Nullable [] indirect,
            float @Nullable [] reflection,
            @Nullable Ray reflected, @Nullable Ray refracted, float[] color, @Nullable Fog fog) {}

    /**
     * Fog along a ray.
     *
     * @param transmittance share of the surface's light that passes
     * @param adds          what the fog adds
     */
    public record Fog(float transmittance, float[] adds) {}

    /**
     * Steps of a changed normal.
     *
     * @param interpolated of a mesh's vertices; absent without them
     * @param bumped       after bump and normal maps; absent without them
     * @param bent         true if it was bent toward the viewer
     */
    public record Normals(double[] geometric, double @Nullable [] interpolated, double @Nullable [] bumped, boolean bent) {}

    /**
     * One light at a point.
     *
     * @param state          dark, away, outside, unlinked, shadowed or lit
     * @param shadowedBy     nearest object between point and light; absent if there is none
     * @param visibleSamples of {@code samples}; both are 1 for a light without a size
     * @param cosine         for a light with several samples, times the falloff, as is {@code specular}
     * @param face           mean color of its texture as the point sees it; 1 without one
     * @param adds           its part of the point's color
     * @param sharePercent   of the point's color; null if the point is black
     */
    public record LightShare(String light, String state, @Nullable String shadowedBy, int visibleSamples, int samples, float cosine,
            float specular, float falloff, float[] tint, float[] face, float[] adds, double sharePercent) {}

    /**
     * A reflected or refracted ray.
     *
     * @param adds its part of the color of the point that it starts from
     * @param hits absent if the ray starts from a transparent surface and contributes less than 0.2 % of the pixel
     */
    public record Ray(float[] adds, @Nullable Point hits) {}

    /**
     * Numbers of rays.
     *
     * @param bounce mirrored and refracted ones
     * @param shadow all shadow rays
     * @param lights those of each light by its name
     */
    public record Rays(long eye, long bounce, long shadow, Map<String, Long> lights) {}

    /** Paths of indirect light of the whole image. */
    public record Indirect(long gatherPoints, long surfels, long rays, long bytes) {}
}
