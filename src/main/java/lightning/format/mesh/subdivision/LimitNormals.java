package lightning.format.mesh.subdivision;

import java.util.Arrays;
import lightning.format.mesh.FloatList;
import lightning.format.mesh.IntList;

/**
 * Normals of the limit surface of quadrilaterals, as the cross product of two tangents. A point has one for each of the sectors between its
 * sharp edges.
 */
final class LimitNormals {
    private static final int AXES = 3;

    private final PolygonTopology t;
    private final double[] points;
    private final int stride;
    private final int[] sharpEdges;
    private final int[] normalOf;
    private final FloatList normals = new FloatList();
    private final IntList sector = new IntList();
    private final double[] first = new double[AXES];
    private final double[] second = new double[AXES];

    private LimitNormals(PolygonTopology topology, double[] points, int stride) {
        t = topology;
        this.points = points;
        this.stride = stride;
        sharpEdges = new int[t.pointCount];
        for (int edge = 0; edge < t.edgeStart.length; edge++) {
            if (t.edgeSharpness[edge] >= 1) {
                sharpEdges[t.edgeStart[edge]]++;
                sharpEdges[t.edgeEnd[edge]]++;
            }
        }
        normalOf = new int[t.corners.length];
        Arrays.fill(normalOf, -1);
    }

    /** Unit normals, or zero where the surface has none, and that of each corner. */
    record Result(float[] normals, int[] normalOf) {}

    static Result of(PolygonTopology topology, double[] points, int stride) {
        var all = new LimitNormals(topology, points, stride);
        for (int c = 0; c < topology.corners.length; c++) {
            if (all.normalOf[c] < 0) {
                all.addSector(c);
            }
        }
        return new Result(all.normals.toArray(), all.normalOf);
    }

    /** A crease that ends at the point does not divide its faces. */
    private boolean divides(int halfEdge, int point) {
        return t.opposite[halfEdge] < 0 || t.edgeSharpness[t.edgeOf[halfEdge]] >= 1 && sharpEdges[point] > 1;
    }

    private void addSector(int corner) {
        int point = t.corners[corner];
        int start = corner;
        while (!divides(start, point)) {
            start = t.clockwise(start);
            if (start == corner) {
                break;
            }
        }
        boolean isClosed = !divides(start, point);
        sector.clear();
        int at = start;
        do {
            sector.add(at);
            normalOf[at] = normals.size() / AXES;
            if (divides(t.previous(at), point)) {
                break;
            }
            at = t.counterclockwise(at);
        } while (at != start && normalOf[at] < 0);
        Arrays.fill(first, 0);
        Arrays.fill(second, 0);
        boolean isCorner = t.pointSharpness[point] >= 1;
        if (isClosed && !isCorner) {
            addSmoothTangents();
        } else if (sharpEdges[point] == 2 && !isCorner && sector.size() > 1) {
            addCreaseTangents(point);
        } else {
            addFan(point);
            return;
        }
        addNormal(first[1] * second[2] - first[2] * second[1], first[2] * second[0] - first[0] * second[2],
                first[0] * second[1] - first[1] * second[0]);
    }

    private void addSmoothTangents() {
        int n = sector.size();
        double angle = 2 * Math.PI / n;
        double edgeWeight = 1 + Math.cos(angle) + Math.cos(angle / 2) * Math.sqrt(2 * (9 + Math.cos(angle)));
        for (int i = 0; i < n; i++) {
            int neighbor = t.corners[t.next(sector.get(i))];
            add(first, edgeWeight * Math.cos(angle * i), neighbor);
            add(second, edgeWeight * Math.sin(angle * i), neighbor);
            int across = across(sector.get(i));
            add(first, Math.cos(angle * i) + Math.cos(angle * (i + 1)), across);
            add(second, Math.sin(angle * i) + Math.sin(angle * (i + 1)), across);
        }
    }

    /**
     * Tangents along the crease and into the sector: left eigenvectors of the matrix that maps the point, its edges and its faces to those
     * of the next level. That into the sector has the weights {@code sin(i · π / n)} at the edges inside.
     */
    private void addCreaseTangents(int point) {
        int n = sector.size();
        double angle = Math.PI / n;
        double eigenvalue = (5 + Math.cos(angle) + Math.cos(angle / 2) * Math.sqrt(18 + 2 * Math.cos(angle))) / 16;
        double faceWeight = 1 / (16 * eigenvalue - 4);
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double across = faceWeight * (Math.sin(angle * i) + Math.sin(angle * (i + 1)));
            add(second, across, across(sector.get(i)));
            if (i > 0) {
                add(second, Math.sin(angle * i), t.corners[t.next(sector.get(i))]);
            }
            sum += across + Math.sin(angle * i);
        }
        double creaseWeight = (Math.sin(angle) * (1 / 16.0 + faceWeight / 4) - sum / 8) / (eigenvalue - 1 / 4.0);
        int start = t.corners[t.next(sector.get(0))];
        int end = t.corners[t.previous(sector.get(n - 1))];
        add(first, 1, start);
        add(first, -1, end);
        add(second, creaseWeight, start);
        add(second, creaseWeight, end);
        add(second, -sum - 2 * creaseWeight, point);
    }

    /** Adds the sum of the normals between the edges of the sector. */
    private void addFan(int point) {
        double x = 0;
        double y = 0;
        double z = 0;
        for (int i = 0; i < sector.size(); i++) {
            Arrays.fill(first, 0);
            Arrays.fill(second, 0);
            add(first, 1, t.corners[t.next(sector.get(i))]);
            add(first, -1, point);
            add(second, 1, t.corners[t.previous(sector.get(i))]);
            add(second, -1, point);
            x += first[1] * second[2] - first[2] * second[1];
            y += first[2] * second[0] - first[0] * second[2];
            z += first[0] * second[1] - first[1] * second[0];
        }
        addNormal(x, y, z);
    }

    private int across(int corner) {
        return t.corners[t.next(t.next(corner))];
    }

    private void add(double[] sum, double weight, int point) {
        for (int axis = 0; axis < AXES; axis++) {
            sum[axis] += weight * points[stride * point + axis];
        }
    }

    private void addNormal(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        boolean hasDirection = length > 0 && length < Double.POSITIVE_INFINITY;
        for (double component : new double[] {x, y, z}) {
            normals.add(hasDirection ? (float) (component / length) : 0);
        }
    }
}
