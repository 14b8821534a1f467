package lightning.render.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntPredicate;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.BoxRay;
import lightning.render.trace.tree.BoxSet;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.FullOcclusionTest;
import lightning.render.trace.tree.HorizonCulling;
import lightning.render.trace.tree.PointBox;
import lightning.render.trace.tree.RayBeam;
import lightning.render.trace.tree.ShadowRayTarget;
import lightning.scene.effects.RenderEffect;
import lightning.scene.effects.ViewEffects;

/** Asks for chosen rows whether the way to a light is free. Holds scratch memory: one for each thread. */
final class ShadowCaster {
    /** Words of rows that are looked at together: two lines of a tile. */
    private static final int WORDS_PER_GROUP = 4;
    /** With more shapes in question, looking at neighbors takes longer than the rays that it saves. */
    private static final int MAX_CULLED_BLOCKERS = 6;

    private final Geometry geometry;
    private final Tracer tracer;
    private final RequiredWork requiredWork;
    private final RayBeam beam = new RayBeam();
    private final BoxRay ray = new BoxRay();
    private final HorizonCulling horizonCulling = new HorizonCulling();
    private final FullOcclusionTest occlusionTest = new FullOcclusionTest();
    /** What may stand between the tile and the light. */
    private final CandidateList blockers = new CandidateList();
    /** What may stand between some rows of it and the light. */
    private final CandidateList groupBlockers = new CandidateList();
    private final int[] uncertain = RowBits.allocate();
    /** The least and the greatest coordinates of the points where ways end, or of their directions. */
    private Vec3 targetMin = Vec3.ZERO;
    private Vec3 targetMax = Vec3.ZERO;
    private boolean hasPointTargets;
    /** Where the ways that were swept last begin. */
    private PointBox origins;
    /** Whether any of the points lies on a primitive. */
    private IntPredicate isUnderTarget = s -> false;
    /** Where the ways to lights lead that rays were cast to. */
    private final Map<Vec3, ShadowRays> pointTargets = new HashMap<>();
    /** Where the ways to the samples of areas end, by their place in the area. */
    private final Map<AreaSamples, ShadowRayTarget[]> areaTargets = new HashMap<>();
    private ShadowRayTarget[] currentTargets;
    /** The rows of which ways to the area may be blocked and others free, and those of which all are blocked. */
    private final int[] doubtful = RowBits.allocate();
    private final int[] fullyOccluded = RowBits.allocate();
    private final int[] queried = RowBits.allocate();
    private final boolean castsShadows;
    /** Null where light passes no shape. */
    private final TintTracer tintTracer;
    /** Whether ways to the area that it was turned to may pass clear shapes. */
    private boolean canBeTinted;
    private long rayCount;

    /** @param view whether any shape blocks a light, else all ways are free */
    ShadowCaster(Geometry geometry, Tracer tracer, ViewEffects view) {
        castsShadows = view.shows(RenderEffect.SHADOWS);
        requiredWork = RequiredWork.of(view);
        this.geometry = geometry;
        this.tracer = tracer;
        tintTracer = castsShadows && geometry.tintBvh() != null ? new TintTracer(geometry, tracer) : null;
    }

    /** Rows asked since the start: each a ray, but where it is certain beforehand that nothing is in the way. */
    long rayCount() {
        return rayCount;
    }

    /**
     * Casts a ray from each chosen row.
     *
     * @param chosen  rows to ask, as {@link RowBits}
     * @param blocked gets those of them from which the light is not seen
     */
    void cast(HitRows rows, LightSource source, int[] chosen, int[] blocked) {
        if (!castsShadows || !geometry.castsShadows()) {
            Arrays.fill(blocked, 0);
            return;
        }
        int count = RowBits.count(chosen, rows.count);
        rayCount += count;
        if (count == 0) {
            Arrays.fill(blocked, 0);
            return;
        }
        ShadowRays shadowRays = aim(rows, source);
        if (requiredWork.needsShadowRays(blockers)) {
            tracer.findBlocked(rows, cullUncertain(rows, chosen), shadowRays, blockers, blocked);
        } else {
            Arrays.fill(blocked, 0);
        }
    }

