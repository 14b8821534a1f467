package lightning.render.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntPredicate;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowWays;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.Tracer;
import lightning.render.trace.Ways;
import lightning.render.trace.tree.Beam;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.BoxSet;
import lightning.render.trace.tree.Candidates;
import lightning.render.trace.tree.Departure;
import lightning.render.trace.tree.PointBox;
import lightning.render.trace.tree.Umbra;
import lightning.render.trace.tree.WayEnd;
import lightning.scene.effects.Effect;
import lightning.scene.effects.ViewEffects;

/** Asks for chosen rows whether the way to a light is free. Holds scratch memory: one for each thread. */
final class ShadowCaster {
    /** Words of rows that are looked at together: two lines of a tile. */
    private static final int TOGETHER = 4;
    /** With more shapes in question, looking at neighbours takes longer than the rays that it saves. */
    private static final int WORTH_IT = 6;

    private final Geometry geometry;
    private final Tracer tracer;
    private final Demands demands;
    private final Beam beam = new Beam();
    private final BoxRay ray = new BoxRay();
    private final Departure departure = new Departure();
    private final Umbra umbra = new Umbra();
    /** What may stand between the tile and the light. */
    private final Candidates blockers = new Candidates();
    /** What may stand between some rows of it and the light. */
    private final Candidates few = new Candidates();
    private final int[] unproved = RowBits.room();
    /** The least and the greatest coordinates of the points where ways end, or of their directions. */
    private Vec3 low = Vec3.ZERO;
    private Vec3 high = Vec3.ZERO;
    private boolean toPoints;
    /** Where the ways that were swept last begin. */
    private PointBox origins;
    /** Whether any of the points lies on a primitive. */
    private IntPredicate isUnderEnd = s -> false;
    /** Where the ways to lights lead that rays were cast to. */
    private final Map<Vec3, Ways> ways = new HashMap<>();
    /** Where the ways to the samples of areas end, by their place in the area. */
    private final Map<LampArea, WayEnd[]> ends = new HashMap<>();
    private WayEnd[] area;
    /** The rows of which ways to the area may be blocked and others free, and those of which all are blocked. */
    private final int[] doubtful = RowBits.room();
    private final int[] dark = RowBits.room();
    private final int[] asked = RowBits.room();
    private final boolean casts;
    /** Null where light passes no shape. */
    private final TintCaster tints;
    /** Whether ways to the area that it was turned to may pass clear shapes. */
    private boolean tinted;
    private long rays;

    /** @param view whether any shape blocks a light, else all ways are free */
    ShadowCaster(Geometry geometry, Tracer tracer, ViewEffects view) {
        casts = view.shows(Effect.SHADOWS);
        demands = Demands.of(view);
        this.geometry = geometry;
        this.tracer = tracer;
        tints = casts && geometry.tinting() != null ? new TintCaster(geometry, tracer) : null;
    }

    /** Rows asked since the start: each a ray, but where it is certain beforehand that nothing is in the way. */
    long rays() {
        return rays;
    }

    /**
     * Casts a ray from each chosen row.
     *
     * @param chosen  rows to ask, as {@link RowBits}
     * @param blocked gets those of them from which the light is not seen
     */
    void cast(HitRows rows, Lamp lamp, int[] chosen, int[] blocked) {
        if (!casts || !geometry.throwsShadows()) {
            Arrays.fill(blocked, 0);
            return;
        }
        int count = RowBits.count(chosen, rows.count);
        rays += count;
        if (count == 0) {
            Arrays.fill(blocked, 0);
            return;
        }
        Ways way = aim(rows, lamp);
        if (demands.meets(blockers)) {
            tracer.blocked(rows, unproved(rows, chosen), way, blockers, blocked);
        } else {
            Arrays.fill(blocked, 0);
        }
    }

    /**
     * Chooses rows whose way to a light other shapes may block or free.
     *
     * <p>What blocks a row that no way of which meets anything that is gone, is still there; and where a way was free, only what
     * came can block it. {@link ShapeChange#keepsEnd} must hold for a light at a point.
     *
     * @param state  whether the rows' ways are blocked, as {@link LightRows} has it; those that nobody asked are not chosen
     * @param chosen gets the rows, as {@link RowBits}
     * @return whether there are any
     */
    boolean choose(HitRows rows, Lamp lamp, byte[] state, ShapeChange change, int[] chosen) {
        if (rows.count == 0) {
            return false;
        }
        Ways way = bound(rows, lamp);
        boolean gone = casts && change.gone().touches(beam);
        boolean come = casts && change.come().touches(beam);
        Arrays.fill(chosen, 0);
        boolean any = false;
        for (int from = 0; (gone || come) && from < rows.count; from += TOGETHER * RowBits.WIDTH) {
            int to = Math.min(rows.count, from + TOGETHER * RowBits.WIDTH);
            sweep(tracer.box(rows.px, rows.py, rows.pz, from, to));
            any |= choose(rows, from, to, way, state, gone && change.gone().touches(beam) ? change.gone() : BoxSet.NONE,
                    come && change.come().touches(beam) ? change.come() : BoxSet.NONE, chosen);
        }
        return any;
    }

