package lightning.format.mesh.subdivision;

import java.util.Arrays;
import lightning.format.mesh.VertexKeyTable;

/** Connections of polygons. Half-edge c leads from the point of corner c to that of the next corner of its face. */
final class PolygonTopology {
    final int pointCount;
    /** First corner of each face, and the number of corners. */
    final int[] firstCorner;
    final int[] corners;
    final int[] faceOf;
    final int[] edgeOf;
    /** Half-edge of the other face, in the other direction; −1 at boundaries. */
    final int[] opposite;
    final int[] edgeStart;
    final int[] edgeEnd;
    final float[] edgeSharpness;
    final float[] pointSharpness;
    /** Face of the control mesh that each face is a part of. */
    final int[] origin;

    private PolygonTopology(int pointCount, int[] firstCorner, int cornerCount, int edgeCount, int[] origin) {
        this.pointCount = pointCount;
        this.firstCorner = firstCorner;
        this.origin = origin;
        corners = new int[cornerCount];
        faceOf = new int[cornerCount];
        edgeOf = new int[cornerCount];
        opposite = new int[cornerCount];
        edgeStart = new int[edgeCount];
        edgeEnd = new int[edgeCount];
        edgeSharpness = new float[edgeCount];
        pointSharpness = new float[pointCount];
        for (int face = 0; face + 1 < firstCorner.length; face++) {
            Arrays.fill(faceOf, firstCorner[face], firstCorner[face + 1], face);
        }
    }

    /** @param edges receives each edge by its smaller and larger point */
    static PolygonTopology of(int pointCount, int[] firstCorner, int[] corners, int[] origin, VertexKeyTable edges) {
        int[] edgeOf = new int[corners.length];
        for (int face = 0; face + 1 < firstCorner.length; face++) {
            for (int c = firstCorner[face]; c < firstCorner[face + 1]; c++) {
                int end = corners[c + 1 < firstCorner[face + 1] ? c + 1 : firstCorner[face]];
                edgeOf[c] = edges.findOrAdd(Math.min(corners[c], end), Math.max(corners[c], end), 0);
            }
        }
        var result = new PolygonTopology(pointCount, firstCorner, corners.length, edges.size(), origin);
        System.arraycopy(corners, 0, result.corners, 0, corners.length);
        System.arraycopy(edgeOf, 0, result.edgeOf, 0, edgeOf.length);
        for (int edge = 0; edge < edges.size(); edge++) {
            result.edgeStart[edge] = edges.key(edge, 0);
            result.edgeEnd[edge] = edges.key(edge, 1);
        }
        result.pairHalfEdges();
        result.sharpenTouchingFans();
        return result;
    }

    private void pairHalfEdges() {
        int[] uses = new int[edgeStart.length];
        int[] first = new int[edgeStart.length];
        int[] second = new int[edgeStart.length];
        for (int c = 0; c < corners.length; c++) {
            int edge = edgeOf[c];
            (uses[edge] == 0 ? first : second)[edge] = c;
            uses[edge]++;
        }
        Arrays.fill(opposite, -1);
        for (int edge = 0; edge < uses.length; edge++) {
            if (uses[edge] == 2 && corners[first[edge]] != corners[second[edge]]) {
                opposite[first[edge]] = second[edge];
                opposite[second[edge]] = first[edge];
            } else {
                edgeSharpness[edge] = ControlMesh.INFINITE_SHARPNESS;
            }
        }
    }

    /** Makes corners of points whose faces are not all connected by edges at the point. */
    private void sharpenTouchingFans() {
        int[] fans = new int[pointCount];
        boolean[] visited = new boolean[corners.length];
        for (int c = 0; c < corners.length; c++) {
            if (!visited[c]) {
                fans[corners[c]]++;
                for (int at = c; at >= 0 && !visited[at]; at = counterclockwise(at)) {
                    visited[at] = true;
                }
                for (int at = clockwise(c); at >= 0 && !visited[at]; at = clockwise(at)) {
                    visited[at] = true;
                }
            }
        }
        for (int point = 0; point < pointCount; point++) {
            if (fans[point] > 1) {
                pointSharpness[point] = ControlMesh.INFINITE_SHARPNESS;
            }
        }
    }

    int faceCount() {
        return firstCorner.length - 1;
    }

    int next(int corner) {
        return corner + 1 < firstCorner[faceOf[corner] + 1] ? corner + 1 : firstCorner[faceOf[corner]];
    }

    int previous(int corner) {
        return corner > firstCorner[faceOf[corner]] ? corner - 1 : firstCorner[faceOf[corner] + 1] - 1;
    }

    /** Returns the next corner at the same point, counterclockwise around it; −1 at a boundary. */
    int counterclockwise(int corner) {
        return opposite[previous(corner)];
    }

    /** Returns the next corner at the same point, clockwise around it; −1 at a boundary. */
    int clockwise(int corner) {
        return opposite[corner] < 0 ? -1 : next(opposite[corner]);
    }

    /**
     * Returns the connections of the next level: a quadrilateral for each corner. Points come first, then those of edges, then those of
     * faces; each edge has two halves, and each corner an edge from the middle of its half-edge to that of its face.
     */
    PolygonTopology refined() {
        int edges = edgeStart.length;
        int[] quads = new int[corners.length + 1];
        Arrays.setAll(quads, i -> 4 * i);
        int[] origins = new int[corners.length];
        Arrays.setAll(origins, c -> origin[faceOf[c]]);
        var fine = new PolygonTopology(pointCount + edges + faceCount(), quads, 4 * corners.length, 2 * edges + corners.length, origins);
        for (int edge = 0; edge < edges; edge++) {
            float sharpness = decayed(edgeSharpness[edge]);
            for (int half = 0; half < 2; half++) {
                fine.edgeStart[2 * edge + half] = half == 0 ? edgeStart[edge] : edgeEnd[edge];
                fine.edgeEnd[2 * edge + half] = pointCount + edge;
                fine.edgeSharpness[2 * edge + half] = sharpness;
            }
        }
        for (int point = 0; point < pointCount; point++) {
            fine.pointSharpness[point] = decayed(pointSharpness[point]);
        }
        for (int c = 0; c < corners.length; c++) {
            int before = previous(c);
            int middle = pointCount + edges + faceOf[c];
            fine.edgeStart[2 * edges + c] = pointCount + edgeOf[c];
            fine.edgeEnd[2 * edges + c] = middle;
            fine.set(4 * c, corners[c], half(c, corners[c]), opposite[c] < 0 ? -1 : 4 * next(opposite[c]) + 3);
            fine.set(4 * c + 1, pointCount + edgeOf[c], 2 * edges + c, 4 * next(c) + 2);
            fine.set(4 * c + 2, middle, 2 * edges + before, 4 * before + 1);
            fine.set(4 * c + 3, pointCount + edgeOf[before], half(before, corners[c]), opposite[before] < 0 ? -1 : 4 * opposite[before]);
        }
        return fine;
    }

    private void set(int corner, int point, int edge, int otherHalf) {
        corners[corner] = point;
        edgeOf[corner] = edge;
        opposite[corner] = otherHalf;
    }

    private int half(int corner, int end) {
        return 2 * edgeOf[corner] + (edgeStart[edgeOf[corner]] == end ? 0 : 1);
    }

    private static float decayed(float sharpness) {
        return sharpness >= ControlMesh.INFINITE_SHARPNESS ? sharpness : Math.max(0, sharpness - 1);
    }
}
