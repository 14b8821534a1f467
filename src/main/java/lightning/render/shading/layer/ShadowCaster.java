package lightning.render.shading.layer;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.IntPredicate;
import lightning.base.math.Vec3;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.LightSource;
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
import org.jspecify.annotations.Nullable;

/** Casts shadow rays from chosen rows to a light. Holds scratch memory: use one instance per thread. */
final class ShadowCaster {
    /** Words of rows that are culled together: two lines of a tile. */
    private static final int WORDS_PER_GROUP = 4;
    /** With more candidate shapes, culling takes longer than the rays that it saves. */
    private static final int MAX_CULLED_BLOCKERS = 6;

    private final Geometry geometry;
    private final Tracer tracer;
    private final RequiredWork requiredWork;
    private final RayBeam beam = new RayBeam();
    private final BoxRay ray = new BoxRay();
    private final HorizonCulling horizonCulling = new HorizonCulling();
    private final FullOcclusionTest occlusionTest = new FullOcclusionTest();
    /** Possible occluders between the tile and the light. */
    private final CandidateList blockers = new CandidateList();
    /** Possible occluders between a group of rows and the light. */
    private final CandidateList groupBlockers = new CandidateList();
    private final int[] uncertain = RowBits.allocate();
    /** Bounds of the shadow ray targets, or of their directions. */
    private Vec3 targetMin = Vec3.ZERO;
    private Vec3 targetMax = Vec3.ZERO;
    private boolean hasPointTargets;
    /** Origins of the rays whose occluders were collected last. */
    private @Nullable PointBox origins;
    /** Returns whether a target lies on a primitive. */
    private IntPredicate isUnderTarget = s -> false;
    /** Shadow ray targets of point lights. */
    private final Map<Vec3, ShadowRays> pointTargets = new HashMap<>();
    /** Shadow ray targets of area light samples, by index in the area. */
    private final Map<AreaSamples, ShadowRayTarget[]> areaTargets = new HashMap<>();
    private ShadowRayTarget[] currentTargets = {};
    /** Rows with possibly blocked and possibly unblocked rays to the area, and rows whose rays are all blocked. */
    private final int[] possiblyBlocked = RowBits.allocate();
    private final int[] fullyOccluded = RowBits.allocate();
    private final int[] queried = RowBits.allocate();
    private final boolean castsShadows;
    /** Null if light passes through no shape. */
    private final @Nullable TintTracer tintTracer;
    /** True if shadow rays to the current area may pass through clear shapes. */
    private boolean canBeTinted;
    /** Shadow rays of each light by its name; one entry each, which is counted up. */
    private final Map<String, long[]> rayCounts;
    /** Count of the present light. */
    private long[] rayCount = new long[1];

    /**
     * @param view its effects decide whether shapes block light; if not, all shadow rays are unblocked
     * @param rayCounts receives the number of rows tested for each light, by its name. Each is a ray, unless the ray is certainly unblocked.
     */
    ShadowCaster(Geometry geometry, Tracer tracer, ViewEffects view, Map<String, long[]> rayCounts) {
        this.rayCounts = rayCounts;
        castsShadows = view.shows(RenderEffect.SHADOWS);
        requiredWork = RequiredWork.of(view);
        this.geometry = geometry;
        this.tracer = tracer;
        tintTracer = castsShadows && geometry.tintBvh() != null ? new TintTracer(geometry, tracer) : null;
    }

