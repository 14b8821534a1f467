package lightning.sample;

import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import lightning.scene.node.Mesh;
import lightning.scene.node.Solid;

/** Small meshes for tests: closed solids, smooth and flat, and degenerate triangle soups. */
public final class SampleMeshes {
    private SampleMeshes() {}

    /** Returns a few meshes of every kind. */
    public static List<Solid.TriangleMesh> samples() {
        return Stream.concat(Stream.of(solid(withVertexColors(ball(3, 5, true))).withShowsColors(false)),
                Stream.of(cube(), ball(3, 4, true), withVertexColors(ball(6, 9, false)), withTangents(ball(5, 8, true)), cone(7),
                        randomTriangles(40, 1),
                        withVertexColors(randomTriangles(9, 2)),
                        empty())
                        .map(SampleMeshes::solid))
                .toList();
    }

    /** Returns a mesh as if read from a file. */
    public static Solid.TriangleMesh solid(Mesh mesh) {
        return new Solid.TriangleMesh("m" + mesh.triangleCount() + "-" + mesh.vertexCount() + ".ply", "", mesh);
    }

    /** Returns the mesh with vertex colors, including black and white. */
    public static Mesh withVertexColors(Mesh m) {
        Random random = new Random(m.vertexCount());
        float[] colors = new float[3 * m.vertexCount()];
        for (int i = 0; i < colors.length; i++) {
            colors[i] = Math.clamp(random.nextFloat() * 1.5f - 0.25f, 0, 1);
        }
        return new Mesh(m.positions(), m.triangles(), m.normals(), m.coordinates(), colors);
    }

    /** Returns the mesh with vertex tangents in all directions, of both signs, some without one. */
    public static Mesh withTangents(Mesh m) {
        Random random = new Random(m.vertexCount());
        float[] tangents = new float[4 * m.vertexCount()];
        for (int v = 0; v < m.vertexCount(); v++) {
            double angle = random.nextDouble() * 2 * Math.PI;
            tangents[4 * v] = v % 5 == 0 ? 0 : (float) Math.cos(angle);
            tangents[4 * v + 1] = v % 5 == 0 ? 0 : (float) Math.sin(angle);
            tangents[4 * v + 3] = v % 2 * 2 - 1;
        }
        return new Mesh(m.positions(), m.triangles(), m.normals(), m.coordinates(), m.colors(), tangents);
    }

    public static Mesh empty() {
        return new Mesh(new float[] {0, 0, 0}, new int[0], null, null, null);
    }

    /** Returns the cube from −1 to 1, flat, with shared vertices and texture coordinates. */
    public static Mesh cube() {
        float[] p = new float[24];
        float[] c = new float[16];
        for (int v = 0; v < 8; v++) {
            for (int a = 0; a < 3; a++) {
                p[3 * v + a] = (v >> a & 1) * 2 - 1;
            }
            c[2 * v] = v & 1;
            c[2 * v + 1] = v >> 1 & 1;
        }
        int[] t = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
        return new Mesh(p, t, null, c, null);
    }

    /**
     * Returns the cube from −1 to 1 with beveled edges and corners. The normal of each vertex is the mean of the facets around it, whatever
     * their areas, so it leans from the large faces.
     *
     * @param bevel part of each side that is cut off, below 1
     */
    public static Mesh beveledCube(double bevel) {
        float[] p = new float[72];
        for (int v = 0; v < 24; v++) {
            for (int a = 0; a < 3; a++) {
                p[3 * v + a] = (float) ((v / 3 >> a & 1) * 2 - 1) * (v % 3 == a ? 1 : (float) (1 - bevel));
            }
        }
        int[] t = new int[132];
        int at = 0;
        float[] n = new float[72];
        for (int a = 0; a < 3; a++) {
            int b = 1 << (a + 1) % 3;
            int c = 1 << (a + 2) % 3;
            for (int side = 0; side < 2; side++) {
                int corner = side << a;
                at = putFacet(t, at, p, n, 3 * corner + a, 3 * (corner + b) + a, 3 * (corner + b + c) + a, 3 * (corner + c) + a);
                for (int other = 0; other < 2; other++) {
                    int edge = corner + other * b;
                    int next = (a + 1) % 3;
                    at = putFacet(t, at, p, n, 3 * edge + a, 3 * edge + next, 3 * (edge + c) + next, 3 * (edge + c) + a);
                }
            }
        }
        for (int corner = 0; corner < 8; corner++) {
            at = putFacet(t, at, p, n, 3 * corner, 3 * corner + 1, 3 * corner + 2);
        }
        return new Mesh(p, t, unit(n), null, null);
    }

    /** Adds a facet's triangles, and its outward normal to those of its vertices. */
    private static int putFacet(int[] t, int at, float[] p, float[] n, int... vertices) {
        float[] sum = new float[3];
        for (int v : vertices) {
            for (int a = 0; a < 3; a++) {
                // Opposite sides of a facet around an axis cancel, and its middle is along its normal.
                sum[a] += p[3 * v + a];
            }
        }
        float[] normal = unit(sum);
        for (int v : vertices) {
            for (int a = 0; a < 3; a++) {
                n[3 * v + a] += normal[a];
            }
        }
        int end = put(t, at, vertices[0], vertices[1], vertices[2]);
        return vertices.length == 3 ? end : put(t, end, vertices[0], vertices[2], vertices[3]);
    }

