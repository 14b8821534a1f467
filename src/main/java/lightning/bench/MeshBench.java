package lightning.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import lightning.base.work.Progress;
import lightning.bench.mesh.BumpySphere;
import lightning.bench.mesh.Embree;
import lightning.bench.mesh.LaneMeshTracer;
import lightning.bench.mesh.RaySet;
import lightning.bench.mesh.RaySetGenerator;
import lightning.bench.result.MeshPoint;
import lightning.bench.result.RayThroughput;
import lightning.bench.result.TimeSamples;
import lightning.render.measure.Timing;
import lightning.render.trace.mesh.MeshSolid;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/**
 * Benchmark of ray throughput on generated meshes of up to ten million triangles, in turns with Embree if installed: same mesh, same rays,
 * one thread.
 */
record MeshBench(BenchSettings settings, ResultCollector ledger) {
    /** Predicted milliseconds per triangle and sample, and per ray. */
    private static final double TRIANGLE_MS = 1.5e-3;
    private static final double RAY_MS = 1e-3;
    private static final int WARM_UP = 3;

    /** Returns the parts, one per mesh. */
    List<BenchPart> parts() {
        List<Integer> counts = settings.quick() ? List.of(10_000) : List.of(100_000, 1_000_000, 10_000_000);
        return counts.stream().map(this::part).toList();
    }

    private BenchPart part(int triangles) {
        PictureSize size = settings.quick() ? new PictureSize(160, 120) : new PictureSize(1920, 1080);
        String title = "mesh of " + triangles + " triangles";
        double predictedMs = settings.repetitions() * (TRIANGLE_MS * triangles + RAY_MS * size.pixels());
        return BenchPart.ofProgram(title, predictedMs, ledger, progress -> {
            try (Embree embree = settings.peers() ? Embree.start().orElse(null) : null) {
                ledger.addMesh(measure(triangles, size, embree, progress));
            }
        });
    }

    private MeshPoint measure(int triangles, PictureSize size, @Nullable Embree embree, Progress progress) throws IOException {
        Mesh mesh = BumpySphere.of(triangles);
        List<Double> ourMs = new ArrayList<>();
        List<Double> rivalMs = new ArrayList<>();
        long bytes = 0;
        if (embree != null) {
            embree.setMesh(mesh);
        }
        for (int i = settings.isWarm() ? -1 : 0; i < settings.repetitions(); i++) {
            progress.checkCanceled("canceled while measuring meshes");
            double ms = timedTree(mesh);
            Embree.TreeBuild tree = embree == null ? null : embree.build(settings.threads());
            if (i >= 0) {
                ourMs.add(ms);
            }
            if (i >= 0 && tree != null) {
                rivalMs.add(tree.ms());
                bytes = tree.bytes();
            }
        }
        MeshSolid solid = new MeshSolid(mesh);
        double triangleCount = mesh.triangleCount();
        return new MeshPoint(mesh.triangleCount(),
                (double) (Float.BYTES * (long) mesh.positions().length + Integer.BYTES * (long) mesh.triangles().length) / triangleCount,
                solid.treeBytes() / triangleCount, TimeSamples.of(new Timing(ourMs)), rays(solid, size, embree, progress),
                embree == null ? null : new MeshPoint.Rival(Embree.PROGRAM, bytes / triangleCount, TimeSamples.of(new Timing(rivalMs))));
    }

    private static double timedTree(Mesh mesh) {
        long start = System.nanoTime();
        MeshSolid.withUnsharedTree(mesh);
        return (System.nanoTime() - start) / 1e6;
    }

    private List<RayThroughput> rays(MeshSolid solid, PictureSize size, @Nullable Embree embree, Progress progress) throws IOException {
        RaySetGenerator sets = new RaySetGenerator(solid, size.width(), size.height());
        List<RayThroughput> throughputs = new ArrayList<>();
        for (RaySet.Kind kind : RaySet.Kind.values()) {
            throughputs.add(throughput(sets.of(kind), new LaneMeshTracer(solid), embree, progress));
            progress.report(throughputs.size(), RaySet.Kind.values().length);
        }
        return throughputs;
    }

    private RayThroughput throughput(RaySet set, LaneMeshTracer tracer, @Nullable Embree embree, Progress progress) throws IOException {
        List<Double> ourMs = new ArrayList<>();
        List<Double> rivalMs = new ArrayList<>();
        if (embree != null) {
            embree.setRays(set);
        }
        for (int i = settings.isWarm() ? -WARM_UP : 0; i < settings.repetitions(); i++) {
            progress.checkCanceled("canceled while measuring meshes");
            double ms = tracer.traceMs(set);
            Embree.TraceResult rivalTrace = embree == null ? null : embree.trace(set.kind());
            if (i >= 0) {
                ourMs.add(ms);
            }
            if (i >= 0 && rivalTrace != null) {
                rivalMs.add(rivalTrace.ms());
            }
        }
        TimeSamples time = TimeSamples.of(new Timing(ourMs));
        TimeSamples rival = embree == null ? null : TimeSamples.of(new Timing(rivalMs));
        return new RayThroughput(set.kind().label(), set.count(), time, rival,
                rival == null ? Double.NaN : 100 * rival.median() / time.median());
    }
}
