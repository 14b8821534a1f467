package lightning.render.gather.build;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.IntUnaryOperator;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.glow.GlowCaster;
import lightning.render.gather.glow.GlowLinks;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.ray.KnownRays;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.ray.RayLinks;
import lightning.render.gather.ray.RaySources;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.Tracer;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Casts the rays of gather points or surfels on all threads; after an edit only those that a memo does not know. */
final class PathCaster {
    /** Points in a job if most rays are known. */
    private static final int MEMO_POINTS = 256;

    private final WorkerPool workers;
    private final @Nullable PathMemo memo;
    private final @Nullable KnownRays known;
    private final boolean ofPoints;
    /** True if rays of known points to glowing objects meet what they met. */
    private final boolean keepsGlow;
    private final GlowLinks knownGlow;
    private final int pointsPerBatch;
    final int raysPerPoint;
    private final GatherCaster[] casters;
    /** None without a memo. */
    private final MemoCaster[] memoCasters;
    /** None without glowing objects. */
    private final GlowCaster[] glowCasters;
    private final List<GlowLinks.Part> glow = new ArrayList<>();
    private final PathMemory memory;
    private long rays;

    /**
     * @param tracers       one for each thread
     * @param memo          paths before an edit
     * @param memoTracers   one for each thread, of the geometry before the edit
     * @param glows         glowing objects at which rays are aimed
     * @param ofPoints      whether gather points cast the rays
     */
    PathCaster(Geometry geometry, Scene scene, WorkerPool workers, Tracer[] tracers, @Nullable PathMemo memo,
            @Nullable IntFunction<Tracer> memoTracers, CellKeys keys, DirectionTable directions, GlowShapes glows, PathMemory memory,
            boolean ofPoints) {
        this.memory = memory;
        this.workers = workers;
        this.memo = memo;
        this.ofPoints = ofPoints;
        known = memo == null ? null : ofPoints ? memo.points() : memo.surfels();
        keepsGlow = memo != null && memo.isUnchanged() && memo.glow().shapes().areSame(glows);
        knownGlow = memo == null ? GlowLinks.of(List.of()) : ofPoints ? memo.glow().ofPoints() : memo.glow().ofSurfels();
        raysPerPoint = directions.rays();
        pointsPerBatch = memo == null ? GatherCaster.pointsPerBatch(directions) : MEMO_POINTS;
        casters = new GatherCaster[tracers.length];
        Arrays.setAll(casters, worker -> new GatherCaster(geometry, scene, tracers[worker], keys, directions, glows));
        memoCasters = new MemoCaster[memo == null ? 0 : tracers.length];
        if (memo != null && memoTracers != null) {
            Arrays.setAll(memoCasters, worker -> new MemoCaster(memo, geometry, scene, tracers[worker], memoTracers.apply(worker), keys,
                    directions, glows));
        }
        glowCasters = new GlowCaster[glows.count() == 0 ? 0 : tracers.length];
        Arrays.setAll(glowCasters, worker -> new GlowCaster(glows, raysPerPoint, geometry, scene, tracers[worker]));
    }

    /**
     * Casts the rays of points {@code from … to − 1}.
     *
     * @param links          receives the cell that each ray hit
     * @param inverseLengths receives the sum of the {@link lightning.render.gather.ray.InverseLengths} of each point's rays; null if not wanted
     * @param progress       receives the finished share of the points
     */
    void cast(RaySources points, int from, int to, RayLinks links, long @Nullable [] inverseLengths, Progress progress) {
        points.reserveNormals(to);
        IntUnaryOperator knownPoint = keepsGlow ? p -> requireNonNull(known).find(points, p) : _ -> KnownRays.UNKNOWN;
        workers.run(Math.ceilDiv(to - from, pointsPerBatch), (worker, job) -> {
            int first = from + job * pointsPerBatch;
            int end = Math.min(to, first + pointsPerBatch);
            casters[worker].findNormals(points, first, end);
            if (known == null) {
                casters[worker].cast(points, first, end, links, inverseLengths);
            } else {
                memoCasters[worker].cast(points, first, end, known, links, inverseLengths);
            }
            if (glowCasters.length > 0) {
                add(glowCasters[worker].cast(points, first, end, knownGlow, knownPoint));
            }
        }, progress);
        rays += memo == null ? (long) (to - from) * raysPerPoint : 0;
    }

    private synchronized void add(GlowLinks.Part part) {
        memory.reserve(part.shape().length, GlowLinks.BUILD_BYTES);
        glow.add(part);
    }

    /** Returns the shares of the light of small glowing objects that all points receive. */
    GlowLinks glowLinks() {
        return GlowLinks.of(glow);
    }

    /** Casts some rays again and returns what they hit, as {@link GatherCaster#hits}. */
    HitRows hits(int worker, RaySources points, int[] selected, int from, int to) {
        return casters[worker].hits(points, selected, from, to);
    }

    /** Returns the surfel of the memo that is the hit of a ray; {@link RayLinks#MISS} for none. */
    int knownSurfel(int worker, RaySources points, int ray) {
        return known == null ? RayLinks.MISS : memoCasters[worker].knownSurfel(points, ray, known, ofPoints);
    }

    /** Returns the number of rays cast so far. */
    long rayCount() {
        return rays + Arrays.stream(glowCasters).mapToLong(GlowCaster::rayCount).sum()
                + Arrays.stream(memoCasters).mapToLong(MemoCaster::rayCount).sum();
    }
}
