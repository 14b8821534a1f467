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
final class PovMesh {
    /** More would make a text that nobody can read, POV-Ray included. */
    private static final int MOST_TRIANGLES = 4_000_000;

    /** By file and part, which tell meshes apart in one scene. */
    private final Map<String, String> names = new TreeMap<>();
    private final StringBuilder declarations = new StringBuilder();

    PovMesh(Scene scene, List<String> losses) {
        long triangles = 0;
        List<String> left = new ArrayList<>();
        for (PlacedShape shape : scene.placedShapes()) {
            if (shape.shape().solid() instanceof Solid.Triangles t && !names.containsKey(key(t))) {
                triangles += t.mesh().triangleCount();
                if (triangles > MOST_TRIANGLES) {
                    left.add(shape.shape().name());
                    triangles -= t.mesh().triangleCount();
                } else {
                    names.put(key(t), "mesh_" + names.size());
                    if (t.isTinted()) {
                        losses.add("mesh " + shape.shape().name() + ": without the colours of its vertices");
                    }
                    declare(names.get(key(t)), t.mesh());
                }
            }
        }
        left.forEach(name -> losses.add("mesh " + name + ": left out, with it there would be more than " + MOST_TRIANGLES + " triangles"));
    }

    private static String key(Solid.Triangles t) {
        return t.file() + '\n' + t.part();
    }

    /** All that was declared. */
    String declarations() {
        return declarations.toString();
    }

    /** A mesh, left open for texture and placing; an empty union where it was left out. */
    String text(Solid.Triangles t) {
        String name = names.get(key(t));
        return name == null ? "union {" : "object { " + name;
    }

    private void declare(String name, Mesh mesh) {
        declarations.append("#declare ").append(name).append(" = mesh2 {\n");
        vectors("vertex_vectors", mesh.positions(), 3);
        if (mesh.normals() != null) {
            vectors("normal_vectors", mesh.normals(), 3);
        }
        if (mesh.coordinates() != null) {
            vectors("uv_vectors", mesh.coordinates(), 2);
        }
        int[] t = mesh.triangles();
        declarations.append("  face_indices { ").append(t.length / 3);
        for (int i = 0; i < t.length; i += 3) {
            declarations.append(",\n    <").append(t[i]).append(',').append(t[i + 1]).append(',').append(t[i + 2]).append('>');
        }
        declarations.append("\n  }\n}\n");
    }

    private void vectors(String what, float[] numbers, int each) {
        declarations.append("  ").append(what).append(" { ").append(numbers.length / each);
        for (int i = 0; i < numbers.length; i += each) {
            declarations.append(",\n    <").append(numbers[i]);
            for (int k = 1; k < each; k++) {
                declarations.append(',').append(numbers[i + k]);
            }
            declarations.append('>');
        }
        declarations.append("\n  }\n");
    }
}
