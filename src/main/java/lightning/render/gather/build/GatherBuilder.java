package lightning.render.gather.build;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import lightning.base.work.Progress;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.gather.GatherRays;
import lightning.render.gather.GatherStructure;
import lightning.render.gather.PointChanges;
import lightning.render.gather.SurfelRows;
import lightning.render.gather.cell.CellKeys;
import lightning.render.gather.cell.DirectionTable;
import lightning.render.gather.cell.SeenSurfaces;
import lightning.render.gather.glow.GlowPaths;
import lightning.render.gather.glow.GlowShapes;
import lightning.render.gather.point.Barriers;
import lightning.render.gather.point.FilterBuilder;
import lightning.render.gather.point.GatherPoints;
import lightning.render.gather.point.PointFilter;
import lightning.render.gather.point.PointGroups;
import lightning.render.gather.ray.PathMemory;
import lightning.render.gather.reflection.ReflectionCaster;
import lightning.render.gather.reflection.ReflectionDirections;
import lightning.render.gather.reflection.ReflectionFilter;
import lightning.render.gather.reflection.ReflectionMemo;
import lightning.render.gather.reflection.ReflectionPaths;
import lightning.render.gather.reflection.ReflectionPlacer;
import lightning.render.gather.rim.RimCells;
import lightning.render.gather.rim.RimLinks;
import lightning.render.image.Film;
import lightning.render.lobe.RoughLobes;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.HitRows.ColumnGroup;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.ShapeChange;
import lightning.render.trace.Tracer;
import lightning.render.trace.tree.BoxSet;
import lightning.scene.GatherSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/** Builds the {@link GatherStructure} of a scene on all threads. The result does not depend on their number or order. */
public final class GatherBuilder {
    /** Candidates along a side of the largest cell, seen straight on. */
    private static final int CANDIDATES_PER_CELL = 4;
    /** The same with blurred reflections, whose cells may be smaller. */
    private static final int REFLECTION_CANDIDATES_PER_CELL = 8;
    /** Usual shares of the time after the candidates and the rays of gather points. */
    private static final double CANDIDATES_SHARE = 0.1;
    private static final double POINTS_SHARE = 0.5;
    /** Usual share after the surfels, if additional rays follow. */
    private static final double SURFELS_SHARE = 0.9;

    /** Bytes of a surfel's key, seed, place and normal, and of its light while it is solved. */
    private static final int BYTES_BESIDE_ROW = 160;
    /** Bytes of the layer of an ordinary light at a surfel that it reaches. */
    private static final long BYTES_PER_LIGHT = 12;
    /** Bytes of its highlights there. */
    private static final long HIGHLIGHT_BYTES = 8;

    private final Geometry geometry;
    private final Scene scene;
    private final GatherSettings settings;
    private final WorkerPool workers;
    private final Progress progress;
    private final Tracer[] tracers;
    private final CellKeys keys;
    private final GlowShapes glows;
    private final ReflectionDirections reflectionDirections;
    /** Objects that a picture shows glowing, for reflections. */
    private final GlowShapes seenGlows;
    /** By material. */
    private final @Nullable RoughLobes[] lobes;
    /** Paths before an edit. */
    private @Nullable GatherStructure before;
    private @Nullable PathMemo memo;
    private @Nullable IntFunction<Tracer> memoTracers;
    private @Nullable ReflectionMemo reflectionMemo;
    private @Nullable KnownSurfels knownSurfels;
    private final long memoryBytes;

    /**
     * @param tracers     one for each thread
     * @param memoryBytes bytes that the paths may use
     */
    public GatherBuilder(Geometry geometry, Scene scene, GatherSettings settings, WorkerPool workers, IntFunction<Tracer> tracers,
            long memoryBytes, Progress progress) {
        this.memoryBytes = memoryBytes;
        this.geometry = geometry;
        this.scene = scene;
        this.settings = settings;
        this.workers = workers;
        this.progress = progress;
        this.tracers = new Tracer[workers.count()];
        Arrays.setAll(this.tracers, tracers);
        GatherStructure.Metadata metadata = GatherStructure.Metadata.of(geometry, scene, settings);
        keys = metadata.keys();
        lobes = new RoughLobes[geometry.materials().count()];
        Arrays.setAll(lobes, m -> RoughLobes.of(geometry.materials().material(m)));
        reflectionDirections = ReflectionDirections.of(settings.reflections() ? settings.reflectionRaysPerSide() : 2);
        seenGlows = metadata.seen();
        glows = metadata.shapes();
    }

