package lightning.format.mesh.subdivision;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

/** Limit surfaces with known points, normals and numbers of faces. */
class SubdivisionSurfaceTest {
    private static final Offset<Double> EXACT = within(1e-14);
    /** Corners of the cube from −1 to 1: bit 0 is x, bit 1 is y, bit 2 is z. */
    private static final int[] CUBE = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
    private static final int[] CUBE_COUNTS = {4, 4, 4, 4, 4, 4};

    private static double[] cubePoints() {
        double[] points = new double[24];
        for (int i = 0; i < points.length; i++) {
            points[i] = (i / 3 >> i % 3 & 1) * 2 - 1;
        }
        return points;
    }

    private static ControlMesh cube() {
        return new ControlMesh(cubePoints(), 3, CUBE_COUNTS, CUBE);
    }

    private static RefinedMesh refine(ControlMesh mesh, int levels) {
        return SubdivisionSurface.refine(mesh, new double[0], 0, levels);
    }

    private static double[] point(RefinedMesh mesh, int index) {
        return Arrays.copyOfRange(mesh.points(), 3 * index, 3 * index + 3);
    }

    private static double[] normal(RefinedMesh mesh, int point) {
        for (int c = 0; c < mesh.corners().length; c++) {
            if (mesh.corners()[c] == point) {
                int at = 3 * mesh.normalOf()[c];
                return new double[] {mesh.normals()[at], mesh.normals()[at + 1], mesh.normals()[at + 2]};
            }
        }
        throw new AssertionError("an unused point");
    }

    /** The masks give (9 · 1 + 4 · 1 − 1) / 24 for a corner of the cube; 68/81 and 395/648 follow for middles of faces and edges. */
    @Test
    void limitPointsOfCube_areKnown() {
        for (int levels = 1; levels <= 4; levels++) {
            RefinedMesh mesh = refine(cube(), levels);
            for (int corner = 0; corner < 8; corner++) {
                for (int axis = 0; axis < 3; axis++) {
                    assertThat(point(mesh, corner)[axis]).isCloseTo((corner >> axis & 1) - 0.5, EXACT);
                }
            }
            // Points of the first refinement keep their numbers: 12 of edges, 6 of faces.
            for (int edge = 8; edge < 20; edge++) {
                double[] p = Arrays.stream(point(mesh, edge)).map(Math::abs).sorted().toArray();
                assertThat(p).containsExactly(new double[] {0, 395 / 648.0, 395 / 648.0}, EXACT);
            }
            for (int face = 20; face < 26; face++) {
                double[] p = Arrays.stream(point(mesh, face)).map(Math::abs).sorted().toArray();
                assertThat(p).containsExactly(new double[] {0, 0, 68 / 81.0}, EXACT);
            }
        }
    }

    @Test
    void counts_followEulersFormula() {
        for (int levels = 1; levels <= 4; levels++) {
            RefinedMesh mesh = refine(cube(), levels);
            int faces = mesh.corners().length / 4;
            assertThat(faces).isEqualTo(6 << 2 * levels);
            // V − E + F = 2, where each of E edges has two faces, and each face four edges.
            assertThat(mesh.points().length / 3 - 2 * faces + faces).isEqualTo(2);
            assertThat(mesh.corners()).contains(0).doesNotContain(mesh.points().length / 3);
            for (int face = 0; face < 6; face++) {
                int wanted = face;
                assertThat(Arrays.stream(mesh.origin()).filter(origin -> origin == wanted).count()).isEqualTo(faces / 6);
            }
        }
    }

    /** Normals of the cube's limit surface point outwards, along the symmetry axes, and are those of the facets in the limit. */
    @Test
    void normals_areOfTheLimitSurface() {
        RefinedMesh mesh = refine(cube(), 2);
        for (int i = 0; i < 26; i++) {
            double[] p = point(mesh, i);
            double length = Math.sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            for (int axis = 0; axis < 3; axis++) {
                assertThat(normal(mesh, i)[axis]).isCloseTo(p[axis] / length, within(1e-7));
            }
        }
        assertNormalsAreOfFacets(cube());
    }

    /** Compares normals with the mean normal of facets five levels finer at the same points. */
    private static void assertNormalsAreOfFacets(ControlMesh mesh) {
        RefinedMesh coarse = refine(mesh, 1);
        RefinedMesh fine = refine(mesh, 6);
        for (int point = 0; point < coarse.points().length / 3; point++) {
            double[] mean = new double[3];
            for (int c = 0; c < fine.corners().length; c++) {
                if (fine.corners()[c] == point) {
                    addFacet(mean, point(fine, point), point(fine, fine.corners()[c - c % 4 + (c + 1) % 4]),
                            point(fine, fine.corners()[c - c % 4 + (c + 3) % 4]));
                }
            }
            double[] normal = normal(coarse, point);
            double length = Math.sqrt(mean[0] * mean[0] + mean[1] * mean[1] + mean[2] * mean[2]);
            double cosine = (mean[0] * normal[0] + mean[1] * normal[1] + mean[2] * normal[2]) / length;
            assertThat(cosine).as("point %s", point).isGreaterThan(0.999);
            // The masks are eigenvectors: the same normal at every level.
            assertThat(normal(fine, point)).containsExactly(normal, within(1e-5));
        }
    }

