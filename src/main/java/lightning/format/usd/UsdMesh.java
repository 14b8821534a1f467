package lightning.format.usd;

import static java.util.Objects.requireNonNull;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import lightning.base.text.RefusalException;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.ConversionNotes;
import lightning.format.mesh.IntList;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.PolygonTriangulator;
import lightning.format.mesh.VertexColors;
import lightning.format.mesh.VertexKeyTable;
import lightning.format.mesh.VertexNormals;
import lightning.scene.node.Mesh;
import org.jspecify.annotations.Nullable;

/** Polygons of a stage's mesh, as triangles in one mesh for each of its materials. */
public final class UsdMesh {
    private static final int MIN_CORNERS = 3;

    private final UsdFaces faces;
    private final float @Nullable [] smoothNormals;
    private final PolygonTriangulator triangulator = new PolygonTriangulator();

    private UsdMesh(UsdFaces faces, boolean isSmooth) {
        this.faces = faces;
        smoothNormals = faces.normals() == null && isSmooth ? VertexNormals.smooth(faces.points(), pointTriangles()) : null;
    }

    /**
     * Returns one mesh for each part; null where a part has no triangles.
     *
     * @param levels refinements of a subdivision surface; 0 for its control mesh
     * @param partOf part of each face, from the arrays of face numbers of all parts but the first, which has the other faces
     * @param notes receives a note if the numbers of a mesh are invalid; it then has no triangles
     */
    public static List<Mesh> read(UsdStage stage, JsonValue in, int levels, List<int[]> partOf, ConversionNotes notes) throws IOException {
        List<Mesh> result = new ArrayList<>(Collections.nCopies(partOf.size() + 1, null));
        try {
            UsdFaces faces = UsdFaces.read(stage, in);
            int[] parts = new int[faces.counts().length];
            for (int i = 0; i < partOf.size(); i++) {
                for (int face : partOf.get(i)) {
                    if (face >= 0 && face < parts.length) {
                        parts[face] = i + 1;
                    }
                }
            }
            var mesh = new UsdMesh(levels == 0 ? faces : UsdSubdivision.refine(faces, stage, in.get("subdivision"), levels),
                    in.get("smooth").bool(false));
            for (int i = 0; i < result.size(); i++) {
                result.set(i, mesh.part(parts, i, notes));
            }
        } catch (MeshException | RefusalException e) {
            notes.add("meshes with damaged arrays or numbers beyond the limits");
        }
        return result;
    }

    private int[] pointTriangles() {
        var triangles = new IntList();
        var polygon = new IntList();
        int[] counts = faces.counts();
        for (int face = 0, first = 0; face < counts.length; first += Math.abs(counts[face]), face++) {
            triangulate(first, counts[face], polygon);
            for (int i = 0; i < polygon.size(); i++) {
                triangles.add(faces.corners()[first + polygon.get(i)]);
            }
        }
        return triangles.toArray();
    }

    /** Sets triangles to corners of a face, counted from its first one. */
    private void triangulate(int first, int count, IntList triangles) {
        triangles.clear();
        if (count >= MIN_CORNERS) {
            triangulator.triangulate(Arrays.copyOfRange(faces.corners(), first, first + count), count, faces.points(), triangles);
        }
        for (int i = 0; faces.isLeftHanded() && i < triangles.size(); i += 3) {
            int second = triangles.get(i + 1);
            triangles.array()[i + 1] = triangles.get(i + 2);
            triangles.array()[i + 2] = second;
        }
    }

    private @Nullable Mesh part(int[] parts, int part, ConversionNotes notes) {
        CornerValues normals = faces.normals();
        CornerValues coordinates = faces.coordinates();
        CornerValues colors = faces.colors();
        var vertices = new VertexKeyTable();
        var values = new VertexKeyTable();
        var triangles = new IntList();
        var polygon = new IntList();
        int[] counts = faces.counts();
        for (int face = 0, first = 0; face < counts.length; first += Math.abs(counts[face]), face++) {
            if (faces.part(parts, face) != part) {
                continue;
            }
            triangulate(first, counts[face], polygon);
            for (int i = 0; i < polygon.size(); i++) {
                int corner = first + polygon.get(i);
                int point = faces.corners()[corner];
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
        CornerValues normals = faces.normals();
        float[] normal = normals == null && smoothNormals == null ? null : new float[3 * count];
        float[] uv = faces.coordinates() == null ? null : new float[2 * count];
        float[] rgb = faces.colors() == null ? null : new float[3 * count];
        for (int v = 0; v < count; v++) {
            int point = vertices.key(v, 0);
            int value = vertices.key(v, 2);
            System.arraycopy(faces.points(), 3 * point, positions, 3 * v, 3);
            if (normals != null) {
                normals.copy(vertices.key(v, 1), normal, v);
            } else if (smoothNormals != null) {
                System.arraycopy(smoothNormals, 3 * point, normal, 3 * v, 3);
            }
            if (uv != null) {
                requireNonNull(faces.coordinates()).copy(values.key(value, 0), uv, v);
            }
            if (rgb != null) {
                requireNonNull(faces.colors()).copy(values.key(value, 1), rgb, v);
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
