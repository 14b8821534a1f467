package lightning.render.measure;

import java.util.OptionalDouble;
import lightning.base.text.Messages;
import lightning.render.image.Difference;
import lightning.render.image.Film;

/**
 * Comparison of an image with full traces of its scene.
 *
 * @param guarantee          accuracy guarantee of the image
 * @param picture            image
 * @param full               full trace of its scene, reflections included
 * @param expectedDifference difference from the guaranteed full trace, whose reflections show the same scene as the image's
 * @param currentDifference  difference from {@code full}, including stale reflections
 * @param fullTraceMs        milliseconds of the full trace without building the BVH; empty before the process is warm
 */
public record Verification(AccuracyGuarantee guarantee, Film picture, Film full, Difference expectedDifference,
        Difference currentDifference, OptionalDouble fullTraceMs) {

    /** Returns whether the image satisfies its guarantee. */
    public boolean hasPassed() {
        return guarantee.isMetBy(expectedDifference);
    }

    /** Returns whether the verification applies to an image with another guarantee. */
    public boolean appliesTo(AccuracyGuarantee other) {
        return guarantee.equals(other);
    }

    /** Returns the result as a sentence, {@code Verified: equal to a full trace in every bit}, for people and scripts. */
    public String text() {
        String trace = guarantee.isStale() ? Messages.tr("a full trace with outdated reflections") : Messages.tr("a full trace");
        String verdict = expectedDifference.isNone() ? Messages.tr("equal to {0} in every bit", trace)
                : Messages.count(expectedDifference.values(), "{0} in {1} differs from {2} by at most {3} ({4})",
                        "{0} in {1} differ from {2} by at most {3} ({4})", values(expectedDifference.values()),
                        pixels(expectedDifference.pixels()), trace,
                        AccuracyGuarantee.number(expectedDifference.maxAbsolute()),
                        guarantee.bound() == 0 ? Messages.tr("expected: no difference")
                                : Messages.tr("expected: at most {0}", AccuracyGuarantee.number(guarantee.bound())));
        String mirrors = !guarantee.isStale() ? "" : currentDifference.isNone() ? Messages.tr("; also with current reflections")
                : String.format(Messages.locale(), Messages.tr("; %s would change with current reflections, by at most %s, PSNR %.1f dB"),
                        pixels(currentDifference.pixels()), AccuracyGuarantee.number(currentDifference.maxAbsolute()),
                        currentDifference.displayPsnr());
        return (hasPassed() ? Messages.tr("Verified: ") : Messages.tr("Verification failed: ")) + verdict + mirrors;
    }

    private static String values(long n) {
        return String.format(Messages.locale(), Messages.count(n, "%,d value", "%,d values"), n);
    }

    private static String pixels(long n) {
        return String.format(Messages.locale(), Messages.count(n, "%,d pixel", "%,d pixels"), n);
    }
}