    /**
     * Chooses rows whose way to a light other shapes may block or free.
     *
     * <p>What blocks a row that no way of which meets anything that is gone, is still there; and where a way was free, only what
     * came can block it. {@link ShapeChange#hasSameTarget} must hold for a light at a point.
     *
     * @param state  whether the rows' ways are blocked, as {@link LightRows} has it; those that nobody asked are not chosen
     * @param chosen gets the rows, as {@link RowBits}
     * @return whether there are any
     */
    boolean findChangedRows(HitRows rows, LightSource source, byte[] state, ShapeChange change, int[] chosen) {
        if (rows.count == 0) {
            return false;
        }
        ShadowRays rayTarget = setTarget(rows, source);
        boolean removed = castsShadows && change.removedBoxes().intersects(beam);
        boolean added = castsShadows && change.addedBoxes().intersects(beam);
        Arrays.fill(chosen, 0);
        boolean any = false;
        for (int from = 0; (removed || added) && from < rows.count; from += WORDS_PER_GROUP * RowBits.WIDTH) {
            int to = Math.min(rows.count, from + WORDS_PER_GROUP * RowBits.WIDTH);
            setOrigins(tracer.bounds(rows.px, rows.py, rows.pz, from, to));
            any |= findChangedRows(rows, from, to, rayTarget, state,
                    removed && change.removedBoxes().intersects(beam) ? change.removedBoxes() : BoxSet.NONE,
                    added && change.addedBoxes().intersects(beam) ? change.addedBoxes() : BoxSet.NONE, chosen);
        }
        return any;
    }

