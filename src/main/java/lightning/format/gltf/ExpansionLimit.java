package lightning.format.gltf;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;

/**
 * Limit for the memory that a glTF file may expand to, by the size of the file and its buffers. Nodes show every primitive
 * of their mesh and primitives share vertices, so a few bytes can expand to very much.
 */
final class ExpansionLimit {
    /** File bytes required per shape above {@link MeshLimits#PARTS} shapes; a placed node takes about 60 bytes. */
    private static final int BYTES_PER_SHAPE = 4;
    /** Memory in bytes that any file may take. */
    private static final long BASE_BYTES = 64L << 20;
    /**
     * Maximum memory per file byte: a one-byte index becomes an int and its vertex at most 16 floats; doubled for
     * intentional sharing.
     */
    private static final long MAX_EXPANSION_FACTOR = 128;

    private final long fileBytes;

    /**
     * Computes the size of the file and its buffers.
     *
     * @throws MeshException if a buffer is not a file in the file's folder
     * @throws IOException if a size cannot be read
     */
    ExpansionLimit(GltfFile file) throws IOException, MeshException {
        long sum = Files.size(file.path());
        for (Path buffer : file.bufferFiles()) {
            sum += Files.size(buffer);
        }
        fileBytes = sum;
    }

    /**
     * Rejects node trees that show too many shapes, before any is created.
     *
     * @param limit number of shapes allowed for any file size
     */
    static void checkShapes(GltfFile file, List<GltfNode> nodes, long limit) throws IOException, MeshException {
        long shapes = countShapes(nodes, countPrimitives(file));
        var expansion = new ExpansionLimit(file);
        long max = expansion.maxShapes(limit);
        if (shapes > max) {
            throw file.array("nodes")
                    .limit("must show at most " + max + " shapes for a file and buffers of " + expansion.fileBytes
                            + " bytes, found " + shapes + "; each node shows every primitive of its mesh");
        }
    }

    /**
     * Returns the maximum number of shapes.
     *
     * @param limit number of shapes allowed for any file size
     */
    long maxShapes(long limit) {
        return Math.min(limit, Math.max(MeshLimits.PARTS, fileBytes / BYTES_PER_SHAPE));
    }

    private static long countShapes(List<GltfNode> nodes, int[] primitives) {
        long sum = 0;
        for (GltfNode node : nodes) {
            sum += (node.mesh() < 0 ? 0 : primitives[node.mesh()]) + countShapes(node.children(), primitives);
        }
        return sum;
    }

    /** Counts the primitives of each mesh that can become a shape. */
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

    /** Rejects meshes that take too much memory. */
    void checkBytes(long usedBytes, JsonValue json) throws MeshException {
        long max = BASE_BYTES + MAX_EXPANSION_FACTOR * fileBytes;
        if (usedBytes > max) {
            throw json.limit("the meshes up to here must take at most " + (max >> 20) + " MiB for a file and buffers of "
                    + fileBytes + " bytes, found " + (usedBytes >> 20) + " MiB");
        }
    }
}
