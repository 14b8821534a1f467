package lightning.format.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;
import org.jspecify.annotations.Nullable;

/** Reader for accessor data, validated against the buffer's size before an array is allocated. */
final class AccessorReader {
    private static final int BYTE = 5120;
    private static final int UNSIGNED_BYTE = 5121;
    private static final int SHORT = 5122;
    private static final int UNSIGNED_SHORT = 5123;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;
    private static final Map<String, Integer> COMPONENT_COUNTS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4, "MAT4", 16);
    private static final int MAX_STRIDE = 255;

    private final GltfFile file;
    private final BufferReader buffers;

    /** View of elements of one type in a buffer. */
    private record ElementView(ByteBuffer bytes, int offset, int stride, int type, boolean normalized) {
        double number(int element, int component) {
            int position = offset + element * stride + component * componentBytes(type);
            return switch (type) {
                case BYTE -> decode(bytes.get(position), 127);
                case UNSIGNED_BYTE -> decode(bytes.get(position) & 0xFF, 255);
                case SHORT -> decode(bytes.getShort(position), 32767);
                case UNSIGNED_SHORT -> decode(bytes.getShort(position) & 0xFFFF, 65535);
                case UNSIGNED_INT -> bytes.getInt(position) & 0xFFFF_FFFFL;
                default -> bytes.getFloat(position);
            };
        }

        private double decode(int v, int max) {
            return normalized ? fraction(v, max) : v;
        }
    }

    /** Values of compressed primitives by accessor: all components that they have. */
    private final Map<Integer, Decoded> decodedValues = new HashMap<>();
    private final Map<Integer, int[]> decodedIndices = new HashMap<>();

    /** Decoded values of an accessor. */
    private record Decoded(float[] values, int components) {}

    AccessorReader(GltfFile file) {
        this.file = file;
        buffers = file.buffers();
    }

    /** Decodes a normalized integer: glTF 2.0, §3.6.2.2. */
    static double fraction(int v, int max) {
        return Math.max((double) v / max, -1);
    }

    int count(JsonValue index) throws MeshException {
        return index.resolve(file.array("accessors")).get("count").integer(1, MeshLimits.VERTICES);
    }

    /** Sets the values of an accessor without a buffer view. */
    void setValues(JsonValue index, float[] values, int components) throws MeshException {
        decodedValues.put(index.index(file.array("accessors")), new Decoded(values, components));
    }

    /** Sets the first {@code count} indices of an accessor without a buffer view. */
    void setIndices(JsonValue index, int[] indices, int count) throws MeshException {
        decodedIndices.put(index.index(file.array("accessors")), Arrays.copyOf(indices, count));
    }

    private float[] floats(Decoded decoded, int components, JsonValue accessor) throws MeshException {
        if (decoded.components < components) {
            throw accessor.problem("must have " + components + " numbers each, has " + decoded.components);
        }
        float[] values = new float[decoded.values.length / decoded.components * components];
        for (int i = 0; i < values.length; i++) {
            values[i] = decoded.values[i / components * decoded.components + i % components];
        }
        return values;
    }

    /** Reads an accessor as floats, {@code float[components * count]}. */
    float[] floats(JsonValue index, int components) throws IOException, MeshException {
        Decoded decoded = decodedValues.get(index.index(file.array("accessors")));
        if (decoded != null) {
            return floats(decoded, components, index);
        }
        JsonValue accessor = index.resolve(file.array("accessors"));
        int count = accessor.get("count").integer(1, MeshLimits.VERTICES);
        int available = componentCount(accessor);
        // Colors may have a fourth component.
        if (available != components && !(components == 3 && available == 4)) {
            throw accessor.get("type").problem("must have " + components + " numbers each, has " + available);
        }
        ElementView view = elementView(accessor, count, available);
        float[] values = new float[components * count];
        for (int i = 0; view != null && i < count; i++) {
            for (int j = 0; j < components; j++) {
                values[components * i + j] = (float) view.number(i, j);
            }
        }
        Sparse sparse = sparse(accessor, count, available);
        for (int i = 0; sparse != null && i < sparse.count; i++) {
            for (int j = 0; j < components; j++) {
                values[components * sparse.index(i) + j] = (float) sparse.values.number(i, j);
            }
        }
        return values;
    }

    /** Reads indices, each from 0 to {@code vertexCount} − 1. */
    int[] indices(JsonValue index, int vertexCount) throws IOException, MeshException {
        int[] decoded = decodedIndices.get(index.index(file.array("accessors")));
        if (decoded != null) {
            for (int i = 0; i < decoded.length; i++) {
                checkVertex(index, i, decoded[i], vertexCount);
            }
            return decoded.clone();
        }
        JsonValue accessor = index.resolve(file.array("accessors"));
        int count = accessor.get("count").integer(1, 3 * MeshLimits.TRIANGLES);
        int type = accessor.get("componentType").integer(0, Integer.MAX_VALUE);
        if (componentCount(accessor) != 1 || type != UNSIGNED_BYTE && type != UNSIGNED_SHORT && type != UNSIGNED_INT) {
            throw accessor.problem("indices must be unsigned scalars");
        }
        ElementView view = elementView(accessor, count, 1);
        Sparse sparse = sparse(accessor, count, 1);
        int[] result = new int[count];
        for (int i = 0; view != null && i < count; i++) {
            result[i] = checkVertex(accessor, i, view.number(i, 0), vertexCount);
        }
        for (int i = 0; sparse != null && i < sparse.count; i++) {
            result[sparse.index(i)] = checkVertex(accessor, i, sparse.values.number(i, 0), vertexCount);
        }
        return result;
    }

    private static int checkVertex(JsonValue accessor, int position, double v, int vertexCount) throws MeshException {
        if (!(v >= 0 && v < vertexCount)) {
            throw accessor.problem("index " + position + " must be a vertex from 0 to " + (vertexCount - 1) + ", was " + (long) v);
        }
        return (int) v;
    }

    private int componentCount(JsonValue accessor) throws MeshException {
        JsonValue type = accessor.get("type");
        String name = type.text().orElse("missing");
        Integer components = COMPONENT_COUNTS.get(name);
        if (components == null) {
            throw type.problem("must be SCALAR, VEC2, VEC3, VEC4 or MAT4, was " + Quote.of(name));
        }
        return components;
    }

    /** Returns the view of an accessor's data; null if all values are 0. */
    private @Nullable ElementView elementView(JsonValue accessor, int count, int components) throws IOException, MeshException {
        JsonValue view = accessor.get("bufferView");
        if (!view.isPresent()) {
            if (count > Files.size(file.path())) {
                throw accessor.get("count").problem("must be at most the file's size if there is no bufferView, was " + count);
            }
            return null;
        }
        int type = componentType(accessor.get("componentType"));
        int size = components * componentBytes(type);
        int stride = view.resolve(file.array("bufferViews")).get("byteStride").integer(size, MAX_STRIDE, size);
        return elementView(accessor, view, count, size, stride, type, accessor.get("normalized").bool(false));
    }

    private ElementView elementView(JsonValue source, JsonValue view, int count, int size, int stride, int type, boolean normalized)
            throws IOException, MeshException {
        ByteBuffer bytes = buffers.view(view);
        int offset = source.get("byteOffset").integer(0, bytes.capacity(), 0);
        long requiredBytes = offset + (count - 1L) * stride + size;
        if (requiredBytes > bytes.capacity()) {
            throw source.problem("needs " + requiredBytes + " bytes of its bufferView, which has " + bytes.capacity());
        }
        return new ElementView(bytes, offset, stride, type, normalized);
    }

    private static int componentType(JsonValue type) throws MeshException {
        int code = type.integer(0, Integer.MAX_VALUE);
        if (componentBytes(code) == 0) {
            throw type.problem("must be 5120, 5121, 5122, 5123, 5125 or 5126, was " + code);
        }
        return code;
    }

    private static int componentBytes(int type) {
        return switch (type) {
            case BYTE, UNSIGNED_BYTE -> 1;
            case SHORT, UNSIGNED_SHORT -> 2;
            case UNSIGNED_INT, FLOAT -> 4;
            default -> 0;
        };
    }

    /** Sparse values that replace some elements of an accessor. */
    private record Sparse(JsonValue path, int count, int elementCount, ElementView indices, ElementView values) {
        int index(int i) throws MeshException {
            double index = indices.number(i, 0);
            if (!(index >= 0 && index < elementCount && index == Math.rint(index))) {
                throw path.problem("index " + i + " must be from 0 to " + (elementCount - 1) + ", was " + index);
            }
            return (int) index;
        }
    }

    private @Nullable Sparse sparse(JsonValue accessor, int count, int components) throws IOException, MeshException {
        JsonValue sparse = accessor.get("sparse");
        if (!sparse.isPresent()) {
            return null;
        }
        int sparseCount = sparse.get("count").integer(1, count);
        JsonValue indices = sparse.get("indices");
        JsonValue values = sparse.get("values");
        int indexType = componentType(indices.get("componentType"));
        int type = componentType(accessor.get("componentType"));
        return new Sparse(indices, sparseCount, count,
                elementView(indices, indices.get("bufferView"), sparseCount, componentBytes(indexType), componentBytes(indexType),
                        indexType, false),
                elementView(values, values.get("bufferView"), sparseCount, components * componentBytes(type),
                        components * componentBytes(type), type,
                        accessor.get("normalized").bool(false)));
    }
}
