package lightning.render.shading.explanation;

import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lightning.render.gather.GatherRays;
import lightning.render.shading.RayCounts;
import lightning.render.trace.NormalSteps;
import lightning.render.trace.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * Lighting equation at one point with all its parts.
 *
 * @param hit           the hit; null if the ray hit nothing and shows the background
 * @param passedCutouts primitives through whose cutouts the ray passed, each once; empty if not tested
 * @param normals       steps from the geometric to the shading normal; null if both are equal
 * @param color         the color of the ray with fog, linear, {@code float[3]}
 * @param films         what each film shows with weight 1, in the order of {@link lightning.render.shading.FilmParts}, linear, {@code float[3]} each
 * @param ambient       ka·ambience·(1 − kr), linear, {@code float[3]}
 * @param glow          glow·(1 − kr), linear, {@code float[3]}
 * @param indirect      indirect light in the units of the lights' diffuse sum, linear, {@code float[3]}; null if there is none
 * @param surroundings  blurred reflection: mean light for what the reflectance multiplies, then for what no color multiplies, linear, {@code
 *                      float[6]}; null if the material is not principled or nothing blurs reflections
 * @param lights        one report for each light of the scene, in its order
 * @param refracted     report of the refracted ray; null if the material is opaque, reflects totally, or the depth ends here
 * @param reflected     report of the mirrored ray; null if the material does not mirror or the depth ends here
 * @param fog           fog along the ray; null if there is none
 */
public record PointReport(@Nullable SurfacePoint hit, List<Integer> passedCutouts, @Nullable NormalSteps normals, float[] color,
        float[][] films, float[] ambient, float[] glow, float @Nullable [] indirect, float @Nullable [] surroundings,
        List<LightReport> lights,
        @Nullable PointReport reflected,
        @Nullable PointReport refracted, @Nullable FogReport fog) {

    /** Returns the report of the same point behind fog. @param seen color, and {@code filmsSeen} the films */
    PointReport behind(FogReport air, float[] seen, float[][] filmsSeen) {
        return new PointReport(hit, passedCutouts, normals, seen, filmsSeen, ambient, glow, indirect, surroundings, lights, reflected,
                refracted, air);
    }

    /**
     * Returns the numbers of rays that this report needed, its own included. Gathered light, fog and cutouts have none of their own. A trace
     * casts fewer to area lights, where one shape certainly hides all of a light.
     */
    public RayCounts rays() {
        Map<String, Long> shadows = new TreeMap<>();
        lights.forEach(light -> shadows.merge(light.light().name(), (long) light.rays(), Long::sum));
        RayCounts sum = new RayCounts(1, 0, GatherRays.NONE, shadows);
        for (PointReport bounced : new PointReport[] {reflected, refracted}) {
            if (bounced != null) {
                RayCounts its = bounced.rays();
                sum = sum.plus(new RayCounts(0, its.mirrored() + 1, GatherRays.NONE, its.shadows()));
            }
        }
        return sum;
    }

    /** Returns whether the ray hit nothing. */
    public boolean isBackground() {
        return hit == null;
    }
}
