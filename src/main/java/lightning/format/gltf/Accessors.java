package lightning.format.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.util.Map;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.MeshLimits;

/** The numbers that a glTF file names, held against the bytes behind them before an array is made. */
final class Accessors {
    private static final int BYTE = 5120;
    private static final int UNSIGNED_BYTE = 5121;
    private static final int SHORT = 5122;
    private static final int UNSIGNED_SHORT = 5123;
    private static final int UNSIGNED_INT = 5125;
    private static final int FLOAT = 5126;
    private static final Map<String, Integer> NUMBERS = Map.of("SCALAR", 1, "VEC2", 2, "VEC3", 3, "VEC4", 4);
    private static final int MOST_STRIDE = 255;

    private final GltfFile file;
    private final Buffers buffers;

    /** Numbers of one type in a buffer. */
    private record Run(ByteBuffer bytes, int offset, int stride, int type, boolean normalized) {
        double number(int element, int which) {
            int at = offset + element * stride + which * bytesOf(type);
            return switch (type) {
                case BYTE -> scaled(bytes.get(at), 127);
                case UNSIGNED_BYTE -> scaled(bytes.get(at) & 0xFF, 255);
                case SHORT -> scaled(bytes.getShort(at), 32767);
                case UNSIGNED_SHORT -> scaled(bytes.getShort(at) & 0xFFFF, 65535);
                case UNSIGNED_INT -> bytes.getInt(at) & 0xFFFF_FFFFL;
                default -> bytes.getFloat(at);
            };
        }

        /** glTF 2.0, §3.6.2.2. */
        private double scaled(int v, int largest) {
            return normalized ? Math.max((double) v / largest, -1) : v;
        }
    }

    Accessors(GltfFile file) {
        this.file = file;
        buffers = file.buffers();
    }

    int count(Json index) throws MeshException {
        return index.in(file.array("accessors")).get("count").whole(1, MeshLimits.VERTICES);
    }

    /** {@code float[each * count]}. */
    float[] floats(Json index, int each) throws IOException, MeshException {
        Json accessor = index.in(file.array("accessors"));
        int count = accessor.get("count").whole(1, MeshLimits.VERTICES);
        int has = each(accessor);
        // Colours may have a fourth number.
        if (has != each && !(each == 3 && has == 4)) {
            throw accessor.get("type").problem("must have " + each + " numbers each, has " + has);
        }
        Run run = run(accessor, count, has);
        float[] numbers = new float[each * count];
        for (int i = 0; run != null && i < count; i++) {
            for (int j = 0; j < each; j++) {
                numbers[each * i + j] = (float) run.number(i, j);
            }
        }
        Sparse sparse = sparse(accessor, count, has);
        for (int i = 0; sparse != null && i < sparse.count; i++) {
            for (int j = 0; j < each; j++) {
                numbers[each * sparse.place(i) + j] = (float) sparse.values.number(i, j);
            }
        }
        return numbers;
    }

    /** Whole numbers from 0 to below {@code end}. */
    int[] indices(Json index, int end) throws IOException, MeshException {
        Json accessor = index.in(file.array("accessors"));
        int count = accessor.get("count").whole(1, 3 * MeshLimits.TRIANGLES);
        int type = accessor.get("componentType").whole(0, Integer.MAX_VALUE);
        if (each(accessor) != 1 || type != UNSIGNED_BYTE && type != UNSIGNED_SHORT && type != UNSIGNED_INT) {
            throw accessor.problem("indices must be single numbers without sign");
        }
        Run run = run(accessor, count, 1);
        Sparse sparse = sparse(accessor, count, 1);
        int[] numbers = new int[count];
        for (int i = 0; run != null && i < count; i++) {
            numbers[i] = vertex(accessor, i, run.number(i, 0), end);
        }
        for (int i = 0; sparse != null && i < sparse.count; i++) {
            numbers[sparse.place(i)] = vertex(accessor, i, sparse.values.number(i, 0), end);
        }
        return numbers;
    }

    private static int vertex(Json accessor, int i, double v, int end) throws MeshException {
        if (v >= end) {
            throw accessor.problem("index " + i + " must be a vertex from 0 to " + (end - 1) + ", was " + (long) v);
        }
        return (int) v;
    }

    private int each(Json accessor) throws MeshException {
        Json type = accessor.get("type");
        String name = type.text().orElse("missing");
        Integer each = NUMBERS.get(name);
        if (each == null) {
            throw type.problem("must be SCALAR, VEC2, VEC3 or VEC4, was " + Quote.of(name));
        }
        return each;
    }

    /** The numbers of an accessor; null where all are 0. */
    private Run run(Json accessor, int count, int each) throws IOException, MeshException {
        Json view = accessor.get("bufferView");
        if (!view.isThere()) {
            if (count > Files.size(file.path())) {
                throw accessor.get("count").problem("must be at most the bytes of the file where there is no bufferView, was " + count);
            }
            return null;
        }
        int type = type(accessor.get("componentType"));
        int size = each * bytesOf(type);
        int stride = view.in(file.array("bufferViews")).get("byteStride").whole(size, MOST_STRIDE, size);
        return run(accessor, view, count, size, stride, type, accessor.get("normalized").yes(false));
    }

    private Run run(Json at, Json view, int count, int size, int stride, int type, boolean normalized) throws IOException, MeshException {
        ByteBuffer bytes = buffers.view(view);
        int offset = at.get("byteOffset").whole(0, bytes.capacity(), 0);
        long need = offset + (count - 1L) * stride + size;
        if (need > bytes.capacity()) {
            throw at.problem("needs " + need + " bytes of its bufferView, which has " + bytes.capacity());
        }
        return new Run(bytes, offset, stride, type, normalized);
    }

    private static int type(Json type) throws MeshException {
        int code = type.whole(0, Integer.MAX_VALUE);
        if (bytesOf(code) == 0) {
            throw type.problem("must be 5120, 5121, 5122, 5123, 5125 or 5126, was " + code);
        }
        return code;
    }

    private static int bytesOf(int type) {
        return switch (type) {
            case BYTE, UNSIGNED_BYTE -> 1;
            case SHORT, UNSIGNED_SHORT -> 2;
            case UNSIGNED_INT, FLOAT -> 4;
            default -> 0;
        };
    }

    /** Numbers that stand for those of the rest at some places. */
    private record Sparse(Json path, int count, int end, Run places, Run values) {
        int place(int i) throws MeshException {
            double place = places.number(i, 0);
            if (!(place >= 0 && place < end && place == Math.rint(place))) {
                throw path.problem("place " + i + " must be from 0 to " + (end - 1) + ", was " + place);
            }
            return (int) place;
        }
    }

    private Sparse sparse(Json accessor, int count, int each) throws IOException, MeshException {
        Json sparse = accessor.get("sparse");
        if (!sparse.isThere()) {
            return null;
        }
        int some = sparse.get("count").whole(1, count);
        Json places = sparse.get("indices");
        Json values = sparse.get("values");
        int placeType = type(places.get("componentType"));
        int type = type(accessor.get("componentType"));
        return new Sparse(places, some, count,
                run(places, places.get("bufferView"), some, bytesOf(placeType), bytesOf(placeType), placeType, false),
                run(values, values.get("bufferView"), some, each * bytesOf(type), each * bytesOf(type), type,
                        accessor.get("normalized").yes(false)));
    }
}