    /** Returns a closed ball of radius 1: every edge has two triangles; vertices at the poles and the seam are shared. */
    public static Mesh ball(int rings, int sectors, boolean smooth) {
        int inner = rings - 1;
        float[] p = new float[3 * (2 + inner * sectors)];
        float[] c = new float[2 * (2 + inner * sectors)];
        p[1] = 1;
        p[4] = -1;
        c[1] = 1;
        for (int r = 0; r < inner; r++) {
            for (int s = 0; s < sectors; s++) {
                int v = 2 + r * sectors + s;
                double theta = Math.PI * (r + 1) / rings;
                double phi = 2 * Math.PI * s / sectors;
                p[3 * v] = (float) (Math.sin(theta) * Math.sin(phi));
                p[3 * v + 1] = (float) Math.cos(theta);
                p[3 * v + 2] = (float) (Math.sin(theta) * Math.cos(phi));
                c[2 * v] = (float) s / sectors;
                c[2 * v + 1] = 1 - (r + 1f) / rings;
            }
        }
        int[] t = new int[6 * inner * sectors];
        int at = 0;
        for (int s = 0; s < sectors; s++) {
            int next = (s + 1) % sectors;
            at = put(t, at, 0, 2 + s, 2 + next);
            for (int r = 0; r + 1 < inner; r++) {
                int a = 2 + r * sectors;
                int b = a + sectors;
                at = put(t, at, a + s, b + s, a + next);
                at = put(t, at, a + next, b + s, b + next);
            }
            at = put(t, at, 1, 2 + (inner - 1) * sectors + next, 2 + (inner - 1) * sectors + s);
        }
        return new Mesh(p, t, smooth ? unit(p) : null, c, null);
    }

    /** Returns the canonical cone with its base. */
    public static Mesh cone(int sectors) {
        float[] p = new float[3 * (2 + sectors)];
        p[1] = 1;
        int[] t = new int[6 * sectors];
        for (int s = 0; s < sectors; s++) {
            double phi = 2 * Math.PI * s / sectors;
            p[6 + 3 * s] = (float) Math.sin(phi);
            p[8 + 3 * s] = (float) Math.cos(phi);
            put(t, 6 * s, 0, 2 + s, 2 + (s + 1) % sectors);
            put(t, 6 * s + 3, 1, 2 + (s + 1) % sectors, 2 + s);
        }
        return new Mesh(p, t, null, null, null);
    }

    /** Returns a fan of triangles a thousand times longer than wide, from the origin to a circle of radius 1 at height 1. */
    public static Mesh needles(int count) {
        float[] p = new float[9 * count];
        int[] t = new int[3 * count];
        for (int i = 0; i < count; i++) {
            double phi = 2 * Math.PI * i / count;
            float x = (float) Math.sin(phi);
            float z = (float) Math.cos(phi);
            float[] corners = {z / 2000, 0, -x / 2000, x, 1, z, -z / 2000, 0, x / 2000};
            System.arraycopy(corners, 0, p, 9 * i, 9);
            put(t, 3 * i, 3 * i, 3 * i + 1, 3 * i + 2);
        }
        return new Mesh(p, t, null, null, null);
    }

    /** Returns triangles of all sizes, including degenerate and duplicate ones, with random normals. */
    public static Mesh randomTriangles(int triangles, long seed) {
        Random random = new Random(seed);
        float[] p = new float[9 * triangles];
        int[] t = new int[3 * triangles];
        for (int i = 0; i < triangles; i++) {
            float x = (float) random.nextGaussian() / 2;
            float y = (float) random.nextGaussian() / 2;
            float z = (float) random.nextGaussian() / 2;
            float size = (float) Math.pow(10, -4 * random.nextDouble() * random.nextDouble());
            for (int v = 0; v < 3; v++) {
                p[9 * i + 3 * v] = x + size * (float) random.nextGaussian();
                p[9 * i + 3 * v + 1] = random.nextInt(4) == 0 ? 0 : y + size * (float) random.nextGaussian();
                p[9 * i + 3 * v + 2] = z + size * (float) random.nextGaussian();
                t[3 * i + v] = 3 * i + v;
            }
            switch (random.nextInt(6)) {
                case 0 -> t[3 * i] = t[3 * i + 1];
                case 1 -> System.arraycopy(p, 9 * random.nextInt(i + 1), p, 9 * i, 9);
                case 2 -> t[3 * i + random.nextInt(3)] = random.nextInt(3 * triangles);
                default -> {}
            }
        }
        return new Mesh(p, t, random.nextBoolean() ? unit(p) : null, null, null);
    }

    private static int put(int[] t, int at, int a, int b, int c) {
        t[at] = a;
        t[at + 1] = b;
        t[at + 2] = c;
        return at + 3;
    }

    /** Returns the directions of points; up for the origin. */
    private static float[] unit(float[] p) {
        float[] n = new float[p.length];
        for (int i = 0; i < p.length; i += 3) {
            double length = Math.sqrt((double) p[i] * p[i] + (double) p[i + 1] * p[i + 1] + (double) p[i + 2] * p[i + 2]);
            for (int a = 0; a < 3; a++) {
                n[i + a] = length > 0 ? (float) (p[i + a] / length) : a == 1 ? 1 : 0;
            }
        }
        return n;
    }
}
