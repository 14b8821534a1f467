package lightning.format.mesh.subdivision;

import lightning.format.mesh.IntList;
import lightning.format.mesh.VertexKeyTable;

/**
 * Mutable control mesh of a subdivision surface. Its edges with one face are boundaries, which are creases. Edges of more than two faces, or
 * of two that turn the same way, are creases too, and points where several surfaces touch are corners, so that every mesh has a surface.
 */
public final class ControlMesh {
    /** Sharpness from which creases and corners stay sharp at every level. */
    public static final float INFINITE_SHARPNESS = 10;
    private static final int MIN_CORNERS = 3;

    /** Topology of the faces with at least three different corners in order. */
    final PolygonTopology topology;
    /** Corner of the input for each corner of the topology. */
    final int[] inputCorners;
    final double[] points;
    final int stride;
    private final VertexKeyTable edges = new VertexKeyTable();

    /**
     * Creates a mesh without creases.
     *
     * @param points  {@code stride} numbers for each point, the first three its position; the others are refined like it
     * @param counts  corners of each face
     * @param corners point of each corner, face by face
     */
    public ControlMesh(double[] points, int stride, int[] counts, int[] corners) {
        this.points = points;
        this.stride = stride;
        var kept = new IntList();
        var first = new IntList();
        var origin = new IntList();
        for (int face = 0, start = 0; face < counts.length; start += counts[face], face++) {
            first.add(kept.size());
            for (int i = 0; i < counts[face]; i++) {
                if (corners[start + i] != corners[start + (i + 1) % counts[face]]) {
                    kept.add(start + i);
                }
            }
            if (kept.size() - first.get(first.size() - 1) < MIN_CORNERS) {
                kept.truncate(first.get(first.size() - 1));
                first.truncate(first.size() - 1);
            } else {
                origin.add(face);
            }
        }
        first.add(kept.size());
        inputCorners = kept.toArray();
        int[] compact = new int[inputCorners.length];
        for (int i = 0; i < compact.length; i++) {
            compact[i] = corners[inputCorners[i]];
        }
        topology = PolygonTopology.of(points.length / stride, first.toArray(), compact, origin.toArray(), edges);
    }

    /** Sets the sharpness of an edge of two points, in levels at which it stays sharp; ignored if no face has it. */
    public void setCrease(int a, int b, float sharpness) {
        int before = edges.size();
        int edge = edges.findOrAdd(Math.min(a, b), Math.max(a, b), 0);
        if (edge < before && edge < topology.edgeSharpness.length) {
            topology.edgeSharpness[edge] = Math.max(topology.edgeSharpness[edge], limited(sharpness));
        }
    }

    /** Returns true for the number of one of its points. */
    public boolean hasPoint(int point) {
        return point >= 0 && point < topology.pointCount;
    }

    /** Sets the sharpness of a point, in levels at which it stays in place. */
    public void setCorner(int point, float sharpness) {
        topology.pointSharpness[point] = Math.max(topology.pointSharpness[point], limited(sharpness));
    }

    private static float limited(float sharpness) {
        return sharpness >= INFINITE_SHARPNESS ? INFINITE_SHARPNESS : Math.max(0, sharpness);
    }

    /** Makes corners of all points that have one face. */
    public void sharpenBoundaryCorners() {
        int[] faces = new int[topology.pointCount];
        for (int point : topology.corners) {
            faces[point]++;
        }
        for (int point = 0; point < faces.length; point++) {
            if (faces[point] == 1) {
                topology.pointSharpness[point] = INFINITE_SHARPNESS;
            }
        }
    }

    /** Returns for each face of the input if it has a point on the boundary. */
    public boolean[] boundaryFaces(int inputFaces) {
        boolean[] isBoundary = new boolean[topology.pointCount];
        for (int c = 0; c < topology.corners.length; c++) {
            if (topology.opposite[c] < 0) {
                isBoundary[topology.corners[c]] = true;
                isBoundary[topology.corners[topology.next(c)]] = true;
            }
        }
        boolean[] result = new boolean[inputFaces];
        for (int c = 0; c < topology.corners.length; c++) {
            result[topology.origin[topology.faceOf[c]]] |= isBoundary[topology.corners[c]];
        }
        return result;
    }
}
