package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogPath;
import lightning.render.fog.FogRay;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.LightSource;
import org.jspecify.annotations.Nullable;

/**
 * Samples of fog along rays for one light: their places, and the point of the light that each looks at: its position, or one of the
 * samples of an area light, in turn.
 */
final class FogSamples {
    private static final double GOLDEN = 0.6180339887498949;

    private final double scale;
    private final LightSource source;
    /** Source at the point that a sample of a phase looks at: {@code samples × phases}; null for a light without an area. */
    private final LightSource @Nullable [] points;

    /** @param scale distance from the eye to the point that the camera looks at, scene units, &gt; 0 */
    FogSamples(double scale, LightSource source) {
        this.scale = scale;
        this.source = source;
        AreaSamples area = source.centerSamples();
        points = area == null ? null : new LightSource[FogGrid.SAMPLES * FogGrid.PHASES];
        if (area != null && points != null) {
            Arrays.setAll(points, i -> source.at(area, 0, index(i, area.samples())));
        }
    }

    private static int index(int i, int samples) {
        double turn = i * GOLDEN;
        return (int) ((turn - Math.floor(turn)) * samples);
    }

    /** Returns the samples that may be in the cone of the light. */
    ConeRange coneRange() {
        return new ConeRange(source);
    }

    /** Returns whether all samples look at the same point. */
    boolean isPoint() {
        return points == null;
    }

    /** Returns the source at the point that a sample looks at. */
    LightSource source(int sample, int phase) {
        return points == null ? source : points[FogGrid.PHASES * sample + phase];
    }

    /** Aims a path along a ray. */
    void aim(FogPath path, FogRay ray) {
        if (source.type().hasPosition()) {
            Vec3 light = source.position();
            path.aimAtPoint(light.x() - ray.ox, light.y() - ray.oy, light.z() - ray.oz, ray.dx, ray.dy, ray.dz, scale);
        } else {
            path.aimAlong(scale);
        }
    }
}
