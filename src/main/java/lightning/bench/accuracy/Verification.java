package lightning.bench.accuracy;

import java.util.OptionalDouble;
import lightning.base.text.Texts;
import lightning.render.image.Difference;
import lightning.render.image.Film;

/**
 * A picture beside full traces of what it shows.
 *
 * @param promise     what it is said to be
 * @param picture     the picture
 * @param full        the full trace of its scene, mirrors and all
 * @param promised    the picture's difference from the full trace that it is promised to be: one whose mirrors show what
 *                    the picture's show
 * @param current     its difference from {@code full}; where reflections are stale, they are in it
 * @param fullTraceMs the full trace's time, the tree of boxes left out, milliseconds; none before the process is warm
 */
public record Verification(Promise promise, Film picture, Film full, Difference promised, Difference current, OptionalDouble fullTraceMs) {

    /** Whether the picture is what it is said to be. */
    public boolean isKept() {
        return promise.isKeptBy(promised);
    }

    /** Whether it speaks of the picture that another promise is of. */
    public boolean speaksOf(Promise other) {
        return promise.equals(other);
    }

    /** The verdict in a sentence, {@code Verified: equal to a full trace in every bit}, for people and for scripts. */
    public String text() {
        String trace = promise.isStale() ? Texts.of("a full trace whose mirrors show an older light") : Texts.of("a full trace");
        String verdict = promised.isNone() ? Texts.of("equal to {0} in every bit", trace)
                : Texts.count(promised.values(), "{0} in {1} differs from {2}, by at most {3} where {4}",
                        "{0} in {1} differ from {2}, by at most {3} where {4}", values(promised.values()), pixels(promised.pixels()), trace,
                        Promise.number(promised.maxAbsolute()), promise.bound() == 0 ? Texts.of("no bit may differ")
                                : Texts.of("{0} is promised", Promise.number(promise.bound())));
        String mirrors = !promise.isStale() ? "" : current.isNone() ? Texts.of("; and to one with current mirrors")
                : String.format(Texts.locale(), Texts.of("; %s would change with current mirrors, by at most %s, PSNR %.1f dB"),
                        pixels(current.pixels()), Promise.number(current.maxAbsolute()), current.displayPsnr());
        return (isKept() ? Texts.of("Verified: ") : Texts.of("NOT KEPT: ")) + verdict + mirrors;
    }

    private static String values(long n) {
        return String.format(Texts.locale(), Texts.count(n, "%,d value", "%,d values"), n);
    }

    private static String pixels(long n) {
        return String.format(Texts.locale(), Texts.count(n, "%,d pixel", "%,d pixels"), n);
    }
}
