package lightning.bench.report;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import lightning.bench.result.ErrorCurve;
import lightning.bench.result.ErrorPoint;
import lightning.bench.result.ModernSampling;
import lightning.bench.result.ModernScene;

/**
 * Comparison of two programs at equal error: a setting of one, and the other's fastest measured setting whose error is not larger.
 *
 * @param scene   scene name
 * @param program program of {@code target}
 * @param other   fastest setting of the other program; empty if none is as accurate
 * @param isOurs  whether the target is ours
 */
record EqualError(String scene, String program, ErrorPoint target, Optional<ErrorPoint> other, boolean isOurs) {

    /** Returns the comparisons of a scene, first at POV-Ray's error, then at ours; empty if POV-Ray was not measured. */
    static List<EqualError> of(ModernScene scene) {
        if (scene.curves().size() < 2) {
            return List.of();
        }
        ErrorCurve ours = scene.curves().getFirst();
        ErrorCurve theirs = scene.curves().get(1);
        return Stream.of(compare(scene, theirs, ModernSampling.EDGES.povRayLabel(), ours, false),
                compare(scene, ours, ModernSampling.EDGES.label(), theirs, true)).flatMap(Optional::stream).toList();
    }

    private static Optional<EqualError> compare(ModernScene scene, ErrorCurve curve, String setting, ErrorCurve other, boolean isOurs) {
        return curve.find(setting)
                .map(target -> new EqualError(scene.scene(), curve.program(), target, fastestWithin(other, target.error()), isOurs));
    }

    /** Returns the fastest point whose error is at most that; empty if there is none. */
    private static Optional<ErrorPoint> fastestWithin(ErrorCurve curve, double error) {
        return curve.points().stream().filter(point -> point.error() <= error)
                .min((a, b) -> Double.compare(a.time().median(), b.time().median()));
    }

    /** Returns POV-Ray's time divided by ours; NaN without another setting. */
    double timesAsFast() {
        double targetMs = target.time().median();
        double otherMs = other.map(point -> point.time().median()).orElse(Double.NaN);
        return isOurs ? otherMs / targetMs : targetMs / otherMs;
    }
}
