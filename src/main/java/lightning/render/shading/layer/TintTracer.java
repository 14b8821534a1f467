package lightning.render.shading.layer;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.math.Vec3;
import lightning.render.shading.AreaSamples;
import lightning.render.shading.TransmittanceBatch;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.ShadowRayBatch;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.Tracer;
import lightning.render.trace.primitive.LightBuffers;
import lightning.render.trace.primitive.ShadowRayHits;
import lightning.render.trace.tree.Bvh;
import lightning.render.trace.tree.CandidateList;
import lightning.render.trace.tree.RayBeam;
import lightning.render.trace.tree.ShadowRayTarget;
import org.jspecify.annotations.Nullable;

/** Computes the transmittance of unblocked shadow rays through clear shapes. Holds scratch memory: use one instance per thread. */
final class TintTracer {
    /** Words of rows whose rays to all samples are traced together: four lines of a tile. */
    private static final int WORDS_PER_BLOCK = 8;
    private static final ShadowRayTarget[] OPEN = {};

    private final Tracer tracer;
    private final Bvh tree;
    private final Geometry geometry;
    /** Area of the latest rays, and its light buffers. */
    private @Nullable AreaSamples bufferedArea;
    private @Nullable LightBuffers lightBuffers;
    /** Clear shapes that shadow rays from the tile may pass. */
    private final CandidateList candidates = new CandidateList();
    private final CandidateList allCandidates;
    private CandidateList activeCandidates = candidates;
    private final Map<Vec3, ShadowRayTarget> pointTargets = new HashMap<>();
    private final Map<AreaSamples, ShadowRayTarget[]> areaTargets = new HashMap<>();
    private final ShadowRayBatch rays = new ShadowRayBatch();
    private final ShadowRayHits crossings = new ShadowRayHits(ShadowRayBatch.MAX_RAYS);
    private final TransmittanceBatch transmittance;

    /** @param geometry with shapes that light passes through */
    TintTracer(Geometry geometry, Tracer tracer) {
        this.tracer = tracer;
        this.geometry = geometry;
        transmittance = new TransmittanceBatch(geometry.primitives(), tracer);
        tree = requireNonNull(geometry.tintBvh());
        allCandidates = CandidateList.fromBvh(tree, requireNonNull(geometry.tintCasters()));
    }

    /** Collects the clear shapes that rays of a beam may pass; returns whether there are any. */
    boolean aim(RayBeam beam) {
        candidates.collect(tree, beam);
        // A tree with a single primitive contains it twice.
        activeCandidates = candidates.overflow || allCandidates.count == 1 ? allCandidates : candidates;
        return !candidates.isEmpty();
    }

    /** Writes the tints of the shadow rays of chosen rows to one point or in one direction: red, green and blue. */
    void writeTints(HitRows rows, int[] chosen, ShadowRays shadowRays, float[][] tints) {
        Vec3 source = shadowRays.source();
        ShadowRayTarget target = shadowRays.isPoint() ? pointTargets.computeIfAbsent(source, point -> ShadowRayTarget.find(point, tree))
                : ShadowRayTarget.OFF_SURFACE;
        rays.clear();
        rays.toPoints = shadowRays.isPoint();
        rays.targets = target.isOffSurface() ? null : new ShadowRayTarget[] {target};
        rays.lightBuffers = null;
        for (int b = 0; b < RowBits.words(rows.count); b++) {
            for (int left = chosen[b]; left != 0; left &= left - 1) {
                rays.add(rows, b * RowBits.WIDTH + Integer.numberOfTrailingZeros(left), source.x(), source.y(), source.z(), 0);
            }
        }
        trace();
        for (int k = 0; k < rays.count; k++) {
            boolean isCrossing = crossings.first(k) != ShadowRayHits.END;
            if (isCrossing) {
                transmittance.compute(rays, crossings, k);
            }
            for (int c = 0; c < 3; c++) {
                tints[c][rays.row[k]] = isCrossing ? transmittance.rgb[c] : 1;
            }
        }
    }

