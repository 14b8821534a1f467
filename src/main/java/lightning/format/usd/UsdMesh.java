package lightning.format.usd;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.IntList;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.PolygonTriangulator;
import lightning.format.mesh.VertexColors;
import lightning.format.mesh.VertexKeyTable;
import lightning.format.mesh.VertexNormals;
import lightning.scene.Mesh;

/** Polygons of a stage's mesh, as triangles in one mesh for each of its materials. */
public final class UsdMesh {
    private static final int MIN_CORNERS = 3;

    private final JsonValue in;
    private final float[] points;
    private final int[] counts;
    private final int[] corners;
    private final boolean isLeftHanded;
    private final CornerValues normals;
    private final CornerValues coordinates;
    private final CornerValues colors;
    private final float[] smoothNormals;
    private final PolygonTriangulator triangulator = new PolygonTriangulator();

    private UsdMesh(UsdStage stage, JsonValue in) throws IOException, MeshException {
        this.in = in;
        points = stage.floats(in.get("points"));
        counts = stage.ints(in.get("counts"));
        corners = stage.ints(in.get("indices"));
        isLeftHanded = in.get("left").bool(false);
        checkFaces();
        int pointCount = points.length / 3;
        normals = CornerValues.read(stage, in.get("normals"), 3, counts.length, pointCount, corners.length);
        coordinates = CornerValues.read(stage, in.get("uv"), 2, counts.length, pointCount, corners.length);
        colors = CornerValues.read(stage, in.get("colors"), 3, counts.length, pointCount, corners.length);
        for (int hole : stage.ints(in.get("holes"))) {
            if (hole >= 0 && hole < counts.length) {
                // Keeps the corners in place.
                counts[hole] = -counts[hole];
            }
        }
        smoothNormals = normals == null && in.get("smooth").bool(false) ? VertexNormals.smooth(points, pointTriangles()) : null;
    }

    private void checkFaces() throws MeshException {
        long sum = 0;
        for (int count : counts) {
            if (count < 0) {
                throw in.problem("must have faces of at least 0 corners, was " + count);
            }
            sum += count;
        }
        if (sum != corners.length || points.length % 3 != 0) {
            throw in.problem("must have " + sum + " corners by its faces, has " + corners.length);
        }
        for (int corner : corners) {
            if (corner < 0 || corner >= points.length / 3) {
                throw in.problem("must have corners from 0 to " + (points.length / 3 - 1) + ", was " + corner);
            }
        }
    }

    /**
     * Returns one mesh for each part; null where a part has no triangles.
     *
     * @param partOf part of each face, from the arrays of face numbers of all parts but the first, which has the other faces
     * @param notes receives a note if the numbers of a mesh are invalid; it then has no triangles
     */
    public static List<Mesh> read(UsdStage stage, JsonValue in, List<int[]> partOf, ConversionNotes notes) throws IOException {
        List<Mesh> result = new ArrayList<>(Collections.nCopies(partOf.size() + 1, null));
        try {
            var mesh = new UsdMesh(stage, in);
            int[] parts = new int[mesh.counts.length];
            for (int i = 0; i < partOf.size(); i++) {
                for (int face : partOf.get(i)) {
                    if (face >= 0 && face < parts.length) {
                        parts[face] = i + 1;
                    }
                }
            }
            for (int i = 0; i < result.size(); i++) {
                result.set(i, mesh.part(parts, i, notes));
            }
        } catch (MeshException | IllegalArgumentException e) {
            notes.add("meshes with damaged arrays or numbers beyond the limits");
        }
        return result;
    }

    private int[] pointTriangles() {
        var triangles = new IntList();
        var polygon = new IntList();
        for (int face = 0, first = 0; face < counts.length; first += Math.abs(counts[face]), face++) {
            triangulate(first, counts[face], polygon);
            for (int i = 0; i < polygon.size(); i++) {
                triangles.add(corners[first + polygon.get(i)]);
            }
        }
        return triangles.toArray();
    }

    /** Sets triangles to corners of a face, counted from its first one. */
    private void triangulate(int first, int count, IntList triangles) {
        triangles.clear();
        if (count >= MIN_CORNERS) {
            triangulator.triangulate(Arrays.copyOfRange(corners, first, first + count), count, points, triangles);
        }
        for (int i = 0; isLeftHanded && i < triangles.size(); i += 3) {
            int second = triangles.get(i + 1);
            triangles.array()[i + 1] = triangles.get(i + 2);
            triangles.array()[i + 2] = second;
        }
    }

    private Mesh part(int[] parts, int part, ConversionNotes notes) {
        var vertices = new VertexKeyTable();
        var values = new VertexKeyTable();
        var triangles = new IntList();
        var polygon = new IntList();
        for (int face = 0, first = 0; face < counts.length; first += Math.abs(counts[face]), face++) {
            if (parts[face] != part) {
                continue;
            }
            triangulate(first, counts[face], polygon);
            for (int i = 0; i < polygon.size(); i++) {
                int corner = first + polygon.get(i);
                int point = corners[corner];
                int value = values.findOrAdd(coordinates == null ? 0 : coordinates.index(face, point, corner),
                        colors == null ? 0 : colors.index(face, point, corner), 0);
                triangles.add(vertices.findOrAdd(point, normals == null ? 0 : normals.index(face, point, corner), value));
            }
        }
        return triangles.size() == 0 ? null : mesh(vertices, values, triangles.toArray(), notes);
    }

    private Mesh mesh(VertexKeyTable vertices, VertexKeyTable values, int[] triangles, ConversionNotes notes) {
        int count = vertices.size();
        float[] positions = new float[3 * count];
        float[] normal = normals == null && smoothNormals == null ? null : new float[3 * count];
        float[] uv = coordinates == null ? null : new float[2 * count];
        float[] rgb = colors == null ? null : new float[3 * count];
        for (int v = 0; v < count; v++) {
            int point = vertices.key(v, 0);
            int value = vertices.key(v, 2);
            System.arraycopy(points, 3 * point, positions, 3 * v, 3);
            if (normals != null) {
                normals.copy(vertices.key(v, 1), normal, v);
            } else if (smoothNormals != null) {
                System.arraycopy(smoothNormals, 3 * point, normal, 3 * v, 3);
            }
            if (uv != null) {
                coordinates.copy(values.key(value, 0), uv, v);
            }
            if (rgb != null) {
                colors.copy(values.key(value, 1), rgb, v);
            }
        }
        if (normal != null) {
            VertexNormals.normalizeAll(normal, positions, triangles);
        }
        if (rgb != null) {
            VertexColors.clamp(rgb, count, notes);
        }
        return new Mesh(positions, triangles, normal, uv, rgb);
    }
}
