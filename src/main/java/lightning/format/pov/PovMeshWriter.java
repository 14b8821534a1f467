package lightning.format.pov;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import lightning.scene.Mesh;
import lightning.scene.PlacedShape;
import lightning.scene.Scene;
import lightning.scene.Solid;

/** Meshes as POV-Ray's {@code mesh2}: each is declared once, whichever shapes show it. */
final class PovMeshWriter {
    /** More would make a text that nobody can read, POV-Ray included. */
    private static final int MAX_TRIANGLES = 4_000_000;

    /** By file and part, which tell meshes apart in one scene. */
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
                        warnings.add("mesh " + shape.shape().name() + ": without the colors of its vertices");
                    }
                    writeMesh(names.get(key(t)), t.mesh());
                }
            }
        }
        skipped.forEach(
                name -> warnings.add("mesh " + name + ": left out, with it there would be more than " + MAX_TRIANGLES + " triangles"));
    }

    private static String key(Solid.TriangleMesh t) {
        return t.file() + '\n' + t.part();
    }

    /** All that was declared. */
    String declarations() {
        return declarations.toString();
    }

    /** A mesh, left open for texture and placing; an empty union where it was left out. */
    String text(Solid.TriangleMesh t) {
        String name = names.get(key(t));
        return name == null ? "union {" : "object { " + name;
    }

    private void writeMesh(String name, Mesh mesh) {
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