    /**
     * Uses the paths before an edit, if few enough objects changed; rays of blurred reflections only if no object was added or removed. The
     * structure then contains no rows of surfels that stay.
     *
     * @param old      paths of a picture with the same camera, size and settings
     * @param rows     rows of its surfels
     * @param previous geometry before the edit
     * @param shapes   edit of the shapes
     * @param itsTracers one for each thread, of that geometry
     */
    public void remember(GatherStructure old, HitRows[] rows, Geometry previous, ShapeChange shapes,
            IntFunction<Tracer> itsTracers) {
        boolean keepsReflections = settings.reflections() && shapes.hasSameIndices();
        if (!settings.gathers() && !keepsReflections || !haveSameTangents(previous.materials(), geometry.materials())) {
            return;
        }
        KnownSurfels known = KnownSurfels.of(old, rows, shapes, keys);
        if (settings.gathers()) {
            before = old;
            memo = PathMemo.of(old, known, previous, shapes, geometry, keys);
            memoTracers = itsTracers;
        }
        if (keepsReflections) {
            // Without an edit of shapes the memo itself knows which materials changed.
            BoxSet changes = shapes == ShapeChange.NONE ? BoxSet.NONE : PathChanges.of(previous, shapes, geometry, true);
            reflectionMemo = changes == null ? null
                    : ReflectionMemo.of(old.reflections(), known.keys(), changes, shapes, previous.materials(), geometry.materials(),
                            seenGlows);
        }
        knownSurfels = memo == null && reflectionMemo == null ? null : known;
    }

    /** Returns whether rows of surfels have tangents for the same materials. */
    private static boolean haveSameTangents(MaterialTable a, MaterialTable b) {
        return IntStream.range(0, Math.min(a.count(), b.count()))
                .allMatch(m -> a.material(m).isAnisotropic() == b.material(m).isAnisotropic());
    }

    /** Returns the distance of the pixels through which candidates for gather points are traced. */
    public static int candidateStep(GatherSettings settings, PictureSettings picture) {
        int perCell = settings.reflections() ? REFLECTION_CANDIDATES_PER_CELL : CANDIDATES_PER_CELL;
        return Math.max(1, (int) (settings.pixelSpacing(picture) / perCell));
    }

    /** Returns the maximum number of rays of a reflection point with its copies. */
    public static int maxReflectedRays(GatherSettings settings) {
        return ReflectionFilter.ENOUGH
                * (settings.reflectionRaysPerSide() * settings.reflectionRaysPerSide() + ReflectionCaster.MAX_AIMED);
    }

    /** Returns the maximum bytes of a surfel without rays: its row, its cell, and what lights and solving need. */
    private long surfelBytes() {
        int columns =
                ColumnGroup.HIT.bytesPerRow() + geometry.materials().anyTexels().bytesPerRow() + ColumnGroup.OWNER.bytesPerRow()
                        + ColumnGroup.TRANSPARENT.bytesPerRow();
        return columns + BYTES_BESIDE_ROW
                + (BYTES_PER_LIGHT + (settings.reflections() ? HIGHLIGHT_BYTES : 0)) * scene.rig().effectiveLights().size();
    }

    /**
     * Builds it.
     *
     * @throws lightning.render.gather.ray.PathsTooLargeException if the paths need more memory than there is
     * @throws java.util.concurrent.CancellationException if the progress requested cancellation
     */
    public GatherStructure build() {
        CandidateTracer[] candidateTracers = new CandidateTracer[workers.count()];
        Arrays.setAll(candidateTracers,
                worker -> new CandidateTracer(geometry, scene, tracers[worker], candidateStep(settings, scene.picture())));
        List<SeenSurfaces> candidates = traceCandidates(candidateTracers);
        PathMemory memory = new PathMemory(settings, memoryBytes);
        DirectionTable directions = new DirectionTable(settings.raysPerSide());
        PathCaster pointCaster = caster(directions, memory, true);
        PointPlacer placer =
                new PointPlacer(workers, new ProgressPart(progress, CANDIDATES_SHARE, POINTS_SHARE), keys, pointCaster, memory);
        placer.place(settings.gathers() ? candidates.stream().map(level -> level.surfaces).toList() : List.of());
        ReflectionPlacer reflecting = settings.reflections() ? placeReflections(candidates, memory) : null;
        PathCaster surfelCaster = caster(new DirectionTable(settings.surfelRaysPerSide()), memory, false);
        double surfelsEnd = settings.environment() ? SURFELS_SHARE : 1;
        SurfelBuilder surfels =
                new SurfelBuilder(workers, new ProgressPart(progress, POINTS_SHARE, surfelsEnd), keys, surfelCaster, knownSurfels, memory,
                        surfelBytes(), glows);
        surfels.build(placer.sources, placer.links, pointCaster, reflecting, settings.pathBounces());
        RimCaster rimCaster = new RimCaster(keys, directions, glows, placer.sources, placer.links, surfels.cells(), memo);
        RimLinks rims = settings.environment() ? castThroughRims(rimCaster, placer, memory) : RimLinks.none();
        GatherPoints known = memo == null ? null : memo.samePoints(placer.sources);
        PointGroups groups = known == null ? new PointGroups(placer.points, placer.radius) : known.groups();
        Barriers barriers = known != null ? known.barriers()
                : Barriers.of(placer.sources, placer.radius, placer.links, surfels.surfels(), geometry, directions, workers, progress);
        PointFilter filter = known != null ? known.filter()
                : new FilterBuilder(placer.points, placer.radius, groups, barriers, placer.harmonic, placer.side).build(workers, progress);
        var rays = new GatherRays(Arrays.stream(candidateTracers).mapToLong(CandidateTracer::rayCount).sum(),
                pointCaster.rayCount() + rimCaster.rayCount(), reflecting == null ? 0 : reflecting.rayCount(),
                Arrays.stream(surfels.blocks).mapToLong(block -> block.count).sum(), surfels.bounceRays);
        placer.sources.packNormals();
        return new GatherStructure(
                new GatherPoints(placer.sources, placer.inverseLengths, placer.radius, groups, barriers, filter),
                placer.links, rims, surfels.links, new SurfelRows(surfels.blocks, surfels.numbers, surfels.near, surfels.count()),
                surfels.packNormals(), new GlowPaths(glows, pointCaster.glowLinks(), surfelCaster.glowLinks(), surfels.glowing),
                surfels.kept, reflecting == null ? null : reflections(reflecting, surfels), settings.isIndirect(), settings.pathBounces(),
                rays);
    }