    /**
     * Casts a shadow ray from each chosen row.
     *
     * @param chosen  rows to test, as {@link RowBits}
     * @param blocked receives the chosen rows from which the light is not visible
     */
    void cast(HitRows rows, LightSource source, int[] chosen, int[] blocked) {
        if (!castsShadows || !geometry.castsShadows()) {
            Arrays.fill(blocked, 0);
            return;
        }
        int count = RowBits.count(chosen, rows.count);
        startCount(source);
        rayCount[0] += count;
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
     * Chooses rows whose shadow ray result a geometry change may change.
     *
     * <p>A blocked row stays blocked unless one of its shadow rays meets a removed shape, and an unblocked ray can only be blocked
     * by an added shape. For a point light, {@link ShapeChange#hasSameTarget} must hold.
     *
     * @param state  shadow ray results of the rows as in {@link LightRows}; untested rows are not chosen
     * @param chosen receives the rows, as {@link RowBits}
     * @return whether any row is chosen
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

    /**
     * Adds those of rows {@code from … to − 1} whose blocked ray may meet a removed shape or whose unblocked ray may meet an added
     * one.
     */
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
     * Chooses rows of an area light's layer one of whose shadow rays, or its tint, a geometry change may change. A row that sees no
     * sample changes only if one of its shadow rays may meet a removed shape.
     *
     * @param state  shadow ray results of the rows as in {@link LightRows}; untested rows are not chosen
     * @param chosen receives the rows, as {@link RowBits}
     * @return whether any row is chosen
     */
    boolean findChangedAreaRows(HitRows rows, LightSource source, byte[] state, ShapeChange change, int[] chosen) {
        Arrays.fill(chosen, 0);
        if (rows.count == 0 || !castsShadows) {
            return false;
        }
        AreaSamples samples = source.samples(rows);
        hasPointTargets = source.type().hasPosition();
        targetMin = samples.low();
        targetMax = samples.high();
        if (!intersects(rows.bounds(tracer), change.visibleChanges())) {
            return false;
        }
        boolean any = false;
        PointBox row = new PointBox();
        for (int from = 0; from < rows.count; from += WORDS_PER_GROUP * RowBits.WIDTH) {
            int to = Math.min(rows.count, from + WORDS_PER_GROUP * RowBits.WIDTH);
            boolean isNear = intersects(tracer.bounds(rows.px, rows.py, rows.pz, from, to), change.visibleChanges());
            for (int i = from; isNear && i < to; i++) {
                int tested = state[i] & LightRows.SHADOW_RAY_MASK;
                row.set(rows.px[i], rows.py[i], rows.pz[i]);
                if (tested != 0 && intersects(row, tested == LightRows.BLOCKED ? change.removedBoxes() : change.visibleChanges())) {
                    RowBits.add(chosen, i);
                    any = true;
                }
            }
        }
        return any;
    }

    /** Returns whether any ray from points of a box to the targets can hit any of the boxes. */
    private boolean intersects(PointBox points, BoxSet boxes) {
        setBeam(points);
        return boxes.intersects(beam);
    }

    /**
     * Chooses rows whose unblocked shadow rays may have another tint after a geometry change.
     *
     * @param chosen receives the rows, as {@link RowBits}
     * @return whether any row is chosen
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

    private void startCount(LightSource source) {
        rayCount = rayCounts.computeIfAbsent(source.light().name(), _ -> new long[1]);
    }

    /** Counts rows that are tested again although their rays are known to be unblocked. */
    void countRays(LightSource source, int[] queried, int count) {
        startCount(source);
        rayCount[0] += RowBits.count(queried, count);
    }

    /**
     * Returns the tints of unblocked shadow rays.
     *
     * @param queried rows without a known tint, as {@link RowBits}
     * @param before  tints of the other rows; null if all are 1
     * @return red, green and blue columns; null if all are 1
     */
    float @Nullable [][] tintColumns(HitRows rows, LightSource source, int[] queried, float @Nullable [][] before,
            ColumnAllocator columns) {
        if (before == null && (tintTracer == null || RowBits.count(queried, rows.count) == 0)) {
            return null;
        }
        ShadowRays rayTarget = setTarget(rows, source);
        boolean any = tintTracer != null && tintTracer.aim(beam);
        if (before == null && !any) {
            return null;
        }
        float[][] to = TintTracer.startColumns(rows, before, columns);
        for (int i = 0; i < rows.count; i++) {
            if (RowBits.contains(queried, i)) {
                for (float[] column : to) {
                    column[i] = 1;
                }
            }
        }
        if (any) {
            assert tintTracer != null;
            tintTracer.writeTints(rows, queried, rayTarget, to);
        }
        return TintTracer.nullIfUntinted(rows, to);
    }

    /**
     * Writes the sums of the tints of unblocked shadow rays to the samples of the current area, whose rays may be tinted.
     *
     * @param patterns sample pattern of each row
     * @param rowSet   rows to write
     * @param unblocked rows with an unblocked ray, for each sample
     * @param sums     receives red, green and blue
     */
    void sumTints(HitRows rows, int[] patterns, AreaSamples area, int[] rowSet, int[][] unblocked, double[][] sums) {
        requireNonNull(tintTracer).sumTints(rows, patterns, area, hasPointTargets, rowSet, unblocked, sums);
    }

    /** Returns whether shadow rays to the current area may pass through clear shapes. */
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
     * Sets the current area light: collects the shapes between any row of the tile and any of its samples.
     *
     * @param source     an area light
     * @param shadowRays receives the data common to all of these rays
     */
    void aim(HitRows rows, LightSource source, RowShadowRays shadowRays) {
        startCount(source);
        AreaSamples samples = source.samples(rows);
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
        return samples.positions().map(geometry::shadowRayTarget).toArray(ShadowRayTarget[]::new);
    }

    /** Returns the shadow ray target of one position in the current area. */
    ShadowRayTarget target(int nodeIndex) {
        return currentTargets[nodeIndex];
    }

    /**
     * Casts shadow rays to samples of the current area, as {@link #cast(HitRows, LightSource, int[], int[])}. Skips rays that
     * nothing can block.
     */
    void cast(HitRows rows, RowShadowRays shadowRays, int[] chosen, int[] blocked) {
        int[] uncertain = uncertainRows(rows, chosen);
        int count = RowBits.count(uncertain, rows.count);
        Arrays.fill(blocked, 0);
        rayCount[0] += count;
        if (count > 0) {
            tracer.findBlocked(rows, uncertain, shadowRays, blockers, blocked);
        }
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            blocked[b] |= chosen[b] & fullyOccluded[b];
        }
    }

    /** Returns the rows whose shadow rays to the current area are all certainly blocked; bits without a row are undefined. */
    int[] fullyOccluded() {
        return fullyOccluded;
    }

    /** Classifies groups of rows whose shadow rays to an area are certainly unblocked or blocked. */
    private void classifyRows(HitRows rows, LightSource source) {
        boolean any = castsShadows && geometry.castsShadows();
        int words = RowBits.words(rows.count);
        for (int from = 0; from < words; from += WORDS_PER_GROUP) {
            int to = Math.min(words, from + WORDS_PER_GROUP);
            boolean canBlock = any && canBlock(rows, from * RowBits.WIDTH, Math.min(rows.count, to * RowBits.WIDTH));
            boolean isOccluded = canBlock && isFullyOccluded(source);
            Arrays.fill(possiblyBlocked, from, to, canBlock && !isOccluded ? -1 : 0);
            Arrays.fill(fullyOccluded, from, to, isOccluded ? -1 : 0);
        }
    }

    /** Returns whether one of the collected occluders certainly blocks all rays of the current group. */
    private boolean isFullyOccluded(LightSource source) {
        occlusionTest.setRays(requireNonNull(origins), source.position(), source.extent(), hasPointTargets, isUnderTarget);
        boolean isOccluded = false;
        for (int c = 0; !blockers.overflow && c < groupBlockers.count && !isOccluded; c++) {
            isOccluded = occlusionTest.isFullOccluder(geometry.primitives(), groupBlockers.primitive[c]);
        }
        return isOccluded;
    }

    /** Returns the chosen rows whose shadow rays to the current area may be blocked; valid until the next call. */
    int[] uncertainRows(HitRows rows, int[] chosen) {
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            queried[b] = chosen[b] & possiblyBlocked[b];
        }
        return queried;
    }

