package lightning.render.shading.fog;

import lightning.render.fog.BounceRays;
import lightning.render.trace.BounceKind;
import lightning.render.trace.HitRows;
import lightning.render.trace.SamplePositions;
import org.jspecify.annotations.Nullable;

/**
 * Rows from which rays bounce that show light in fog, by their places in the image: rows of the first level, and of levels that are seen from it through
 * refractions alone.
 *
 * @param x           image coordinates of each row, pixels, as {@code y}
 * @param refractions number of refractions before these rows
 */
public record BounceStart(double[] x, double[] y, int refractions) {
    // Arrays in a record: written once by their creator, never after.

    /** Returns the first level's rows. */
    static BounceStart of(SamplePositions positions, HitRows rows) {
        double[] x = new double[positions.count()];
        double[] y = new double[positions.count()];
        positions.writePositions(0, positions.count(), x, y);
        return new BounceStart(x, y, 0).select(rows, rows.reflectiveCount);
    }

    private BounceStart select(HitRows rows, int count) {
        double[] toX = new double[count];
        double[] toY = new double[count];
        for (int i = 0; i < count; i++) {
            toX[i] = x[rows.parent[i]];
            toY[i] = y[rows.parent[i]];
        }
        return new BounceStart(toX, toY, refractions);
    }

    /** Returns the rows that are seen from these by one kind of bounce; null if no light in fog is seen from there. */
    public @Nullable BounceStart below(BounceKind bounce, HitRows rows) {
        if (bounce == BounceKind.MIRRORED) {
            return null;
        }
        BounceStart selected = select(rows, rows.clearCount);
        return new BounceStart(selected.x, selected.y, refractions + 1);
    }

    /** Returns the path of the rays that bounce from these rows, as in {@link BounceRays}; negative if they show no light in fog. */
    int path(BounceKind bounce) {
        return switch (bounce) {
            case MIRRORED -> refractions == 0 ? BounceRays.MIRRORED : -1;
            case REFRACTED -> refractions + 1;
        };
    }
}
