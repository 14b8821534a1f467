package lightning.editor.window.model;

import lightning.base.text.Texts;

/** How long a work will still take, from how long it took so far; nothing while that would be a guess. */
public final class Remaining {
    /** Before that, nanoseconds, the first tiles tell too little. */
    private static final long FIRST = 1_000_000_000;
    private static final double LEAST_SHARE = 0.04;
    private static final double SECOND = 1e9;

    private String work = "";
    private long since;

    /**
     * What is told of a work, {@code Tracing · 12 s left}.
     *
     * @param what  the work; empty where there is none
     * @param share how much of it is done, 0…1
     * @param now   nanoseconds of any clock
     */
    public String tell(String what, double share, long now) {
        if (!what.equals(work)) {
            work = what;
            since = now;
        }
        long took = now - since;
        return what.isEmpty() || took < FIRST || !(share >= LEAST_SHARE) || share >= 1 ? what
                : Texts.of("{0} · {1} left", what, text(took / SECOND * (1 - share) / share));
    }

    /** Seconds as a person would say them: what follows is none. */
    private static String text(double seconds) {
        if (seconds < 10) {
            return String.format(Texts.locale(), "%.0f s", Math.max(1, Math.ceil(seconds)));
        }
        return seconds < 90 ? String.format(Texts.locale(), "%.0f s", Math.ceil(seconds / 5) * 5)
                : String.format(Texts.locale(), "%.0f min", Math.ceil(seconds / 60));
    }
}