    /** Adds those of rows {@code from … to − 1} whose blocked ways may meet what is gone, or whose free ways what came. */
    private boolean findChangedRows(HitRows rows, int from, int to, ShadowRays rayTarget, byte[] state, BoxSet removed, BoxSet added,
            int[] chosen) {
        boolean any = false;
        for (int i = from; i < to && !(removed.isEmpty() && added.isEmpty()); i++) {
            boolean isAffected = (state[i] & LightRows.BLOCKED) != 0 && !removed.isEmpty() && intersects(rows, i, rayTarget, removed)
                    || (state[i] & LightRows.UNBLOCKED) != 0 && !added.isEmpty() && intersects(rows, i, rayTarget, added);
            if (isAffected) {
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
    boolean findRetintedRows(HitRows rows, LightSource source, byte[] state, ShapeChange change, int[] chosen) {
        Arrays.fill(chosen, 0);
        if (rows.count == 0 || !castsShadows || change.tintChanges().isEmpty()) {
            return false;
        }
        ShadowRays rayTarget = setTarget(rows, source);
        boolean any = false;
        for (int i = 0; change.tintChanges().intersects(beam) && i < rows.count; i++) {
            if ((state[i] & LightRows.UNBLOCKED) != 0 && intersects(rows, i, rayTarget, change.tintChanges())) {
                RowBits.add(chosen, i);
                any = true;
            }
        }
        return any;
    }

    /** Counts rows that are asked again, though it is known that their ways are free. */
    void countRays(int[] queried, int count) {
        rayCount += RowBits.count(queried, count);
    }

    /**
     * What passes of a light on free ways.
     *
     * @param queried  rows of which nothing is known, as {@link RowBits}
     * @param before what is known of others; null where it is 1
     * @return red, green and blue columns; null where all are 1
     */
    float[][] tintColumns(HitRows rows, LightSource source, int[] queried, float[][] before, ColumnAllocator columns) {
        if (before == null && (tintTracer == null || RowBits.count(queried, rows.count) == 0)) {
            return null;
        }
        ShadowRays rayTarget = setTarget(rows, source);
        boolean any = tintTracer != null && tintTracer.aim(beam);
        if (before == null && !any) {
            return null;
        }
        float[][] to = TintTracer.startColumns(rows, before, columns);
        if (any) {
            tintTracer.trace(rows, queried, rayTarget);
        }
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(queried, i)) {
                float[] tint = any ? tintTracer.tint(rows, i) : null;
                for (int c = 0; c < 3; c++) {
                    to[c][i] = tint == null ? 1 : tint[c];
                }
            }
        }
        return TintTracer.nullIfUntinted(rows, to);
    }

    /** Adds what passes on each row's free way to sample {@code s} of an area, to which it was turned and whose ways are tinted. */
    void accumulateTints(HitRows rows, RowShadowRays shadowRays, AreaSamples area, int s, int[] free, double[][] sums) {
        tintTracer.trace(rows, free, shadowRays, area, s);
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(free, i)) {
                float[] tint = tintTracer.tint(rows, i);
                for (int c = 0; c < 3; c++) {
                    sums[c][i] += tint == null ? 1 : tint[c];
                }
            }
        }
    }

    /** Whether any way to the area that it was turned to may pass clear shapes. */
    boolean canBeTinted() {
        return canBeTinted;
    }

    private boolean intersects(HitRows rows, int i, ShadowRays rayTarget, BoxSet boxes) {
        Vec3 to = rayTarget.source();
        double x = rows.px[i];
        double y = rows.py[i];
        double z = rows.pz[i];
        if (rayTarget.isPoint()) {
            ray.setRay(x, y, z, to.x() - x, to.y() - y, to.z() - z);
        } else {
            ray.setRay(x, y, z, to.x(), to.y(), to.z());
        }
        return boxes.intersects(ray, rayTarget.isPoint() ? 1 : Double.POSITIVE_INFINITY);
    }

    /**
     * Turns to an area: finds the shapes that can stand between any row of the tile and any of its samples.
     *
     * @param source one that is larger than a point
     * @param shadowRays gets what all of them have alike
     */
    void aim(HitRows rows, LightSource source, RowShadowRays shadowRays) {
        AreaSamples samples = source.samples();
        hasPointTargets = source.type().hasPosition();
        shadowRays.toPoints = hasPointTargets;
        shadowRays.isOffSurface = true;
        isUnderTarget = s -> false;
        if (hasPointTargets) {
            currentTargets = areaTargets.computeIfAbsent(samples, this::createTargets);
            shadowRays.isOffSurface = Arrays.stream(currentTargets).allMatch(ShadowRayTarget::isOffSurface);
            ShadowRayTarget[] places = currentTargets;
            isUnderTarget = shadowRays.isOffSurface ? isUnderTarget : s -> Arrays.stream(places).anyMatch(end -> end.indexOf(s) >= 0);
        }
        targetMin = samples.low();
        targetMax = samples.high();
        setOrigins(rows.bounds(tracer));
        canBeTinted = tintTracer != null && tintTracer.aim(beam);
        collectBlockers();
        classifyRows(rows, source);
    }

    private ShadowRayTarget[] createTargets(AreaSamples samples) {
        ShadowRayTarget[] all = new ShadowRayTarget[samples.x.length];
        Arrays.setAll(all, i -> geometry.shadowRayTarget(new Vec3(samples.x[i], samples.y[i], samples.z[i])));
        return all;
    }

    /** Where the way to one place of the area that it was turned to ends. */
    ShadowRayTarget target(int nodeIndex) {
        return currentTargets[nodeIndex];
    }

    /** As {@link #cast(HitRows, LightSource, int[], int[])}, to samples of the area that it was turned to; ways that nothing can block cast no ray. */
    void cast(HitRows rows, RowShadowRays shadowRays, int[] chosen, int[] blocked) {
        int[] uncertain = uncertainRows(rows, chosen);
        int count = RowBits.count(uncertain, rows.count);
        Arrays.fill(blocked, 0);
        rayCount += count;
        if (count > 0) {
            tracer.findBlocked(rows, uncertain, shadowRays, blockers, blocked);
        }
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            blocked[b] |= chosen[b] & fullyOccluded[b];
        }
    }

    /** The rows of which all ways to the area that it was turned to are certainly blocked; bits that stand for no row have no meaning. */
    int[] fullyOccluded() {
        return fullyOccluded;
    }

    /** Finds out of which neighbors' ways to an area it is certain that they are free or blocked. */
    private void classifyRows(HitRows rows, LightSource source) {
        boolean any = castsShadows && geometry.castsShadows();
        int words = RowBits.words(rows.count);
        for (int from = 0; from < words; from += WORDS_PER_GROUP) {
            int to = Math.min(words, from + WORDS_PER_GROUP);
            boolean canBlock = any && canBlock(rows, from * RowBits.WIDTH, Math.min(rows.count, to * RowBits.WIDTH));
            boolean isOccluded = canBlock && isFullyOccluded(source);
            Arrays.fill(doubtful, from, to, canBlock && !isOccluded ? -1 : 0);
            Arrays.fill(fullyOccluded, from, to, isOccluded ? -1 : 0);
        }
    }

    /** Whether one of the shapes that may block the ways swept last certainly blocks all of them. */
    private boolean isFullyOccluded(LightSource source) {
        occlusionTest.setRays(origins, source.position(), source.samples().extent(), hasPointTargets, isUnderTarget);
        boolean isOccluded = false;
        for (int c = 0; !blockers.overflow && c < groupBlockers.count && !isOccluded; c++) {
            isOccluded = occlusionTest.isFullOccluder(geometry.primitives(), groupBlockers.primitive[c]);
        }
        return isOccluded;
    }

    /** Those of the chosen rows whose ways to the area that it was turned to something may block; written again by the next call. */
    int[] uncertainRows(HitRows rows, int[] chosen) {
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            queried[b] = chosen[b] & doubtful[b];
        }
        return queried;
    }

    /** Those of the chosen rows whose ways are not certainly free. */
    private int[] cullUncertain(HitRows rows, int[] chosen) {
        if (blockers.count > MAX_CULLED_BLOCKERS) {
            return chosen;
        }
        selectUncertain(rows, chosen, uncertain);
        return uncertain;
    }

    /** Leaves out chosen rows whose ways are certainly free: neighbors are looked at together. */
    private void selectUncertain(HitRows rows, int[] chosen, int[] uncertain) {
        int words = RowBits.words(rows.count);
        for (int from = 0; from < words; from += WORDS_PER_GROUP) {
            int to = Math.min(words, from + WORDS_PER_GROUP);
            boolean storesColors = isAny(chosen, from, to)
                    && canBlock(rows, from * RowBits.WIDTH, Math.min(rows.count, to * RowBits.WIDTH));
            for (int b = from; b < to; b++) {
                uncertain[b] = storesColors ? chosen[b] : 0;
            }
        }
    }

    /** Whether any of the blockers may be in a way from rows {@code from … to − 1}. */
    private boolean canBlock(HitRows rows, int from, int to) {
        if (blockers.overflow) {
            return true;
        }
        setOrigins(tracer.bounds(rows.px, rows.py, rows.pz, from, to));
        groupBlockers.collectFrom(blockers, geometry.primitives(), beam, horizonCulling);
        return requiredWork.needsShadowRays(groupBlockers);
    }

    private static boolean isAny(int[] bits, int from, int to) {
        int any = 0;
        for (int b = from; b < to; b++) {
            any |= bits[b];
        }
        return any != 0;
    }

    /** Finds the shapes that can stand between any row of the tile and the light. */
    private ShadowRays aim(HitRows rows, LightSource source) {
        ShadowRays rayTarget = setTarget(rows, source);
        collectBlockers();
        return rayTarget;
    }

    /** Turns to a light at a point, or far away. */
    private ShadowRays setTarget(HitRows rows, LightSource source) {
        ShadowRays rayTarget = source.type().hasPosition()
                ? pointTargets.computeIfAbsent(source.position(), point -> ShadowRays.toPoint(geometry.shadowRayTarget(point)))
                : ShadowRays.inDirection(source.position());
        targetMin = rayTarget.source();
        targetMax = rayTarget.source();
        hasPointTargets = rayTarget.isPoint();
        isUnderTarget = s -> rayTarget.target().indexOf(s) >= 0;
        setOrigins(rows.bounds(tracer));
        return rayTarget;
    }

    /** Finds the shapes that the ways swept last can meet. */
    private void collectBlockers() {
        blockers.collect(geometry.bvh(), beam);
        if (!blockers.overflow) {
            blockers.cull(geometry.primitives(), horizonCulling);
        }
    }

    /** Takes the ways from all points of a box. */
    private void setOrigins(PointBox box) {
        origins = box;
        beam.clear();
        beam.addOrigins(box);
        if (hasPointTargets) {
            beam.aimAt(targetMin, targetMax);
        } else {
            beam.aimAlong(targetMin, targetMax);
        }
        horizonCulling.setRays(box, targetMin, targetMax, hasPointTargets, isUnderTarget);
    }
}
