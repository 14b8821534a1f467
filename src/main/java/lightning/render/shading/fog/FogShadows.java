package lightning.render.shading.fog;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.base.work.ProgressPart;
import lightning.base.work.WorkerPool;
import lightning.render.engine.EngineChoice;
import lightning.render.engine.EngineWorkers;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogPath;
import lightning.render.fog.FogRay;
import lightning.render.fog.FogRays;
import lightning.render.shading.LightSource;
import lightning.render.shading.RayCounts;
import lightning.render.shading.layer.LightRows;
import lightning.render.shading.layer.PointShadows;
import lightning.render.shading.layer.RowBits;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.ShapeChange;
import lightning.scene.effects.ViewEffects;
import org.jspecify.annotations.Nullable;

/** Finds the samples of fog that a light reaches, on all threads. */
public final class FogShadows {
    private final FogRays rays;
    private final WorkerPool workers;
    private final List<EngineWorkers<PointShadows>> casters;
    private final ProgressPart progress;
    private final int lights;
    private final Group[] groups;

    /**
     * @param view   its effects decide whether shapes block light
     * @param lights number of lights; each has an equal part of the progress
     */
    public FogShadows(FogRays rays, Geometry geometry, ViewEffects view, EngineChoice engines, WorkerPool workers, int lights,
            ProgressPart progress) {
        this.rays = rays;
        this.lights = lights;
        this.workers = workers;
        casters = EngineWorkers.perThread(workers.count(), engines,
                engine -> new PointShadows(geometry, engine.tracer(geometry), view));
        this.progress = progress;
        groups = new Group[workers.count()];
        Arrays.setAll(groups, _ -> new Group());
    }

    /** Returns the samples that see light number {@code l}, one bit each: {@code int[rays]}. */
    public int[] visible(int l, LightSource source) {
        int[] visible = new int[rays.count()];
        test(l, source, visible, null);
        return visible;
    }

    /**
     * Returns the samples that see light number {@code l} after a change, one bit each: {@code int[rays]}.
     *
     * @param before  samples that saw it before; not modified
     * @param unknown rays of which all samples must be tested, because they were others before
     * @param change  change of the shapes since then
     */
    public int[] visibleAfter(int l, LightSource source, int[] before, BitSet unknown, ShapeChange change) {
        int[] visible = before.clone();
        test(l, source, visible, new Change(unknown, change));
        return visible;
    }

    /** Change of rays and shapes since samples were tested. */
    private record Change(BitSet unknown, ShapeChange shapes) {}

    /** @param change null if all samples must be tested */
    private void test(int l, LightSource source, int[] visible, @Nullable Change change) {
        FogSamples samples = new FogSamples(rays.grid().scale(), source);
        workers.run(rays.groupCount(), (worker, i) -> groups[worker].test(i, samples, casters.get(worker).forTile(i), change, visible),
                progress.section(l, lights));
    }

    /** Returns the shadow rays cast since the start. */
    public RayCounts rays() {
        return casters.stream().flatMap(thread -> thread.workers().stream()).map(caster -> RayCounts.ofShadows(caster.rayCount()))
                .reduce(RayCounts.NONE, RayCounts::plus);
    }

    /** Scratch memory for a group of rays: one shadow ray from each is cast together. */
    private final class Group {
        /** Path of each ray toward the present light. */
        private final FogPath[] paths = new FogPath[FogRays.GROUP];
        private final FogRay[] lines = new FogRay[FogRays.GROUP];
        private final int[] members = new int[FogRays.GROUP];
        /** Rays of the present points. */
        private final int[] point = new int[FogRays.GROUP];
        private final byte[] state = new byte[FogRays.GROUP];
        private final int[] chosen = RowBits.allocate();
        private final int[] blocked = RowBits.allocate();

        Group() {
            Arrays.setAll(paths, _ -> new FogPath());
            Arrays.setAll(lines, _ -> new FogRay());
        }

        void test(int group, FogSamples samples, PointShadows shadows, @Nullable Change change, int[] visible) {
            int count = rays.writeGroup(group, members);
            for (int i = 0; i < count; i++) {
                rays.set(members[i], lines[i]);
                samples.aim(paths[i], lines[i]);
            }
            for (int sample = 0; sample < FogGrid.SAMPLES && !progress.isCanceled(); sample++) {
                if (samples.isPoint()) {
                    test(count, sample, -1, samples, shadows, change, visible);
                } else {
                    for (int phase = 0; phase < FogGrid.PHASES; phase++) {
                        test(count, sample, phase, samples, shadows, change, visible);
                    }
                }
            }
        }

        /** @param only phase of the rays to test; negative for all */
        private void test(int count, int sample, int only, FogSamples samples, PointShadows shadows, @Nullable Change change,
                int[] visible) {
            HitRows points = shadows.points();
            points.clear();
            for (int i = 0; i < count; i++) {
                FogRay line = lines[i];
                if (only < 0 || line.phase == only) {
                    double t = paths[i].distance(FogGrid.place(sample, line.phase));
                    point[points.count] = members[i];
                    points.px[points.count] = (float) line.x(t);
                    points.py[points.count] = (float) line.y(t);
                    points.pz[points.count++] = (float) line.z(t);
                }
            }
            if (points.count == 0) {
                return;
            }
            LightSource source = samples.source(sample, Math.max(only, 0));
            Arrays.fill(chosen, 0);
            if (change == null) {
                RowBits.add(chosen, 0, points.count);
            } else if (!choose(points.count, sample, source, shadows, change, visible)) {
                return;
            }
            shadows.cast(source, chosen, blocked);
            for (int i = 0; i < points.count; i++) {
                if (RowBits.contains(chosen, i)) {
                    visible[point[i]] = visible[point[i]] & ~(1 << sample) | (RowBits.contains(blocked, i) ? 0 : 1 << sample);
                }
            }
        }

        /** Chooses the points that a change may affect; returns whether there are any. */
        private boolean choose(int count, int sample, LightSource source, PointShadows shadows, Change change, int[] visible) {
            for (int i = 0; i < count; i++) {
                state[i] = (byte) ((visible[point[i]] >>> sample & 1) != 0 ? LightRows.UNBLOCKED : LightRows.BLOCKED);
            }
            boolean any = !change.shapes.isEmpty() && shadows.findChanged(source, state, change.shapes, chosen);
            for (int i = 0; i < count && !change.unknown.isEmpty(); i++) {
                if (change.unknown.get(point[i])) {
                    RowBits.add(chosen, i);
                    any = true;
                }
            }
            return any;
        }
    }
}
