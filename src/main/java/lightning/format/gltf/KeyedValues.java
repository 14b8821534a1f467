package lightning.format.gltf;

import java.util.Arrays;
import lightning.base.text.Quote;
import lightning.format.mesh.MeshException;

/**
 * Keys of one animated property (glTF 2.0, §3.11 and appendix C).
 *
 * @param frames frame of each key, in order, from 0
 * @param values numbers of each key; with cubic splines, those of its tangent before, itself and its tangent after
 * @param components numbers of a value
 * @param rate frames per second, which tangents count in
 * @param isRotation true for quaternions
 */
record KeyedValues(double[] frames, float[] values, int components, Form form, double rate, boolean isRotation) {
    /** Cosine between two quaternions from which they are mixed linearly: the arc between them is too short for its sine. */
    private static final double MIN_ARC_COSINE = 1 - 1e-9;

    /** Interpolation between two keys. */
    enum Form {
        STEP, LINEAR, CUBICSPLINE;

        /** Returns the number of values that a key has. */
        int valuesPerKey() {
            return this == CUBICSPLINE ? 3 : 1;
        }

        /** Returns the interpolation of a sampler. */
        static Form parse(JsonValue json) throws MeshException {
            String name = json.text().orElse(LINEAR.name());
            for (Form form : values()) {
                if (form.name().equals(name)) {
                    return form;
                }
            }
            throw json.problem("must be STEP, LINEAR or CUBICSPLINE, was " + Quote.of(name));
        }
    }

    /** Returns the value at a frame; that of the first key before it, and that of the last key after it. */
    double[] at(double frame) {
        int key = keyAt(frame);
        if (key < 0) {
            return value(0);
        }
        if (key == frames.length - 1 || form == Form.STEP || frame == frames[key]) {
            return value(key);
        }
        double t = (frame - frames[key]) / (frames[key + 1] - frames[key]);
        return form == Form.CUBICSPLINE ? cubic(key, t) : isRotation ? slerp(value(key), value(key + 1), t)
                : mix(value(key), 1 - t, value(key + 1), t);
    }

    /** Returns the last key that is not after a frame; −1 if there is none. */
    private int keyAt(double frame) {
        int start = -1;
        int end = frames.length;
        while (end - start > 1) {
            int middle = (start + end) >>> 1;
            if (frames[middle] <= frame) {
                start = middle;
            } else {
                end = middle;
            }
        }
        return start;
    }

    private double[] value(int key) {
        return element(form == Form.CUBICSPLINE ? 3 * key + 1 : key);
    }

    private double[] element(int index) {
        double[] element = new double[components];
        Arrays.setAll(element, i -> values[components * index + i]);
        return element;
    }

    private static double[] mix(double[] a, double weightA, double[] b, double weightB) {
        double[] mixed = new double[a.length];
        Arrays.setAll(mixed, i -> weightA * a[i] + weightB * b[i]);
        return mixed;
    }

    /** Evaluates Hermite's cubic through two keys with the tangents after the first and before the second. */
    private double[] cubic(int key, double t) {
        double seconds = (frames[key + 1] - frames[key]) / rate;
        double[] ends = mix(value(key), (2 * t - 3) * t * t + 1, value(key + 1), (3 - 2 * t) * t * t);
        double[] slopes = mix(element(3 * key + 2), seconds * t * (1 - t) * (1 - t), element(3 * key + 3), seconds * t * t * (t - 1));
        return mix(ends, 1, slopes, 1);
    }

    /** Returns the rotation on the shorter arc between two. */
    private static double[] slerp(double[] from, double[] to, double t) {
        double cosine = dot(from, to) / Math.sqrt(dot(from, from) * dot(to, to));
        double sign = cosine < 0 ? -1 : 1;
        double[] a = mix(from, 1 / Math.sqrt(dot(from, from)), from, 0);
        double[] b = mix(to, sign / Math.sqrt(dot(to, to)), to, 0);
        if (!(sign * cosine < MIN_ARC_COSINE)) {
            return mix(a, 1 - t, b, t);
        }
        double angle = Math.acos(sign * cosine);
        return mix(a, Math.sin((1 - t) * angle) / Math.sin(angle), b, Math.sin(t * angle) / Math.sin(angle));
    }

    private static double dot(double[] a, double[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += a[i] * b[i];
        }
        return sum;
    }
}
