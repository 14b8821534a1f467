package lightning.accuracy;

import java.util.Locale;
import java.util.OptionalDouble;
import lightning.image.Difference;
import lightning.image.Film;

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
        String trace = promise.isStale() ? "a full trace whose mirrors show an older light" : "a full trace";
        String verdict = promised.isNone() ? "equal to " + trace + " in every bit"
                : count(promised.values(), "value") + " in " + count(promised.pixels(), "pixel")
                        + (promised.values() == 1 ? " differs from " : " differ from ") + trace
                        + ", by at most " + Promise.number(promised.maxAbsolute()) + " where "
                        + (promise.bound() == 0 ? "no bit may differ" : Promise.number(promise.bound()) + " is promised");
        String mirrors = !promise.isStale() ? "" : current.isNone() ? "; and to one with current mirrors"
                : String.format(Locale.ROOT, "; %s would change with current mirrors, by at most %s, PSNR %.1f dB",
                        count(current.pixels(), "pixel"), Promise.number(current.maxAbsolute()), current.displayPsnr());
        return (isKept() ? "Verified: " : "NOT KEPT: ") + verdict + mirrors;
    }

    private static String count(long n, String what) {
        return String.format(Locale.ROOT, n == 1 ? "%,d %s" : "%,d %ss", n, what);
    }
}
