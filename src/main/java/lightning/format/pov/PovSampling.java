package lightning.format.pov;

import java.util.List;

/**
 * Anti-aliasing of POV-Ray.
 *
 * @param label     short label for tables, as in {@code +A0.1 +AM2 +R3}
 * @param arguments command arguments
 */
public record PovSampling(String label, List<String> arguments) {
    /** One sample per pixel, at its center. */
    public static final PovSampling NONE = of("-A");

    public PovSampling {
        arguments = List.copyOf(arguments);
    }

    /** Returns method 2: pixels whose corners differ are divided again and again, {@code depth} times at most. */
    public static PovSampling adaptive(double threshold, int depth) {
        return of("+A" + threshold, "+AM2", "+R" + depth);
    }

    /** Returns method 1: {@code grid} × {@code grid} samples in pixels that differ from a neighbor; with threshold 0 in every pixel. */
    public static PovSampling grid(double threshold, int grid) {
        return of("+A" + threshold, "+AM1", "+R" + grid);
    }

    private static PovSampling of(String... arguments) {
        return new PovSampling(String.join(" ", arguments), List.of(arguments));
    }
}
