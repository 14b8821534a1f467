package lightning.format.gltf;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import lightning.base.math.Transform;
import lightning.format.mesh.MeshException;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Copies of the meshes of nodes (EXT_mesh_gpu_instancing). */
final class NodeInstances {
    private static final double[] NO_TRANSLATION = {0, 0, 0};
    private static final double[] NO_ROTATION = {0, 0, 0, 1};
    private static final double[] NO_SCALE = {1, 1, 1};

    private final GltfFile file;
    private final AccessorReader accessors;
    /** Number of copies of all nodes so far. */
    private long count;

    NodeInstances(GltfFile file) {
        this.file = file;
        accessors = new AccessorReader(file);
    }

    /**
     * Returns the transforms of copies relative to their node; empty if it is shown once.
     *
     * @throws MeshException if they are invalid, or the nodes so far have more copies than a scene may have shapes
     */
    List<Transform> of(JsonValue node) throws IOException, MeshException {
        JsonValue attributes = node.get("extensions").get("EXT_mesh_gpu_instancing").get("attributes");
        JsonValue any = attributes.get("TRANSLATION").isPresent() ? attributes.get("TRANSLATION")
                : attributes.get("ROTATION").isPresent() ? attributes.get("ROTATION") : attributes.get("SCALE");
        if (!any.isPresent()) {
            return List.of();
        }
        int copies = accessors.count(any);
        count += copies;
        if (count > SceneLimits.MAX_SHAPES || count > new ExpansionLimit(file).maxShapes(SceneLimits.MAX_SHAPES)) {
            throw any.problem("nodes up to here have " + count + " copies, more than the file's size justifies");
        }
        float[] translations = values(attributes.get("TRANSLATION"), 3, copies);
        float[] rotations = values(attributes.get("ROTATION"), 4, copies);
        float[] scales = values(attributes.get("SCALE"), 3, copies);
        List<Transform> transforms = new ArrayList<>();
        for (int i = 0; i < copies; i++) {
            double[] q = element(rotations, i, NO_ROTATION);
            transforms.add(GltfScene.transform(element(translations, i, NO_TRANSLATION),
                    q[0] == 0 && q[1] == 0 && q[2] == 0 && q[3] == 0 ? NO_ROTATION : q, element(scales, i, NO_SCALE)));
        }
        return transforms;
    }

    private float @Nullable [] values(JsonValue accessor, int components, int copies) throws IOException, MeshException {
        if (!accessor.isPresent()) {
            return null;
        }
        if (accessors.count(accessor) != copies) {
            throw accessor.problem("must have one value per copy, " + copies + ", has " + accessors.count(accessor));
        }
        return accessors.floats(accessor, components);
    }

    private static double[] element(float @Nullable [] values, int index, double[] fallback) {
        if (values == null) {
            return fallback;
        }
        double[] element = new double[fallback.length];
        for (int i = 0; i < element.length; i++) {
            element[i] = values[fallback.length * index + i];
        }
        return element;
    }
}
