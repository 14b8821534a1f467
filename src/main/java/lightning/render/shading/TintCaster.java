package lightning.render.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;
import lightning.render.trace.Tracer;
import lightning.render.trace.Ways;
import lightning.render.trace.primitive.Crossings;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.tree.Beam;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.Candidates;
import lightning.render.trace.tree.WayEnd;

/** Finds what passes of a light on free ways through clear shapes. Holds scratch memory: one for each thread. */
final class TintCaster {
    private static final WayEnd[] OPEN = {};

    private final Tracer tracer;
    private final PrimitiveTable primitives;
    private final Bvh tree;
    /** The shapes that light passes on any way from the tile. */
    private final Candidates clear = new Candidates();
    private final Candidates all;
    private Candidates asked;
    private final Map<Vec3, WayEnd> ends = new HashMap<>();
    private final Map<LampArea, WayEnd[]> areaEnds = new HashMap<>();
    private final RowWays ways = new RowWays();
    private final Crossings met = new Crossings(Terms.ROWS);
    private final Transmittance transmittance = new Transmittance();

    /** @param geometry in which light passes some shapes */
    TintCaster(Geometry geometry, Tracer tracer) {
        this.tracer = tracer;
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

    /** Asks chosen rows for what ways to one place, or in one direction, pass. */
    void ask(HitRows rows, int[] chosen, Ways way) {
        Vec3 source = way.source();
        int end = RowBits.words(rows.count) * RowBits.WIDTH;
        Arrays.fill(ways.x, 0, end, source.x());
        Arrays.fill(ways.y, 0, end, source.y());
        Arrays.fill(ways.z, 0, end, source.z());
        Arrays.fill(ways.turn, 0, end, 0);
        ways.ends = way.ends();
        WayEnd at = way.ends() ? ends.computeIfAbsent(source, point -> WayEnd.at(point, tree)) : WayEnd.OPEN;
        ways.open = at.isOpen();
        Arrays.fill(ways.end, 0, end, at);
        cross(rows, chosen);
    }

    /** The same for ways to sample {@code s} of an area. */
    void ask(HitRows rows, int[] chosen, RowWays way, LampArea area, int s) {
        int end = RowBits.words(rows.count) * RowBits.WIDTH;
        System.arraycopy(way.x, 0, ways.x, 0, end);
        System.arraycopy(way.y, 0, ways.y, 0, end);
        System.arraycopy(way.z, 0, ways.z, 0, end);
        System.arraycopy(way.turn, 0, ways.turn, 0, end);
        ways.ends = way.ends;
        WayEnd[] places = way.ends ? areaEnds.computeIfAbsent(area, this::ends) : OPEN;
        ways.open = places == OPEN;
        for (int i = 0; !ways.open && i < rows.count; i++) {
            ways.end[i] = places[LampArea.place(s, way.turn[i])];
        }
        cross(rows, chosen);
    }

    /** Where ways to the places of an area end; {@link #OPEN} where none of them lies on anything that light passes. */
    private WayEnd[] ends(LampArea area) {
        WayEnd[] all = new WayEnd[area.x.length];
        Arrays.setAll(all, i -> WayEnd.at(new Vec3(area.x[i], area.y[i], area.z[i]), tree));
        return Arrays.stream(all).allMatch(WayEnd::isOpen) ? OPEN : all;
    }

    private void cross(HitRows rows, int[] chosen) {
        met.clear();
        tracer.cross(rows, chosen, ways, asked, met);
    }

    /**
     * What passes of the light on the way from a row that was asked; valid until the next.
     *
     * @return red, green and blue, or null where all passes
     */
    float[] tint(HitRows rows, int i) {
        if (met.first(i) == Crossings.NONE) {
            return null;
        }
        double x = rows.px[i];
        double y = rows.py[i];
        double z = rows.pz[i];
        boolean leads = ways.ends;
        double dx = leads ? ways.x[i] - x : ways.x[i];
        double dy = leads ? ways.y[i] - y : ways.y[i];
        double dz = leads ? ways.z[i] - z : ways.z[i];
        return transmittance.of(primitives, met, i, x, y, z, dx, dy, dz, leads) ? transmittance.rgb : null;
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
