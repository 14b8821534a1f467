package lightning.bench.accuracy;

/** A picture is not what its grade of accuracy promises: it is not worth measuring. */
public final class BrokenPromise extends RuntimeException {
    private static final long serialVersionUID = 1;

    private BrokenPromise(String message) {
        super(message);
    }

    /**
     * Requires that a grade's picture is what it promises.
     *
     * @throws BrokenPromise if it is not; the message says how far it is off
     */
    static void require(Verification verification, Grade grade) {
        if (!verification.isKept()) {
            throw new BrokenPromise("grade " + grade.label() + ": " + verification.text() + "; not measured");
        }
    }
}