    /**
     * Writes the sums of the tints of the unblocked shadow rays of rows to the first samples of an area, added in the order of the
     * samples.
     *
     * @param patterns  sample pattern of each row
     * @param toPoints  false for a directional light
     * @param rowSet    rows to write
     * @param unblocked rows with an unblocked ray, for each sample
     * @param sums      receives red, green and blue
     */
    void sumTints(HitRows rows, int[] patterns, AreaSamples area, boolean toPoints, int[] rowSet, int[][] unblocked,
            double[][] sums) {
        for (double[] sum : sums) {
            Arrays.fill(sum, 0, rows.count, 0);
        }
        rays.clear();
        rays.toPoints = toPoints;
        ShadowRayTarget[] targets = toPoints ? areaTargets.computeIfAbsent(area, this::createTargets) : OPEN;
        rays.targets = targets == OPEN ? null : targets;
        rays.lightBuffers = toPoints && targets == OPEN ? lightBuffers(area) : null;
        int words = RowBits.words(rows.count);
        for (int from = 0; from < words; from += WORDS_PER_BLOCK) {
            for (int s = 0; s < area.samples(); s++) {
                for (int b = from; b < Math.min(words, from + WORDS_PER_BLOCK); b++) {
                    if (rays.count > ShadowRayBatch.MAX_RAYS - RowBits.WIDTH) {
                        addTints(sums);
                    }
                    addRays(rows, patterns, area, s, b, unblocked[s][b] & rowSet[b]);
                }
            }
        }
        addTints(sums);
    }

    /** Adds the shadow rays of rows of a word to sample {@code s}. */
    private void addRays(HitRows rows, int[] patterns, AreaSamples area, int s, int word, int bits) {
        for (int left = bits; left != 0; left &= left - 1) {
            int i = word * RowBits.WIDTH + Integer.numberOfTrailingZeros(left);
            int index = area.index(s, patterns[i]);
            rays.add(rows, i, area.x[index], area.y[index], area.z[index], index);
        }
    }

    /** Traces the rays of the batch, adds their tints to sums, and removes the rays. */
    private void addTints(double[][] sums) {
        trace();
        double[] red = sums[0];
        double[] green = sums[1];
        double[] blue = sums[2];
        for (int k = 0; k < rays.count; k++) {
            int i = rays.row[k];
            if (crossings.first(k) == ShadowRayHits.END) {
                red[i] += 1;
                green[i] += 1;
                blue[i] += 1;
            } else {
                transmittance.compute(rays, crossings, k);
                red[i] += transmittance.rgb[0];
                green[i] += transmittance.rgb[1];
                blue[i] += transmittance.rgb[2];
            }
        }
        rays.clear();
    }

    private void trace() {
        crossings.clear();
        tracer.findHits(rays, activeCandidates, crossings);
        transmittance.begin(rays, crossings);
    }

    private @Nullable LightBuffers lightBuffers(AreaSamples area) {
        if (bufferedArea != area) {
            bufferedArea = area;
            lightBuffers = geometry.tintLightBuffers(area.x, area.y, area.z);
        }
        return lightBuffers;
    }

    /** Returns the shadow ray targets of an area; {@link #OPEN} if none of them lies on a clear shape. */
    private ShadowRayTarget[] createTargets(AreaSamples area) {
        ShadowRayTarget[] all = area.positions().map(point -> ShadowRayTarget.find(point, tree)).toArray(ShadowRayTarget[]::new);
        return Arrays.stream(all).allMatch(ShadowRayTarget::isOffSurface) ? OPEN : all;
    }

    /** Returns columns that are 1 for rows without a known tint. */
    static float[][] startColumns(HitRows rows, float @Nullable [][] before, ColumnAllocator columns) {
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
    static float @Nullable [][] nullIfUntinted(HitRows rows, float[][] tints) {
        for (int c = 0; c < 3; c++) {
            for (int i = 0; i < rows.count; i++) {
                if (tints[c][i] != 1) {
                    return tints;
                }
            }
        }
        return null;
    }

    /** Returns whether columns have the same bits; null means 1 everywhere. */
    static boolean areEqual(HitRows rows, float @Nullable [][] a, float @Nullable [][] b) {
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
