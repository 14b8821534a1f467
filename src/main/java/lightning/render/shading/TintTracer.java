package lightning.render.shading;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.math.Vec3;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.RowShadowRays;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.LightBuffers;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.render.trace.tree.ShadowRayTarget;

/** Computes the transmittance of unblocked shadow rays through clear shapes. Holds scratch memory: use one instance per thread. */
final class TintTracer {
    private static final ShadowRayTarget[] OPEN = {};

    private final Tracer tracer;
    private final PrimitiveTable primitives;
    private final Bvh tree;
    private final Geometry geometry;
    /** Area of the latest rays, and its light buffers. */
    private AreaSamples bufferedArea;
    private LightBuffers lightBuffers;
    /** Clear shapes that shadow rays from the tile may pass. */
    private final CandidateList candidates = new CandidateList();
    private final CandidateList allCandidates;
    private CandidateList activeCandidates;
    private final Map<Vec3, ShadowRayTarget> pointTargets = new HashMap<>();
    private final Map<AreaSamples, ShadowRayTarget[]> areaTargets = new HashMap<>();
    private final RowShadowRays shadowRays = new RowShadowRays();
    private final ShadowRayHits crossings = new ShadowRayHits(TermKernel.MAX_ROWS);
    private final Transmittance transmittance = new Transmittance();

    /** @param geometry with shapes that light passes through */
    TintTracer(Geometry geometry, Tracer tracer) {
        this.tracer = tracer;
        this.geometry = geometry;
        primitives = geometry.primitives();
        tree = geometry.tintBvh();
        allCandidates = CandidateList.fromBvh(tree, geometry.tintCasters());
    }

    /** Collects the clear shapes that rays of a beam may pass; returns whether there are any. */
    boolean aim(RayBeam beam) {
        candidates.collect(tree, beam);
        // A tree with a single primitive contains it twice.
        activeCandidates = candidates.overflow || allCandidates.count == 1 ? allCandidates : candidates;
        return !candidates.isEmpty();
    }

    /** Traces the shadow rays of chosen rows to one point or in one direction. */
    void trace(HitRows rows, int[] chosen, ShadowRays rays) {
        Vec3 source = rays.source();
        int end = RowBits.words(rows.count) * RowBits.WIDTH;
        Arrays.fill(shadowRays.x, 0, end, source.x());
        Arrays.fill(shadowRays.y, 0, end, source.y());
        Arrays.fill(shadowRays.z, 0, end, source.z());
        Arrays.fill(shadowRays.pattern, 0, end, 0);
        shadowRays.toPoints = rays.isPoint();
        ShadowRayTarget target = rays.isPoint() ? pointTargets.computeIfAbsent(source, point -> ShadowRayTarget.find(point, tree))
                : ShadowRayTarget.OFF_SURFACE;
        shadowRays.isOffSurface = target.isOffSurface();
        shadowRays.lightBuffers = null;
        Arrays.fill(shadowRays.target, 0, end, target);
        traceCrossings(rows, chosen);
    }

    /** Traces the shadow rays of chosen rows to sample {@code s} of an area. */
    void trace(HitRows rows, int[] chosen, RowShadowRays rays, AreaSamples area, int s) {
        int end = RowBits.words(rows.count) * RowBits.WIDTH;
        System.arraycopy(rays.x, 0, shadowRays.x, 0, end);
        System.arraycopy(rays.y, 0, shadowRays.y, 0, end);
        System.arraycopy(rays.z, 0, shadowRays.z, 0, end);
        System.arraycopy(rays.pattern, 0, shadowRays.pattern, 0, end);
        shadowRays.toPoints = rays.toPoints;
        ShadowRayTarget[] places = rays.toPoints ? areaTargets.computeIfAbsent(area, this::createTargets) : OPEN;
        shadowRays.isOffSurface = places == OPEN;
        for (int i = 0; !shadowRays.isOffSurface && i < rows.count; i++) {
            shadowRays.target[i] = places[area.index(s, rays.pattern[i])];
        }
        shadowRays.lightBuffers = rays.toPoints && shadowRays.isOffSurface ? lightBuffers(area) : null;
        shadowRays.firstTarget = area.index(s, 0);
        traceCrossings(rows, chosen);
    }

    private LightBuffers lightBuffers(AreaSamples area) {
        if (bufferedArea != area) {
            bufferedArea = area;
            lightBuffers = geometry.tintLightBuffers(area.x, area.y, area.z);
        }
        return lightBuffers;
    }

    /** Returns the shadow ray targets of an area; {@link #OPEN} if none of them lies on a clear shape. */
    private ShadowRayTarget[] createTargets(AreaSamples area) {
        ShadowRayTarget[] all = new ShadowRayTarget[area.x.length];
        Arrays.setAll(all, i -> ShadowRayTarget.find(new Vec3(area.x[i], area.y[i], area.z[i]), tree));
        return Arrays.stream(all).allMatch(ShadowRayTarget::isOffSurface) ? OPEN : all;
    }

    private void traceCrossings(HitRows rows, int[] chosen) {
        crossings.clear();
        tracer.findHits(rows, chosen, shadowRays, activeCandidates, crossings);
    }

    /**
     * Returns the transmittance of a traced row's shadow ray; valid until the next call.
     *
     * @return red, green and blue, or null if all light passes
     */
    float[] tint(HitRows rows, int i) {
        if (crossings.first(i) == ShadowRayHits.END) {
            return null;
        }
        double x = rows.px[i];
        double y = rows.py[i];
        double z = rows.pz[i];
        boolean hasTarget = shadowRays.toPoints;
        double dx = hasTarget ? shadowRays.x[i] - x : shadowRays.x[i];
        double dy = hasTarget ? shadowRays.y[i] - y : shadowRays.y[i];
        double dz = hasTarget ? shadowRays.z[i] - z : shadowRays.z[i];
        return transmittance.compute(primitives, crossings, i, x, y, z, dx, dy, dz, hasTarget) ? transmittance.rgb : null;
    }

    /** Returns columns that are 1 for rows without a known tint. */
    static float[][] startColumns(HitRows rows, float[][] before, ColumnAllocator columns) {
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

    /** Returns the tints as a layer stores them: null if all of them are 1. */
    static float[][] nullIfUntinted(HitRows rows, float[][] tints) {
        for (int c = 0; tints != null && c < 3; c++) {
            for (int i = 0; i < rows.count; i++) {
                if (tints[c][i] != 1) {
                    return tints;
                }
            }
        }
        return null;
    }

    /** Returns whether columns have the same bits; null means 1 everywhere. */
    static boolean areEqual(HitRows rows, float[][] a, float[][] b) {
        if (a == null || b == null) {
            return a == b;
        }
        boolean isEqual = true;
        for (int c = 0; c < 3; c++) {
            isEqual &= Arrays.equals(a[c], 0, rows.count, b[c], 0, rows.count);
        }
        return isEqual;
    }
}
