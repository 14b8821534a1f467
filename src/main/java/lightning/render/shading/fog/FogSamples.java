package lightning.render.shading.fog;

import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogPath;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.LightSource;
import org.jspecify.annotations.Nullable;

/**
 * Samples of the fog of a picture for one light: their places, and the point of the light that each looks at: its position, or one of the
 * samples of an area light, in turn.
 */
final class FogSamples {
    private static final double GOLDEN = 0.6180339887498949;

    private final FogGrid grid;
    private final LightSource source;
    private final Vec3 fromEye;
    /** Source at the point that a sample of a phase looks at: {@code samples × phases}; null for a light without an area. */
    private final LightSource @Nullable [] points;

    FogSamples(FogGrid grid, LightSource source) {
        this.grid = grid;
        this.source = source;
        fromEye = source.type().hasPosition() ? source.position().minus(grid.eye()) : source.position();
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
        return new ConeRange(source, grid.eye(), fromEye);
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
    void aim(FogPath path, double dx, double dy, double dz) {
        if (source.type().hasPosition()) {
            path.aimAtPoint(fromEye, dx, dy, dz, grid.scale());
        } else {
            path.aimAlong(grid.scale());
        }
    }
}
