package lightning.bench;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import lightning.base.work.Progress;
import lightning.bench.accuracy.Timing;
import lightning.bench.mesh.BumpyBall;
import lightning.bench.mesh.Embree;
import lightning.bench.mesh.OwnSearch;
import lightning.bench.mesh.RaySet;
import lightning.bench.mesh.RaySets;
import lightning.render.trace.mesh.MeshSolid;
import lightning.scene.Mesh;

/**
 * Measures how fast rays are traced against generated meshes of up to ten million triangles, and Embree's in turns with it where that is
 * installed: the same mesh, the same rays, one thread.
 */
final class MeshBench {
    /** Milliseconds for each triangle and sample, and for each ray. */
    private static final double TRIANGLE_MS = 1.5e-3;
    private static final double RAY_MS = 1e-3;
    private static final int WARM_UP = 3;

    private final Settings settings;
    private final Ledger ledger;

    MeshBench(Settings settings, Ledger ledger) {
        this.settings = settings;
        this.ledger = ledger;
    }

    /** What is to be measured: a part for each mesh. */
    List<Part> parts() {
        List<Integer> counts = settings.quick() ? List.of(10_000) : List.of(100_000, 1_000_000, 10_000_000);
        return counts.stream().map(this::part).toList();
    }

    private Part part(int triangles) {
        PictureSize size = settings.quick() ? new PictureSize(160, 120) : new PictureSize(1920, 1080);
        String where = "a mesh of " + triangles + " triangles";
        double predictedMs = settings.repetitions() * (TRIANGLE_MS * triangles + RAY_MS * size.pixels());
        return new Part(where, predictedMs, progress -> {
            try (Embree embree = settings.peers() ? Embree.start().orElse(null) : null) {
                ledger.mesh(measure(triangles, size, embree, progress));
            } catch (IOException e) {
                ledger.problem(new Failure(Failure.Kind.UNMEASURED, where, e.getMessage()));
            }
        });
    }

    private MeshPoint measure(int triangles, PictureSize size, Embree embree, Progress progress) throws IOException {
        Mesh mesh = BumpyBall.of(triangles);
        List<Double> own = new ArrayList<>();
        List<Double> other = new ArrayList<>();
        long bytes = 0;
        if (embree != null) {
            embree.mesh(mesh);
        }
        for (int i = settings.isWarm() ? -1 : 0; i < settings.repetitions(); i++) {
            check(progress);
            double ms = timedTree(mesh);
            Embree.Tree tree = embree == null ? null : embree.build(settings.threads());
            if (i >= 0) {
                own.add(ms);
            }
            if (i >= 0 && tree != null) {
                other.add(tree.ms());
                bytes = tree.bytes();
            }
        }
        MeshSolid solid = new MeshSolid(mesh);
        double count = mesh.triangleCount();
        return new MeshPoint(mesh.triangleCount(),
                (double) (Float.BYTES * (long) mesh.positions().length + Integer.BYTES * (long) mesh.triangles().length) / count,
                solid.treeBytes() / count, Samples.of(new Timing(own)), rays(solid, size, embree, progress),
                embree == null ? null : new MeshPoint.Rival(Embree.PROGRAM, bytes / count, Samples.of(new Timing(other))));
    }

    private static double timedTree(Mesh mesh) {
        long start = System.nanoTime();
        MeshSolid.apart(mesh);
        return (System.nanoTime() - start) / 1e6;
    }

    private List<RayPace> rays(MeshSolid solid, PictureSize size, Embree embree, Progress progress) throws IOException {
        RaySets sets = new RaySets(solid, size.width(), size.height());
        List<RayPace> paces = new ArrayList<>();
        for (RaySet.Kind kind : RaySet.Kind.values()) {
            paces.add(pace(sets.of(kind), new OwnSearch(solid), embree, progress));
            progress.tiles(paces.size(), RaySet.Kind.values().length);
        }
        return paces;
    }

    private RayPace pace(RaySet set, OwnSearch search, Embree embree, Progress progress) throws IOException {
        List<Double> own = new ArrayList<>();
        List<Double> other = new ArrayList<>();
        if (embree != null) {
            embree.rays(set);
        }
        for (int i = settings.isWarm() ? -WARM_UP : 0; i < settings.repetitions(); i++) {
            check(progress);
            double ms = search.ms(set);
            Embree.Traced theirs = embree == null ? null : embree.trace(set.kind());
            if (i >= 0) {
                own.add(ms);
            }
            if (i >= 0 && theirs != null) {
                other.add(theirs.ms());
            }
        }
        Samples time = Samples.of(new Timing(own));
        Samples rival = embree == null ? null : Samples.of(new Timing(other));
        return new RayPace(set.kind().label(), set.count(), time, rival,
                rival == null ? Double.NaN : 100 * rival.median() / time.median());
    }

    private static void check(Progress progress) {
        if (progress.isCancelled()) {
            throw new CancellationException("cancelled while meshes were measured");
        }
    }
}
