package lightning.bench.mesh;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.util.Random;
import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.mesh.MeshSolid;
import lightning.scene.node.Mesh;
import org.junit.jupiter.api.Test;

/** Comparison with Embree, if installed; {@code -Dlightning.embree=1000000} sets the number of rays. */
class EmbreeTest {
    /**
     * Embree moves vertices to the ray's origin and computes edge signs in floats, v = 2⁻²⁴. Each coordinate is off by v·(|o| + r), and
     * differences of products correspond to a ray moved by less than 8v·(|o| + r). This is four times as much.
     */
    private static final double TOLERANCE_SCALE = 0x1p-19;
    /** Number of moved rays to try: near a protruding vertex, only a thin wedge of them misses. */
    private static final int RAY_COUNT = 5000;

    private final Random random = new Random(1);
    private final Mesh mesh = BumpySphere.of(20_000);
    private final MeshRayQuery probe = new MeshRayQuery();
    private final MeshSolid solid = new MeshSolid(mesh);

    @Test
    void embree_agreesExceptForFloatRounding() throws Exception {
        assumeTrue(Embree.isInstalled(), "Embree or a C compiler is not installed");
        RaySet rays = rays(Integer.getInteger("lightning.embree", 100_000) / RaySet.PACKET * RaySet.PACKET);
        float[] distance = new float[rays.count()];
        int[] triangle = new int[rays.count()];
        try (Embree embree = Embree.start().orElseThrow()) {
            embree.setMesh(mesh);
            embree.build(1);
            embree.setRays(rays);
            embree.nearest(distance, triangle);
        }
        int unlike = 0;
        int hits = 0;
        for (int i = 0; i < rays.count(); i++) {
            double[] ray = ray(rays, i);
            double t = nearest(ray);
            hits += t < Double.POSITIVE_INFINITY ? 1 : 0;
            unlike += isNear(t, distance[i], ray) || isExplained(ray, t, distance[i], triangle[i]) ? 0 : 1;
        }
        assertThat(hits).isGreaterThan(rays.count() / 4);
        assertThat(unlike).as("of %s rays", rays.count()).isZero();
    }

    /** Returns random rays, and rays just above a vertex, at vertices, and at points of edges. */
    private RaySet rays(int count) {
        float[][] c = new float[6][count];
        for (int i = 0; i < count; i++) {
            int corner = 3 * random.nextInt(mesh.triangleCount());
            double share = i % 4 == 3 ? random.nextDouble() : 0;
            double[] to = new double[3];
            double[] from = new double[3];
            for (int k = 0; k < 3; k++) {
                float a = mesh.positions()[3 * mesh.triangles()[corner] + k];
                to[k] = i % 4 == 0 ? 0.8 * random.nextGaussian()
                        : (1 - share) * a + share * mesh.positions()[3 * mesh.triangles()[corner + 1] + k];
                from[k] = 2 * random.nextGaussian();
            }
            if (i % 4 == 1) {
                // Perpendicular to the vertex's direction, seen from the center.
                double along = (from[0] * to[0] + from[1] * to[1] + from[2] * to[2]) / (to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
                for (int k = 0; k < 3; k++) {
                    from[k] += (1 - along) * to[k];
                }
            }
            for (int k = 0; k < 3; k++) {
                c[k][i] = (float) from[k];
                c[3 + k][i] = (float) (to[k] - from[k]);
            }
        }
        return new RaySet(RaySet.Kind.SINGLE, count, c);
    }

    private static double[] ray(RaySet rays, int i) {
        double[] ray = new double[6];
        for (int k = 0; k < 6; k++) {
            ray[k] = rays.columns()[k][i];
        }
        return ray;
    }

    private double nearest(double[] r) {
        probe.setRay(solid, r[0], r[1], r[2], r[3], r[4], r[5]);
        return probe.nearest(Double.POSITIVE_INFINITY);
    }

    private static double margin(double[] ray) {
        return TOLERANCE_SCALE * (1.5 + Math.max(Math.abs(ray[0]), Math.max(Math.abs(ray[1]), Math.abs(ray[2]))));
    }

    private static boolean isNear(double a, double b, double[] ray) {
        double length = Math.sqrt(ray[3] * ray[3] + ray[4] * ray[4] + ray[5] * ray[5]);
        return a == b || Math.abs(a - b) * length <= margin(ray);
    }

    /**
     * Returns whether Embree's point is on its triangle, within float accuracy. If Embree misses our hit, tests if some ray moved by that error
     * misses it too.
     */
    private boolean isExplained(double[] ray, double ours, double theirs, int triangle) {
        if (triangle >= 0 && !isOnTriangle(ray, theirs, triangle)) {
            return false;
        }
        boolean passes = theirs <= ours;
        for (int n = 0; n < RAY_COUNT && !passes; n++) {
            double[] moved = ray.clone();
            for (int k = 0; k < 3; k++) {
                moved[k] += margin(ray) * (2 * random.nextDouble() - 1);
            }
            double t = nearest(moved);
            passes = t > ours && !isNear(t, ours, ray);
        }
        return passes;
    }

    /**
     * Returns whether the point at a distance is off a triangle by at most the margin, which grows with the slant of the ray. The slant itself has
     * an error of the margin relative to the triangle's smallest height.
     */
    private boolean isOnTriangle(double[] ray, double distance, int triangle) {
        double[] e = side(triangle, 1);
        double[] f = side(triangle, 2);
        double[] n = {e[1] * f[2] - e[2] * f[1], e[2] * f[0] - e[0] * f[2], e[0] * f[1] - e[1] * f[0]};
        double longest =
                Math.max(length(e[0], e[1], e[2]), Math.max(length(f[0], f[1], f[2]), length(f[0] - e[0], f[1] - e[1], f[2] - e[2])));
        double least = length(n[0], n[1], n[2]) / longest;
        double slant = Math.abs(n[0] * ray[3] + n[1] * ray[4] + n[2] * ray[5]) / length(n[0], n[1], n[2]) / length(ray[3], ray[4], ray[5]);
        double gap = singleTriangle(triangle).surfaceDistance(ray[0] + distance * ray[3], ray[1] + distance * ray[4],
                ray[2] + distance * ray[5]);
        return slant <= margin(ray) / least || gap <= margin(ray) / (slant - margin(ray) / least);
    }

    private double[] side(int triangle, int to) {
        double[] side = new double[3];
        for (int k = 0; k < 3; k++) {
            side[k] = (double) mesh.positions()[3 * mesh.triangles()[3 * triangle + to] + k]
                    - mesh.positions()[3 * mesh.triangles()[3 * triangle] + k];
        }
        return side;
    }

    private static double length(double x, double y, double z) {
        return Math.sqrt(x * x + y * y + z * z);
    }

    private MeshSolid singleTriangle(int triangle) {
        float[] p = new float[9];
        for (int v = 0; v < 3; v++) {
            System.arraycopy(mesh.positions(), 3 * mesh.triangles()[3 * triangle + v], p, 3 * v, 3);
        }
        return new MeshSolid(new Mesh(p, new int[] {0, 1, 2}, null, null, null));
    }
}