    private static void addFacet(double[] sum, double[] a, double[] b, double[] c) {
        for (int axis = 0; axis < 3; axis++) {
            int y = (axis + 1) % 3;
            int z = (axis + 2) % 3;
            sum[axis] += (b[y] - a[y]) * (c[z] - a[z]) - (b[z] - a[z]) * (c[y] - a[y]);
        }
    }

    /** A grid of polygons with heights, without the top right faces, so that boundary points have one to three faces. */
    private static ControlMesh sheet(boolean isFlat) {
        int size = 5;
        double[] points = new double[3 * size * size];
        for (int i = 0; i < size * size; i++) {
            points[3 * i] = i % size + 0.1 * Math.sin(i);
            points[3 * i + 1] = i / size + 0.1 * Math.cos(2 * i);
            points[3 * i + 2] = isFlat ? 0 : Math.sin(i % size) * Math.cos(0.7 * (i / size));
        }
        int[] counts = new int[12];
        Arrays.fill(counts, 4);
        int[] corners = new int[48];
        int at = 0;
        for (int i = 0; i < size * size; i++) {
            boolean isOutside = i % size == size - 1 || i / size == size - 1 || i % size >= 2 && i / size >= 2;
            if (!isOutside) {
                for (int corner : new int[] {i, i + 1, i + size + 1, i + size}) {
                    corners[at++] = corner;
                }
            }
        }
        return new ControlMesh(points, 3, counts, corners);
    }

    @Test
    void plane_staysPlane() {
        ControlMesh sheet = sheet(true);
        sheet.sharpenBoundaryCorners();
        RefinedMesh mesh = refine(sheet, 3);
        for (int point : mesh.corners()) {
            assertThat(point(mesh, point)[2]).isZero();
            assertThat(normal(mesh, point)[2]).isEqualTo(1);
        }
        assertThat(point(mesh, 0)).containsExactly(point(refine(sheet, 1), 0));
        assertThat(point(mesh, 0)).containsExactly(sheet.points[0], sheet.points[1], 0);
    }

    /** A boundary is a cubic B-spline of its own points: (1, 4, 1) / 6. */
    @Test
    void boundary_isSplineOfItsPoints() {
        ControlMesh sheet = sheet(false);
        RefinedMesh mesh = refine(sheet, 2);
        for (int axis = 0; axis < 3; axis++) {
            double[] p = sheet.points;
            assertThat(point(mesh, 2)[axis]).isCloseTo((p[3 + axis] + 4 * p[6 + axis] + p[9 + axis]) / 6, EXACT);
            // Without sharp corners the boundary is round there.
            assertThat(point(mesh, 0)[axis]).isCloseTo((p[3 + axis] + 4 * p[axis] + p[15 + axis]) / 6, EXACT);
        }
    }

    @Test
    void normalsOfBoundary_areOfTheLimitSurface() {
        // Point 0 has one face and no normal by the masks of creases.
        ControlMesh sheet = sheet(false);
        sheet.sharpenBoundaryCorners();
        RefinedMesh coarse = refine(sheet, 1);
        RefinedMesh fine = refine(sheet, 6);
        for (int point : new int[] {1, 2, 3, 5, 10, 9, 6, 7, 12, 14, 17}) {
            double[] n = normal(coarse, point);
            double[] m = normal(fine, point);
            // The masks are eigenvectors: the same normal at every level.
            assertThat(m).as("point %s", point).containsExactly(n, within(1e-6));
        }
        for (int c = 0; c < fine.corners().length; c++) {
            double[] facet = new double[3];
            int first = c - c % 4;
            addFacet(facet, point(fine, fine.corners()[c]), point(fine, fine.corners()[first + (c + 1) % 4]),
                    point(fine, fine.corners()[first + (c + 3) % 4]));
            int at = 3 * fine.normalOf()[c];
            double dot = facet[0] * fine.normals()[at] + facet[1] * fine.normals()[at + 1] + facet[2] * fine.normals()[at + 2];
            double length = Math.sqrt(facet[0] * facet[0] + facet[1] * facet[1] + facet[2] * facet[2]);
            assertThat(dot / length).isGreaterThan(0.99);
        }
    }