    /** Adds those of rows {@code from … to − 1} whose blocked ways may meet what is gone, or whose free ways what came. */
    private boolean choose(HitRows rows, int from, int to, Ways way, byte[] state, BoxSet gone, BoxSet come, int[] chosen) {
        boolean any = false;
        for (int i = from; i < to && !(gone.isEmpty() && come.isEmpty()); i++) {
            boolean asked = (state[i] & LightRows.BLOCKED) != 0 && !gone.isEmpty() && touches(rows, i, way, gone)
                    || (state[i] & LightRows.CLEAR) != 0 && !come.isEmpty() && touches(rows, i, way, come);
            if (asked) {
                RowBits.add(chosen, i);
                any = true;
            }
        }
        return any;
    }

    /**
     * Chooses rows on whose free ways to a light another part of it may pass.
     *
     * @param chosen gets the rows, as {@link RowBits}
     * @return whether there are any
     */
    boolean chooseTints(HitRows rows, Lamp lamp, byte[] state, ShapeChange change, int[] chosen) {
        Arrays.fill(chosen, 0);
        if (rows.count == 0 || !casts || change.tints().isEmpty()) {
            return false;
        }
        Ways way = bound(rows, lamp);
        boolean any = false;
        for (int i = 0; change.tints().touches(beam) && i < rows.count; i++) {
            if ((state[i] & LightRows.CLEAR) != 0 && touches(rows, i, way, change.tints())) {
                RowBits.add(chosen, i);
                any = true;
            }
        }
        return any;
    }

    /** Counts rows that are asked again, though it is known that their ways are free. */
    void count(int[] asked, int count) {
        rays += RowBits.count(asked, count);
    }

