package lightning.bench.accuracy;

/** A picture is not what its grade of accuracy promises: it is not worth measuring. */
public final class GuaranteeViolation extends RuntimeException {
    private static final long serialVersionUID = 1;

    private GuaranteeViolation(String message) {
        super(message);
    }

    /**
     * Requires that a grade's picture is what it promises.
     *
     * @throws GuaranteeViolation if it is not; the message says how far it is off
     */
    static void require(Verification verification, AccuracySetting setting) {
        if (!verification.hasPassed()) {
            throw new GuaranteeViolation("accuracy setting " + setting.label() + ": " + verification.text() + "; not measured");
        }
    }
}
