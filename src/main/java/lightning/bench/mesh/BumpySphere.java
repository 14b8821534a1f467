package lightning.bench.mesh;

import lightning.scene.node.Mesh;

/** Generator of unit spheres with bumps of many sizes and any number of triangles: a cube's six grids, projected to the sphere. */
public final class BumpySphere {
    private static final int SIDES = 6;
    /** Number of bump sizes, each half the previous one. */
    private static final int OCTAVES = 6;
    private static final double MAX_BUMP_HEIGHT = 0.06;

    private BumpySphere() {}

    /** @param triangles at least 12; the result has up to about √triangles·7 more or fewer */
    public static Mesh of(int triangles) {
        int n = Math.max(1, (int) Math.round(Math.sqrt(triangles / 12.0)));
        int grid = (n + 1) * (n + 1);
        float[] position = new float[3 * SIDES * grid];
        int[] triangle = new int[3 * SIDES * 2 * n * n];
        int at = 0;
        for (int side = 0; side < SIDES; side++) {
            for (int i = 0; i < grid; i++) {
                putVertex(side, angle(i % (n + 1), n), angle(i / (n + 1), n), position, 3 * (side * grid + i));
            }
            for (int row = 0; row < n; row++) {
                for (int column = 0; column < n; column++) {
                    int a = side * grid + row * (n + 1) + column;
                    int c = a + n + 1;
                    for (int v : new int[] {a, a + 1, c, a + 1, c + 1, c}) {
                        triangle[at++] = v;
                    }
                }
            }
        }
        return new Mesh(position, triangle, null, null, null);
    }

    /** Returns grid angles: equal steps give cells of similar size, and exact ends avoid cracks between grids. */
    private static double angle(int i, int n) {
        return i == 0 ? -1 : i == n ? 1 : Math.tan(Math.PI / 4 * (2.0 * i / n - 1));
    }

    private static void putVertex(int side, double u, double v, float[] to, int at) {
        double[] p = new double[3];
        p[side % 3] = side < 3 ? 1 : -1;
        p[(side + 1) % 3] = u;
        p[(side + 2) % 3] = v;
        double length = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        double radius = 1;
        double height = MAX_BUMP_HEIGHT;
        double frequency = 5 / length;
        for (int o = 0; o < OCTAVES; o++) {
            radius += height * Math.sin(frequency * p[0] + o) * Math.sin(frequency * p[1] + 2 * o) * Math.sin(frequency * p[2] + 3 * o);
            height /= 2;
            frequency *= 2;
        }
        for (int k = 0; k < 3; k++) {
            to[at + k] = (float) (radius * p[k] / length);
        }
    }
}