    private ReflectionCaster[] reflectionCasters() {
        ReflectionCaster[] casters = new ReflectionCaster[tracers.length];
        Arrays.setAll(casters,
                worker -> new ReflectionCaster(geometry, scene, tracers[worker], keys, reflectionDirections, lobes, seenGlows));
        return casters;
    }

    private ReflectionPlacer placeReflections(List<SeenSurfaces> candidates, PathMemory memory) {
        ReflectionPlacer reflecting =
                new ReflectionPlacer(workers, new ProgressPart(progress, POINTS_SHARE, POINTS_SHARE), keys, reflectionCasters(),
                        lobes, geometry.primitives().material, ReflectionCaster.raysPerPoint(reflectionDirections, seenGlows),
                        reflectionDirections.rays,
                        memory, reflectionMemo);
        reflecting.place(candidates, IntStream.range(0, lobes.length).mapToObj(geometry.materials()::material).toList());
        return reflecting;
    }

    private ReflectionPaths reflections(ReflectionPlacer reflecting, SurfelBuilder surfels) {
        return reflecting.paths(seenGlows, surfels.surfelOfDetail,
                SurfelFilter.build(surfels.surfels(), surfels.links.points(), keys, workers, progress), surfels.firstRay, surfels.partKeys);
    }

    /**
     * Returns the difference between the gather points of the paths before an edit and those after it; null if they are not used.
     *
     * @param after paths after the edit
     */
    public @Nullable PointChanges changes(GatherStructure after) {
        return memo == null || before == null ? null : PointChanges.between(before, after, memo.points());
    }

    private RimLinks castThroughRims(RimCaster caster, PointPlacer placer, PathMemory memory) {
        Progress part = new ProgressPart(progress, SURFELS_SHARE, 1);
        RimCells rims = new RimCells(keys, placer.points, placer.links, workers, part.cancellationOnly());
        return caster.cast(rims, geometry, scene, tracers, workers, memory, part);
    }

    private PathCaster caster(DirectionTable directions, PathMemory memory, boolean ofPoints) {
        return new PathCaster(geometry, scene, workers, tracers, memo, memoTracers, keys, directions, glows, memory, ofPoints);
    }

    private List<SeenSurfaces> traceCandidates(CandidateTracer[] candidateTracers) {
        PictureSettings picture = scene.picture();
        int tilesX = Film.tilesAlong(picture.width());
        @SuppressWarnings("unchecked")
        List<SeenSurfaces>[] levels = (List<SeenSurfaces>[]) new List<?>[tilesX * Film.tilesAlong(picture.height())];
        workers.run(levels.length,
                (worker, tile) -> levels[tile] =
                        candidateTracers[worker].trace(tile % tilesX * Film.TILE_SIZE, tile / tilesX * Film.TILE_SIZE),
                new ProgressPart(progress, 0, CANDIDATES_SHARE));
        List<SeenSurfaces> all = new ArrayList<>();
        for (List<SeenSurfaces> tile : levels) {
            all.addAll(tile);
        }
        return all;
    }
}
