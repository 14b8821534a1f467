package lightning.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.math.Vec3;
import lightning.trace.Geometry;
import lightning.trace.HitRows;
import lightning.trace.mesh.MeshProbe;
import lightning.trace.primitive.Crossings;
import lightning.trace.primitive.PrimitiveTable;
import lightning.trace.tree.Beam;
import lightning.trace.tree.BoxRay;
import lightning.trace.tree.Bvh;
import lightning.trace.tree.Candidates;
import lightning.trace.tree.WayEnd;

/** Finds what passes of a light on free ways through clear shapes, way by way. Holds scratch memory: one for each thread. */
final class TintCaster {
    private final PrimitiveTable primitives;
    private final Bvh tree;
    /** The shapes that light passes on any way from the tile. */
    private final Candidates clear = new Candidates();
    private final Candidates all;
    private Candidates asked;
    private final Map<Vec3, WayEnd> ends = new HashMap<>();
    private final BoxRay box = new BoxRay();
    private final MeshProbe probe = new MeshProbe();
    private final Crossings met = new Crossings();
    private final Transmittance transmittance = new Transmittance();

    /** @param geometry in which light passes some shapes */
    TintCaster(Geometry geometry) {
        primitives = geometry.primitives();
        tree = geometry.tinting();
        all = Candidates.all(tree, geometry.tinters());
    }

    /** Turns to the ways of a beam; whether any of them may pass anything. */
    boolean aim(Beam beam) {
        clear.collect(tree, beam);
        // A tree has a primitive that is alone in it twice.
        asked = clear.tooMany || all.count == 1 ? all : clear;
        return !clear.isEmpty();
    }

    /**
     * What passes of the light on a way from a row; valid until the next.
     *
     * @param toX   of the point that it leads to, or of its direction; likewise {@code toY} and {@code toZ}
     * @param leads whether it is a point
     * @return red, green and blue, or null where all passes
     */
    float[] tint(HitRows rows, int i, double toX, double toY, double toZ, boolean leads) {
        double x = rows.px[i];
        double y = rows.py[i];
        double z = rows.pz[i];
        double dx = leads ? toX - x : toX;
        double dy = leads ? toY - y : toY;
        double dz = leads ? toZ - z : toZ;
        double limit = leads ? 1 : Double.POSITIVE_INFINITY;
        WayEnd end = leads ? ends.computeIfAbsent(new Vec3(toX, toY, toZ), point -> WayEnd.at(point, tree)) : WayEnd.OPEN;
        box.enter(x, y, z, dx, dy, dz);
        met.clear();
        for (int c = 0; c < asked.count; c++) {
            if (box.hits(asked.boxes, 6 * c, limit)) {
                int s = asked.primitive[c];
                int index = end.indexOf(s);
                primitives.crossings(s, x, y, z, dx, dy, dz, index >= 0 && end.touches(index, x, y, z), limit, probe, false, met);
            }
        }
        return met.count > 0 && transmittance.of(primitives, met, x, y, z, dx, dy, dz, leads) ? transmittance.rgb : null;
    }

    /** Columns that are 1 where nothing else is known. */
    static float[][] begun(HitRows rows, float[][] before, Columns columns) {
        float[][] tints = new float[3][];
        for (int c = 0; c < 3; c++) {
            tints[c] = columns.floats(rows.count);
            if (before == null) {
                Arrays.fill(tints[c], 0, rows.count, 1);
            } else {
                System.arraycopy(before[c], 0, tints[c], 0, rows.count);
            }
        }
        return tints;
    }

    /** Columns as a layer keeps them: none where all of them are 1. */
    static float[][] kept(HitRows rows, float[][] tints) {
        for (int c = 0; tints != null && c < 3; c++) {
            for (int i = 0; i < rows.count; i++) {
                if (tints[c][i] != 1) {
                    return tints;
                }
            }
        }
        return null;
    }

    /** Whether columns have the same bits, null for 1 everywhere. */
    static boolean areAlike(HitRows rows, float[][] a, float[][] b) {
        if (a == null || b == null) {
            return a == b;
        }
        boolean alike = true;
        for (int c = 0; c < 3; c++) {
            alike &= Arrays.equals(a[c], 0, rows.count, b[c], 0, rows.count);
        }
        return alike;
    }
}
