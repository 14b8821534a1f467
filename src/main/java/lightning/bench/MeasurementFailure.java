package lightning.bench;

/**
 * Something that could not be measured, while the rest was.
 *
 * @param where the scene's file, its size and the edit, as far as known
 * @param what  a sentence
 */
public record MeasurementFailure(Kind kind, String where, String what) {
    /** What a problem says about the program. */
    public enum Kind {
        /** A scene could not be read. */
        UNREAD,
        /** A picture is not what its grade of accuracy promises. */
        BROKEN,
        /** Memory was too small, or another program failed. */
        UNMEASURED
    }
}