    /** Returns the chosen rows whose shadow rays are not certainly unblocked. */
    private int[] cullUncertain(HitRows rows, int[] chosen) {
        if (blockers.count > MAX_CULLED_BLOCKERS) {
            return chosen;
        }
        selectUncertain(rows, chosen, uncertain);
        return uncertain;
    }

    /** Removes chosen rows whose shadow rays are certainly unblocked; tests groups of neighbors together. */
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

    /** Returns whether any occluder may block a ray from rows {@code from … to − 1}. */
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

    /** Collects the shapes that may be between any row of the tile and the light. */
    private ShadowRays aim(HitRows rows, LightSource source) {
        ShadowRays rayTarget = setTarget(rows, source);
        collectBlockers();
        return rayTarget;
    }

    /** Sets the current point or directional light. */
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

    /** Collects the shapes that rays from the current origins can meet. */
    private void collectBlockers() {
        blockers.collect(geometry.bvh(), beam);
        if (!blockers.overflow) {
            blockers.cull(geometry.primitives(), horizonCulling);
        }
    }

    /** Sets the beam from all points of a box to the targets. */
    private void setBeam(PointBox box) {
        beam.clear();
        beam.addOrigins(box);
        if (hasPointTargets) {
            beam.aimAt(targetMin, targetMax);
        } else {
            beam.aimAlong(targetMin, targetMax);
        }
    }

    /** Sets the ray origins to all points of a box. */
    private void setOrigins(PointBox box) {
        origins = box;
        setBeam(box);
        horizonCulling.setRays(box, targetMin, targetMax, hasPointTargets, isUnderTarget);
    }
}
