package lightning.bench.result;

import java.util.List;
import java.util.Optional;

/**
 * Time against error of a program's anti-aliasing settings on one scene.
 *
 * @param program   name and version
 * @param referenceSamples samples per pixel of the program's own image from which errors are measured
 * @param width     pixels
 * @param height    pixels
 * @param points    settings, from the roughest
 */
public record ErrorCurve(String program, int referenceSamples, int width, int height, List<ErrorPoint> points) {
    public ErrorCurve {
        points = List.copyOf(points);
    }

    /** Returns the point of a setting; empty if not measured. */
    public Optional<ErrorPoint> find(String setting) {
        return points.stream().filter(point -> point.setting().equals(setting)).findFirst();
    }
}
