package lightning.format.usd;

import java.io.IOException;
import lightning.format.gltf.JsonValue;
import lightning.format.mesh.MeshException;
import lightning.format.mesh.VertexKeyTable;

/**
 * Values at the corners of faces: normals, texture coordinates or colors.
 *
 * @param values      numbers of each value
 * @param stride      numbers for each value
 * @param level       what has a value of its own
 * @param indices     value of each element; empty if they are in order
 */
record CornerValues(float[] values, int stride, Level level, int[] indices) {
    /** Interpolations of USD. */
    private enum Level {
        CONSTANT, FACE, POINT, CORNER
    }

    /**
     * Reads values; null if absent.
     *
     * @throws MeshException if an index is beyond the values, or if they do not suffice
     */
    static CornerValues read(UsdStage stage, JsonValue in, int stride, int faces, int points, int corners)
            throws IOException, MeshException {
        if (!in.isPresent()) {
            return null;
        }
        Level level = switch (in.get("interpolation").text().orElse("")) {
            case "constant" -> Level.CONSTANT;
            case "uniform" -> Level.FACE;
            case "faceVarying" -> Level.CORNER;
            default -> Level.POINT;
        };
        int elements = switch (level) {
            case CONSTANT -> 1;
            case FACE -> faces;
            case POINT -> points;
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
            case POINT -> point;
            case CORNER -> corner;
        };
        return indices.length == 0 ? element : indices[element];
    }

    /** Copies a value. */
    void copy(int index, float[] out, int vertex) {
        System.arraycopy(values, stride * index, out, stride * vertex, stride);
    }
}
