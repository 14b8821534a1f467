package lightning.format.usd;

import java.io.IOException;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.VertexKeyTable;
import org.jspecify.annotations.Nullable;

/**
 * Values at the corners of faces: normals, texture coordinates or colors.
 *
 * @param values      numbers of each value
 * @param stride      numbers for each value
 * @param level       what has a value of its own
 * @param indices     value of each element; empty if they are in order
 */
record CornerValues(float[] values, int stride, Level level, int[] indices) {
    /** Interpolations of USD: values of points are linear in faces or, if smooth, refined as positions are. */
    private enum Level {
        CONSTANT, FACE, POINT, SMOOTH_POINT, CORNER
    }

    /** Returns values that corners refer to. */
    static CornerValues indexed(float[] values, int stride, int[] ofCorners) {
        return new CornerValues(values, stride, Level.CORNER, ofCorners);
    }

    /** Returns one value for each point. */
    static CornerValues ofPoints(float[] values, int stride) {
        return new CornerValues(values, stride, Level.POINT, new int[0]);
    }

    /** Returns one value for each corner. */
    static CornerValues ofCorners(float[] values, int stride) {
        return new CornerValues(values, stride, Level.CORNER, new int[0]).merged();
    }

    /**
     * Reads values; null if absent.
     *
     * @throws MeshException if an index is beyond the values, or if they do not suffice
     */
    static @Nullable CornerValues read(UsdStage stage, JsonValue in, int stride, int faces, int points, int corners)
            throws IOException, MeshException {
        if (!in.isPresent()) {
            return null;
        }
        Level level = switch (in.get("interpolation").text().orElse("")) {
            case "constant" -> Level.CONSTANT;
            case "uniform" -> Level.FACE;
            case "faceVarying" -> Level.CORNER;
            case "varying" -> Level.POINT;
            default -> Level.SMOOTH_POINT;
        };
        int elements = switch (level) {
            case CONSTANT -> 1;
            case FACE -> faces;
            case POINT, SMOOTH_POINT -> points;
            case CORNER -> corners;
        };
        var result = new CornerValues(stage.floats(in.get("values")), stride, level, stage.ints(in.get("indices")));
        result.check(in, elements);
        return result.indices.length == 0 && level == Level.CORNER ? result.merged() : result;
    }

    private void check(JsonValue in, int elements) throws MeshException {
        int count = values.length / stride;
        if ((indices.length == 0 ? count : indices.length) < elements) {
            throw in.problem("must have " + elements + " values, has " + (indices.length == 0 ? count : indices.length));
        }
        for (int index : indices) {
            if (index < 0 || index >= count) {
                throw in.problem("must have indices from 0 to " + (count - 1) + ", was " + index);
            }
        }
    }

    /** Gives equal values of corners one index, so that corners can share vertices. */
    private CornerValues merged() {
        var table = new VertexKeyTable();
        int[] merged = new int[values.length / stride];
        int[] first = new int[merged.length];
        for (int i = 0; i < merged.length; i++) {
            int before = table.size();
            int id = table.findOrAdd(bits(i, 0), bits(i, 1), stride > 2 ? bits(i, 2) : 0);
            first[id] = id == before ? i : first[id];
            merged[i] = first[id];
        }
        return new CornerValues(values, stride, level, merged);
    }

    private int bits(int element, int component) {
        return Float.floatToIntBits(values[stride * element + component]);
    }

    /** Returns the index of a corner's value. */
    int index(int face, int point, int corner) {
        int element = switch (level) {
            case CONSTANT -> 0;
            case FACE -> face;
            case POINT, SMOOTH_POINT -> point;
            case CORNER -> corner;
        };
        return indices.length == 0 ? element : indices[element];
    }

    /** Returns whether values are refined as positions are. */
    boolean isSmooth() {
        return level == Level.SMOOTH_POINT;
    }

    /** Returns the values of points, in order. */
    float[] ofPoints(int points) {
        float[] result = new float[stride * points];
        for (int point = 0; point < points; point++) {
            copy(index(0, point, 0), result, point);
        }
        return result;
    }

    /** Returns the values of corners, in order. */
    float[] ofCorners(int[] counts, int[] points) {
        float[] result = new float[stride * points.length];
        for (int face = 0, corner = 0; face < counts.length; face++) {
            for (int i = 0; i < counts[face]; i++, corner++) {
                copy(index(face, points[corner], corner), result, corner);
            }
        }
        return result;
    }

    /** Copies a value. */
    void copy(int index, float @Nullable [] out, int vertex) {
        System.arraycopy(values, stride * index, out, stride * vertex, stride);
    }
}
