package lightning.format.pov;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.node.Mesh;
import lightning.scene.node.Solid;
import org.jspecify.annotations.Nullable;

/** Writer for meshes as POV-Ray's {@code mesh2}; each mesh is declared once for all its shapes. */
final class PovMeshWriter {
    /** Maximum number of triangles; a longer text could not be parsed in reasonable time. */
    private static final int MAX_TRIANGLES = 4_000_000;

    /** Declared names by file and part, which identify meshes in a scene. */
    private final Map<String, String> names = new TreeMap<>();
    private final StringBuilder declarations = new StringBuilder();

    PovMeshWriter(Scene scene, List<String> warnings) {
        long triangles = 0;
        List<String> skipped = new ArrayList<>();
        for (PlacedShape shape : scene.placedShapes()) {
            if (shape.shape().solid() instanceof Solid.TriangleMesh t && !names.containsKey(key(t))) {
                triangles += t.mesh().triangleCount();
                if (triangles > MAX_TRIANGLES) {
                    skipped.add(shape.shape().name());
                    triangles -= t.mesh().triangleCount();
                } else {
                    names.put(key(t), "mesh_" + names.size());
                    if (t.hasVertexColors()) {
                        warnings.add("mesh " + shape.shape().name() + ": its vertex colors are left out");
                    }
                    writeMesh(names.get(key(t)), t.mesh());
                }
            }
        }
        skipped.forEach(
                name -> warnings.add("mesh " + name + ": left out, the export is limited to " + MAX_TRIANGLES + " triangles"));
    }

    private static String key(Solid.TriangleMesh t) {
        return t.file() + '\n' + t.part();
    }

    /** Returns all declarations. */
    String declarations() {
        return declarations.toString();
    }

    /** Returns a mesh, left open for texture and transform; an empty union if it was left out. */
    String text(Solid.TriangleMesh t) {
        String name = names.get(key(t));
        return name == null ? "union {" : "object { " + name;
    }

    private void writeMesh(@Nullable String name, Mesh mesh) {
        declarations.append("#declare ").append(name).append(" = mesh2 {\n");
        writeVectors("vertex_vectors", mesh.positions(), 3);
        if (mesh.normals() != null) {
            writeVectors("normal_vectors", mesh.normals(), 3);
        }
        if (mesh.coordinates() != null) {
            writeVectors("uv_vectors", mesh.coordinates(), 2);
        }
        int[] t = mesh.triangles();
        declarations.append("  face_indices { ").append(t.length / 3);
        for (int i = 0; i < t.length; i += 3) {
            declarations.append(",\n    <").append(t[i]).append(',').append(t[i + 1]).append(',').append(t[i + 2]).append('>');
        }
        declarations.append("\n  }\n}\n");
    }

    private void writeVectors(String keyword, float[] values, int components) {
        declarations.append("  ").append(keyword).append(" { ").append(values.length / components);
        for (int i = 0; i < values.length; i += components) {
            declarations.append(",\n    <").append(values[i]);
            for (int k = 1; k < components; k++) {
                declarations.append(',').append(values[i + k]);
            }
            declarations.append('>');
        }
        declarations.append("\n  }\n");
    }
}
