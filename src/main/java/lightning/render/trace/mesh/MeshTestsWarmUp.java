package lightning.render.trace.mesh;

import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import lightning.scene.node.Mesh;

/**
 * Warm-up of {@link SingleRayLanes}: traces rays through a small mesh with loops and lanes in turn, on the calling thread only, until the lanes were
 * faster several times in a row. Only then the process uses them. It takes about a second of one processor. If the lanes stay slower, it gives up
 * after {@value #MAX_SECONDS} seconds.
 */
public final class MeshTestsWarmUp {
    private static final int TRIANGLES = 2000;
    private static final int RAYS = 256;
    private static final int REQUIRED_WINS = 4;
    private static final long MAX_SECONDS = 10;

    private final MeshSolid solid = new MeshSolid(mesh());
    private final double[][] rays = rays();

    private MeshTestsWarmUp() {}

    /**
     * Turns the lanes on once they are compiled; does nothing if they are on.
     *
     * @param isCanceled whether to stop; code compiled by then stays compiled
     */
    public static void run(BooleanSupplier isCanceled) {
        if (MeshTests.current() == MeshTests.LOOPS && new MeshTestsWarmUp().areLanesFaster(isCanceled)) {
            MeshTests.use(SingleRayLanes::new);
        }
    }

    private boolean areLanesFaster(BooleanSupplier isCanceled) {
        long start = System.nanoTime();
        int wins = 0;
        var loops = new MeshRayQuery(MeshTests.LOOPS);
        var lanes = new MeshRayQuery(SingleRayLanes::new);
        while (wins < REQUIRED_WINS) {
            if (isCanceled.getAsBoolean() || System.nanoTime() - start > TimeUnit.SECONDS.toNanos(MAX_SECONDS)) {
                return false;
            }
            wins = nanoseconds(lanes) < nanoseconds(loops) ? wins + 1 : 0;
        }
        return true;
    }

    private long nanoseconds(MeshRayQuery query) {
        long start = System.nanoTime();
        for (double[] r : rays) {
            query.setRay(solid, r[0], r[1], r[2], r[3], r[4], r[5]);
            query.nearest(MeshRay.MISS);
        }
        return System.nanoTime() - start;
    }

    private static Mesh mesh() {
        var random = new Random(1);
        float[] positions = new float[9 * TRIANGLES];
        int[] triangles = new int[3 * TRIANGLES];
        for (int i = 0; i < positions.length; i += 9) {
            for (int a = 0; a < 3; a++) {
                float center = random.nextFloat();
                for (int v = 0; v < 3; v++) {
                    positions[i + 3 * v + a] = center + 0.05f * random.nextFloat();
                }
            }
        }
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = i;
        }
        return new Mesh(positions, triangles, null, null, null);
    }

    private static double[][] rays() {
        var random = new Random(2);
        double[][] rays = new double[RAYS][6];
        for (double[] ray : rays) {
            for (int a = 0; a < 3; a++) {
                ray[a] = random.nextDouble();
                ray[3 + a] = random.nextGaussian();
            }
        }
        return rays;
    }
}