    @Test
    void infiniteCreases_keepTheCube() {
        ControlMesh mesh = cube();
        for (int edge = 0; edge < 8 * 8; edge++) {
            mesh.setCrease(edge / 8, edge % 8, ControlMesh.INFINITE_SHARPNESS);
        }
        RefinedMesh fine = refine(mesh, 3);
        for (int corner = 0; corner < 8; corner++) {
            assertThat(point(fine, corner)).containsExactly(Arrays.copyOfRange(cubePoints(), 3 * corner, 3 * corner + 3));
        }
        for (int c = 0; c < fine.corners().length; c++) {
            double[] p = point(fine, fine.corners()[c]);
            int at = 3 * fine.normalOf()[c];
            int axis = fine.origin()[c / 4] < 2 ? 2 : fine.origin()[c / 4] < 4 ? 1 : 0;
            assertThat(Math.abs(p[axis])).isCloseTo(1, EXACT);
            assertThat(fine.normals()[at + axis]).isCloseTo((float) Math.signum(p[axis]), within(1e-6f));
        }
    }

    /** The first refinement of a crease of sharpness 0.5 is the mean of the smooth rule, 5/9, and that of creases, 3/4. */
    @Test
    void fractionalSharpness_isMeanOfBothRules() {
        ControlMesh mesh = cube();
        for (int[] edge : new int[][] {{4, 5}, {5, 7}, {7, 6}, {6, 4}}) {
            mesh.setCrease(edge[0], edge[1], 0.5f);
        }
        double[] fine = CatmullClark.refine(mesh.topology, mesh.points, 3);
        assertThat(fine[21]).isCloseTo((0.75 + 5 / 9.0) / 2, EXACT);
        assertThat(fine[23]).isCloseTo((1 + 5 / 9.0) / 2, EXACT);
        assertThat(fine[0]).isCloseTo(-5 / 9.0, EXACT);
        double previous = 0;
        for (float sharpness = 0; sharpness < 4; sharpness += 0.25f) {
            ControlMesh sharper = cube();
            for (int[] edge : new int[][] {{4, 5}, {5, 7}, {7, 6}, {6, 4}}) {
                sharper.setCrease(edge[0], edge[1], sharpness);
            }
            double z = point(refine(sharper, 4), 7)[2];
            assertThat(z).isGreaterThan(previous);
            previous = z;
        }
    }

    @Test
    void sharpPoint_staysInPlace() {
        ControlMesh mesh = cube();
        mesh.setCorner(7, ControlMesh.INFINITE_SHARPNESS);
        assertThat(point(refine(mesh, 3), 7)).containsExactly(1, 1, 1);
        assertThat(point(refine(mesh, 3), 0)).containsExactly(new double[] {-0.5, -0.5, -0.5}, EXACT);
    }

    @Test
    void cornerValues_areLinearInFaces() {
        double[] values = new double[48];
        for (int c = 0; c < 24; c++) {
            values[2 * c] = c % 4 == 1 || c % 4 == 2 ? 1 : 0;
            values[2 * c + 1] = c % 4 / 2;
        }
        RefinedMesh mesh = SubdivisionSurface.refine(cube(), values, 2, 2);
        assertThat(mesh.cornerValues()).hasSize(2 * mesh.corners().length);
        for (int c = 0; c < mesh.corners().length; c += 4) {
            double[] v = Arrays.copyOfRange(mesh.cornerValues(), 2 * c, 2 * c + 8);
            // Each quadrilateral is a square of a quarter, turned as its face.
            assertThat(v[2] - v[0]).isEqualTo(v[4] - v[6]);
            assertThat(Math.abs(v[2] - v[0]) + Math.abs(v[3] - v[1])).isEqualTo(0.25);
        }
    }

    /** Any polygons have a surface, of weights that add to 1 and are not below 0. */
    @Property
    void anyPolygons_haveSurface(@ForAll long seed) {
        var random = new SplittableRandom(seed);
        int pointCount = random.nextInt(1, 12);
        int[] counts = new int[random.nextInt(12)];
        Arrays.setAll(counts, _ -> random.nextInt(7));
        int[] corners = new int[Arrays.stream(counts).sum()];
        Arrays.setAll(corners, _ -> random.nextInt(pointCount));
        double[] points = new double[4 * pointCount];
        Arrays.setAll(points, i -> i % 4 == 3 ? 1 : random.nextDouble());
        var mesh = new ControlMesh(points, 4, counts, corners);
        for (int i = random.nextInt(6); i > 0; i--) {
            mesh.setCrease(random.nextInt(pointCount), random.nextInt(pointCount), (float) random.nextDouble(4));
            mesh.setCorner(random.nextInt(pointCount), (float) random.nextDouble(4));
        }
        if (random.nextBoolean()) {
            mesh.sharpenBoundaryCorners();
        }
        RefinedMesh fine = SubdivisionSurface.refine(mesh, new double[corners.length], 1, 1 + random.nextInt(3));
        for (int i = 0; i < fine.points().length; i++) {
            if (i % 4 == 3) {
                assertThat(fine.points()[i]).isCloseTo(1, within(1e-12));
            } else {
                assertThat(fine.points()[i]).isBetween(-1e-12, 1 + 1e-12);
            }
        }
    }
}
