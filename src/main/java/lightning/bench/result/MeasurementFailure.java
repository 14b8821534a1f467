package lightning.bench.result;

import org.jspecify.annotations.Nullable;

/**
 * Failed measurement of a run that continued.
 *
 * @param where scene file, size and edit, as far as known
 * @param what  reason, a sentence
 */
public record MeasurementFailure(Kind kind, String where, @Nullable String what) {
    /** Severity of a failure. */
    public enum Kind {
        /** Scene that could not be read. */
        UNREAD,
        /** Image that violates the guarantee of its accuracy setting. */
        BROKEN,
        /** Insufficient memory, or failure of another program. */
        UNMEASURED
    }
}