    /**
     * What passes of a light on free ways.
     *
     * @param asked  rows of which nothing is known, as {@link RowBits}
     * @param before what is known of others; null where it is 1
     * @return red, green and blue columns; null where all are 1
     */
    float[][] tints(HitRows rows, Lamp lamp, int[] asked, float[][] before, Columns columns) {
        if (before == null && (tints == null || RowBits.count(asked, rows.count) == 0)) {
            return null;
        }
        Ways way = bound(rows, lamp);
        boolean any = tints != null && tints.aim(beam);
        if (before == null && !any) {
            return null;
        }
        float[][] to = TintCaster.begun(rows, before, columns);
        if (any) {
            tints.ask(rows, asked, way);
        }
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(asked, i)) {
                float[] tint = any ? tints.tint(rows, i) : null;
                for (int c = 0; c < 3; c++) {
                    to[c][i] = tint == null ? 1 : tint[c];
                }
            }
        }
        return TintCaster.kept(rows, to);
    }

    /** Adds what passes on each row's free way to sample {@code s} of an area, to which it was turned and whose ways are tinted. */
    void addTints(HitRows rows, RowWays way, LampArea area, int s, int[] free, double[][] sums) {
        tints.ask(rows, free, way, area, s);
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(free, i)) {
                float[] tint = tints.tint(rows, i);
                for (int c = 0; c < 3; c++) {
                    sums[c][i] += tint == null ? 1 : tint[c];
                }
            }
        }
    }

    /** Whether any way to the area that it was turned to may pass clear shapes. */
    boolean isTinted() {
        return tinted;
    }

    private boolean touches(HitRows rows, int i, Ways way, BoxSet boxes) {
        Vec3 to = way.source();
        double x = rows.px[i];
        double y = rows.py[i];
        double z = rows.pz[i];
        if (way.ends()) {
            ray.enter(x, y, z, to.x() - x, to.y() - y, to.z() - z);
        } else {
            ray.enter(x, y, z, to.x(), to.y(), to.z());
        }
        return boxes.touches(ray, way.ends() ? 1 : Double.POSITIVE_INFINITY);
    }

    /**
     * Turns to an area: finds the shapes that can stand between any row of the tile and any of its samples.
     *
     * @param lamp one that is larger than a point
     * @param ways gets what all of them have alike
     */
    void aim(HitRows rows, Lamp lamp, RowWays ways) {
        LampArea towards = lamp.area();
        toPoints = lamp.type().hasPosition();
        ways.ends = toPoints;
        ways.open = true;
        isUnderEnd = s -> false;
        if (toPoints) {
            area = ends.computeIfAbsent(towards, this::ends);
            ways.open = Arrays.stream(area).allMatch(WayEnd::isOpen);
            WayEnd[] places = area;
            isUnderEnd = ways.open ? isUnderEnd : s -> Arrays.stream(places).anyMatch(end -> end.indexOf(s) >= 0);
        }
        low = towards.low();
        high = towards.high();
        sweep(rows.box(tracer));
        tinted = tints != null && tints.aim(beam);
        collect();
        prove(rows, lamp);
    }

    private WayEnd[] ends(LampArea towards) {
        WayEnd[] all = new WayEnd[towards.x.length];
        Arrays.setAll(all, i -> geometry.end(new Vec3(towards.x[i], towards.y[i], towards.z[i])));
        return all;
    }

    /** Where the way to one place of the area that it was turned to ends. */
    WayEnd end(int place) {
        return area[place];
    }

    /** As {@link #cast(HitRows, Lamp, int[], int[])}, to samples of the area that it was turned to; ways that nothing can block cast no ray. */
    void cast(HitRows rows, RowWays way, int[] chosen, int[] blocked) {
        int[] doubts = doubts(rows, chosen);
        int count = RowBits.count(doubts, rows.count);
        Arrays.fill(blocked, 0);
        rays += count;
        if (count > 0) {
            tracer.blocked(rows, doubts, way, blockers, blocked);
        }
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            blocked[b] |= chosen[b] & dark[b];
        }
    }

    /** The rows of which all ways to the area that it was turned to are certainly blocked; bits that stand for no row have no meaning. */
    int[] dark() {
        return dark;
    }

    /** Finds out of which neighbours' ways to an area it is certain that they are free or blocked. */
    private void prove(HitRows rows, Lamp lamp) {
        boolean any = casts && geometry.throwsShadows();
        int words = RowBits.words(rows.count);
        for (int from = 0; from < words; from += TOGETHER) {
            int to = Math.min(words, from + TOGETHER);
            boolean some = any && mayBlock(rows, from * RowBits.WIDTH, Math.min(rows.count, to * RowBits.WIDTH));
            boolean all = some && blocksAll(lamp);
            Arrays.fill(doubtful, from, to, some && !all ? -1 : 0);
            Arrays.fill(dark, from, to, all ? -1 : 0);
        }
    }

    /** Whether one of the shapes that may block the ways swept last certainly blocks all of them. */
    private boolean blocksAll(Lamp lamp) {
        umbra.take(origins, lamp.source(), lamp.area().extent(), toPoints, isUnderEnd);
        boolean all = false;
        for (int c = 0; !blockers.tooMany && c < few.count && !all; c++) {
            all = umbra.isOf(geometry.primitives(), few.primitive[c]);
        }
        return all;
    }

    /** Those of the chosen rows whose ways to the area that it was turned to something may block; written again by the next call. */
    int[] doubts(HitRows rows, int[] chosen) {
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            asked[b] = chosen[b] & doubtful[b];
        }
        return asked;
    }

    /** Those of the chosen rows whose ways are not certainly free. */
    private int[] unproved(HitRows rows, int[] chosen) {
        if (blockers.count > WORTH_IT) {
            return chosen;
        }
        keepDoubtful(rows, chosen, unproved);
        return unproved;
    }

    /** Leaves out chosen rows whose ways are certainly free: neighbours are looked at together. */
    private void keepDoubtful(HitRows rows, int[] chosen, int[] doubtful) {
        int words = RowBits.words(rows.count);
        for (int from = 0; from < words; from += TOGETHER) {
            int to = Math.min(words, from + TOGETHER);
            boolean kept = isAny(chosen, from, to)
                    && mayBlock(rows, from * RowBits.WIDTH, Math.min(rows.count, to * RowBits.WIDTH));
            for (int b = from; b < to; b++) {
                doubtful[b] = kept ? chosen[b] : 0;
            }
        }
    }

    /** Whether any of the blockers may be in a way from rows {@code from … to − 1}. */
    private boolean mayBlock(HitRows rows, int from, int to) {
        if (blockers.tooMany) {
            return true;
        }
        sweep(tracer.box(rows.px, rows.py, rows.pz, from, to));
        few.takeFrom(blockers, geometry.primitives(), beam, departure);
        return demands.meets(few);
    }

    private static boolean isAny(int[] bits, int from, int to) {
        int any = 0;
        for (int b = from; b < to; b++) {
            any |= bits[b];
        }
        return any != 0;
    }

    /** Finds the shapes that can stand between any row of the tile and the light. */
    private Ways aim(HitRows rows, Lamp lamp) {
        Ways way = bound(rows, lamp);
        collect();
        return way;
    }

    /** Turns to a light at a point, or far away. */
    private Ways bound(HitRows rows, Lamp lamp) {
        Ways way = lamp.type().hasPosition() ? ways.computeIfAbsent(lamp.source(), point -> Ways.to(geometry.end(point)))
                : Ways.along(lamp.source());
        low = way.source();
        high = way.source();
        toPoints = way.ends();
        isUnderEnd = s -> way.end().indexOf(s) >= 0;
        sweep(rows.box(tracer));
        return way;
    }

    /** Finds the shapes that the ways swept last can meet. */
    private void collect() {
        blockers.collect(geometry.bvh(), beam);
        if (!blockers.tooMany) {
            blockers.leaveOut(geometry.primitives(), departure);
        }
    }

    /** Takes the ways from all points of a box. */
    private void sweep(PointBox box) {
        origins = box;
        beam.clear();
        beam.origins(box);
        if (toPoints) {
            beam.towards(low, high);
        } else {
            beam.along(low, high);
        }
        departure.take(box, low, high, toPoints, isUnderEnd);
    }
}
