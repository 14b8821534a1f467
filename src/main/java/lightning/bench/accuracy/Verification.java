package lightning.bench.accuracy;

import java.util.OptionalDouble;
import lightning.base.text.Messages;
import lightning.render.image.Difference;
import lightning.render.image.Film;

/**
 * A picture beside full traces of what it shows.
 *
 * @param guarantee     what it is said to be
 * @param picture     the picture
 * @param full        the full trace of its scene, mirrors and all
 * @param expectedDifference    the picture's difference from the full trace that it is promised to be: one whose mirrors show what
 *                    the picture's show
 * @param currentDifference     its difference from {@code full}; where reflections are stale, they are in it
 * @param fullTraceMs the full trace's time, the tree of boxes left out, milliseconds; none before the process is warm
 */
public record Verification(AccuracyGuarantee guarantee, Film picture, Film full, Difference expectedDifference,
        Difference currentDifference, OptionalDouble fullTraceMs) {

    /** Whether the picture is what it is said to be. */
    public boolean hasPassed() {
        return guarantee.isMetBy(expectedDifference);
    }

    /** Whether it speaks of the picture that another promise is of. */
    public boolean appliesTo(AccuracyGuarantee other) {
        return guarantee.equals(other);
    }

    /** The verdict in a sentence, {@code Verified: equal to a full trace in every bit}, for people and for scripts. */
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
