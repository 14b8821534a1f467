package lightning.accuracy;

/** A picture is not what its level of accuracy promises: it is not worth measuring. */
public final class BrokenPromise extends RuntimeException {
    private static final long serialVersionUID = 1;

    private BrokenPromise(String message) {
        super(message);
    }

    /**
     * Requires that a level's picture is what it promises.
     *
     * @throws BrokenPromise if it is not; the message says how far it is off
     */
    static void require(Verification verification, Level level) {
        if (!verification.isKept()) {
            throw new BrokenPromise("level " + level.label() + ": " + verification.text() + "; not measured");
        }
    }
}
