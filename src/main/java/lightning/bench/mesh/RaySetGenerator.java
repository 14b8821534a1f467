package lightning.bench.mesh;

import lightning.render.trace.mesh.MeshRayQuery;
import lightning.render.trace.mesh.MeshSolid;
import lightning.scene.node.Mesh;

/** Generator of ray sets for a mesh around the origin: eye rays, and secondary rays from their hits. */
public final class RaySetGenerator {
    private static final double[] EYE = {0.6, 0.5, 2.6};
    private static final double[] LIGHT = {2.5, 4, 2};
    /** Half the image height at distance 1. */
    private static final double HALF_HEIGHT = 0.42;
    private static final int SQUARE = 8;
    /** Offset of secondary rays from the surface, relative to a mesh size of about 1. */
    private static final double SURFACE_OFFSET = 1e-4;
    /**
     * Steps per unit of the points on the surface: floats hold the difference of point and light without rounding, so shadow rays
     * end exactly at the light, as those of a renderer with more precise numbers do.
     */
    private static final double POINT_STEPS = 0x1p20;

    private final Mesh mesh;
    private final RaySet eyeRays;
    /** Per eye hit: the point in front of the surface, and the mirrored eye ray. */
    private final float[][] mirroredRays = new float[6][];
    private final int hitCount;

    /** @param width width of the image and, with {@code height}, a multiple of 8 */
    public RaySetGenerator(MeshSolid solid, int width, int height) {
        mesh = solid.mesh();
        eyeRays = eyeRays(width, height);
        for (int k = 0; k < 6; k++) {
            mirroredRays[k] = new float[eyeRays.count()];
        }
        MeshRayQuery probe = new MeshRayQuery();
        int n = 0;
        for (int i = 0; i < eyeRays.count(); i++) {
            probe.setRay(solid, eyeRays.columns()[0][i], eyeRays.columns()[1][i], eyeRays.columns()[2][i], eyeRays.columns()[3][i],
                    eyeRays.columns()[4][i],
                    eyeRays.columns()[5][i]);
            double t = probe.nearest(Double.POSITIVE_INFINITY);
            if (t < Double.POSITIVE_INFINITY) {
                addHit(i, t, probe.triangle(), n++);
            }
        }
        hitCount = n / RaySet.PACKET * RaySet.PACKET;
    }

    private static RaySet eyeRays(int width, int height) {
        double length = Math.sqrt(dot(EYE, EYE));
        double[] forward = {-EYE[0] / length, -EYE[1] / length, -EYE[2] / length};
        double flat = Math.hypot(forward[0], forward[2]);
        double[] right = {-forward[2] / flat, 0, forward[0] / flat};
        double[] up = cross(right, forward);
        double pixel = 2 * HALF_HEIGHT / height;
        float[][] c = new float[6][width * height];
        for (int i = 0; i < width * height; i++) {
            int square = i / (SQUARE * SQUARE);
            // Quarter of a square, and position in it.
            int x = square % (width / SQUARE) * SQUARE + 4 * (i >> 4 & 1) + (i & 3);
            int y = square / (width / SQUARE) * SQUARE + 4 * (i >> 5 & 1) + (i >> 2 & 3);
            for (int k = 0; k < 3; k++) {
                c[k][i] = (float) EYE[k];
                c[3 + k][i] = (float) (forward[k] + (x - width / 2 + 0.5) * pixel * right[k] - (y - height / 2 + 0.5) * pixel * up[k]);
            }
        }
        return new RaySet(RaySet.Kind.EYE, width * height, c);
    }

    private void addHit(int ray, double t, int triangle, int n) {
        double[] d = {eyeRays.columns()[3][ray], eyeRays.columns()[4][ray], eyeRays.columns()[5][ray]};
        float[] p = mesh.positions();
        int a = 3 * mesh.triangles()[3 * triangle];
        int b = 3 * mesh.triangles()[3 * triangle + 1];
        int c = 3 * mesh.triangles()[3 * triangle + 2];
        double[] normal = cross(new double[] {p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]},
                new double[] {p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]});
        double length = Math.sqrt(dot(normal, normal));
        double cosine = dot(normal, d) / length;
        for (int k = 0; k < 3; k++) {
            double unit = normal[k] / length;
            double x = EYE[k] + t * d[k] - Math.signum(cosine) * SURFACE_OFFSET * unit;
            mirroredRays[k][n] = (float) (Math.rint(x * POINT_STEPS) / POINT_STEPS);
            mirroredRays[3 + k][n] = (float) (d[k] - 2 * cosine * unit);
        }
    }

    /** Returns the rays of a kind. */
    public RaySet of(RaySet.Kind kind) {
        return switch (kind) {
            case EYE -> eyeRays;
            case MIRRORED -> new RaySet(kind, hitCount, mirroredRays);
            case SHADOW -> raysFromHits(kind, (i, k) -> (float) (LIGHT[k] - mirroredRays[k][i]));
            case SINGLE -> raysFromHits(kind, RaySetGenerator::pseudoRandom);
        };
    }

    private interface Direction {
        float of(int ray, int axis);
    }

    private RaySet raysFromHits(RaySet.Kind kind, Direction direction) {
        float[][] c = {mirroredRays[0], mirroredRays[1], mirroredRays[2], new float[hitCount], new float[hitCount], new float[hitCount]};
        for (int i = 0; i < hitCount; i++) {
            for (int k = 0; k < 3; k++) {
                c[3 + k][i] = direction.of(i, k);
            }
        }
        return new RaySet(kind, hitCount, c);
    }

    /** Returns a pseudo-random number from −1 to 1, never 0. */
    private static float pseudoRandom(int ray, int axis) {
        int h = (3 * ray + axis) * 0x9E3779B1;
        h = (h ^ h >>> 15) * 0x85EBCA6B;
        return ((h >>> 8 & 1023) - 511.5f) / 512;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
}
