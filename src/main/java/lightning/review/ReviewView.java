package lightning.review;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Base64;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.render.image.ViewTransform;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/**
 * A view transform as a page applies it. One that treats channels alone is the smallest value of each code, so that codes are those of the
 * editor. One that mixes channels is a lattice over logarithms of red, green and blue with 16-bit codes; between its points colors are interpolated.
 */
public final class ReviewView {
    /** Points along each side of the lattice. */
    private static final int SIDE = 65;
    /** Range of the lattice, stops from 1: below and above it colors are those at its end. */
    private static final double MIN_STOP = -13;
    private static final double MAX_STOP = 7;

    private ReviewView() {}

    /** Returns the transform of a view, with its exposure in stops. */
    public static ObjectNode json(ViewTransform view) {
        ViewTransform shown = view.forOutput();
        ObjectNode node = JsonNodeFactory.instance.objectNode();
        node.put("title", shown.curve().title()).put("exposure", shown.exposure());
        Optional<float[]> thresholds = shown.thresholds();
        if (thresholds.isPresent()) {
            return node.put("thresholds", floats(thresholds.get()));
        }
        return node.put("side", SIDE).put("minStop", MIN_STOP).put("maxStop", MAX_STOP).put("lattice",
                HalfPlanes.encode(lattice(shown), 3));
    }

    private static String floats(float[] values) {
        ByteBuffer bytes = ByteBuffer.allocate(Float.BYTES * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (float value : values) {
            bytes.putFloat(value);
        }
        return Base64.getEncoder().encodeToString(bytes.array());
    }

    /** Returns red, green and blue codes at all points; red changes fastest. */
    private static short[] lattice(ViewTransform view) {
        ViewTransform bare = view.withExposure(0);
        float[] axis = new float[SIDE];
        for (int i = 1; i < SIDE; i++) {
            axis[i] = (float) Math.pow(2, MIN_STOP + (MAX_STOP - MIN_STOP) * i / (SIDE - 1));
        }
        short[] codes = new short[3 * SIDE * SIDE * SIDE];
        IntStream.range(0, SIDE * SIDE).parallel().forEach(row -> {
            for (int r = 0; r < SIDE; r++) {
                bare.pack16(axis[r], axis[row % SIDE], axis[row / SIDE], codes, 3 * (row * SIDE + r));
            }
        });
        return codes;
    }
}
