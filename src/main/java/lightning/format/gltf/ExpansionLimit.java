package lightning.format.gltf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;

/**
 * How much a glTF file may become in memory, by its bytes and those of its buffers. Nodes show every primitive of their mesh, and primitives
 * share vertices, so a few bytes can stand for very much.
 */
final class ExpansionLimit {
    /** One for so many bytes, where there are more than {@link MeshLimits#PARTS}: a node that is placed takes some 60 bytes. */
    private static final int BYTES_PER_SHAPE = 4;
    /** Bytes in memory that any file may take. */
    private static final long BASE_BYTES = 64L << 20;
    /** An index of one byte becomes an int, and its vertex at most 16 floats; twice that for what is shared on purpose. */
    private static final long MAX_EXPANSION_FACTOR = 128;

    private final long fileBytes;

    /**
     * Sums the bytes up.
     *
     * @throws MeshException if a buffer is no file in the folder of this one
     * @throws IOException   if their sizes cannot be read
     */
    ExpansionLimit(GltfFile file) throws IOException, MeshException {
        long sum = Files.size(file.path());
        for (Path buffer : file.buffers().files()) {
            sum += Files.size(buffer);
        }
        fileBytes = sum;
    }

    /**
     * Refuses nodes that show too many shapes, before any is made.
     *
     * @param limit how many there may be whatever the file's size
     */
    static void checkShapes(GltfFile file, List<GltfNode> nodes, long limit) throws IOException, MeshException {
        long shapes = countShapes(nodes, countPrimitives(file));
        var expansion = new ExpansionLimit(file);
        long max = Math.min(limit, Math.max(MeshLimits.PARTS, expansion.fileBytes / BYTES_PER_SHAPE));
        if (shapes > max) {
            throw file.array("nodes")
                    .problem("must show at most " + max + " shapes where the file and its buffers have " + expansion.fileBytes
                            + " bytes, found " + shapes + "; each node shows every primitive of its mesh");
        }
    }

    private static long countShapes(List<GltfNode> nodes, int[] primitives) {
        long sum = 0;
        for (GltfNode node : nodes) {
            sum += (node.mesh() < 0 ? 0 : primitives[node.mesh()]) + countShapes(node.children(), primitives);
        }
        return sum;
    }

    /** How many primitives of each mesh can be a shape. */
    private static int[] countPrimitives(GltfFile file) throws MeshException {
        JsonValue meshes = file.array("meshes");
        int[] counts = new int[meshes.size()];
        for (int i = 0; i < counts.length; i++) {
            JsonValue primitives = meshes.element(i).get("primitives");
            for (int j = 0; j < primitives.size(); j++) {
                counts[i] += GltfMeshReader.isDrawable(primitives.element(j)) ? 1 : 0;
            }
        }
        return counts;
    }

    /** Refuses meshes that take too many bytes in memory. */
    void checkBytes(long usedBytes, JsonValue json) throws MeshException {
        long max = BASE_BYTES + MAX_EXPANSION_FACTOR * fileBytes;
        if (usedBytes > max) {
            throw json.problem("the meshes up to here must take at most " + (max >> 20) + " MiB where the file and its buffers have "
                    + fileBytes + " bytes, found " + (usedBytes >> 20) + " MiB");
        }
    }
}
