package lightning.render.measure;

/** Exception for an image that violates the guarantee of its accuracy setting, and is therefore not measured. */
public final class GuaranteeViolation extends RuntimeException {
    private static final long serialVersionUID = 1;

    private GuaranteeViolation(String message) {
        super(message);
    }

    /**
     * Requires that the image of a setting satisfies its guarantee.
     *
     * @throws GuaranteeViolation if it does not; the message contains the difference
     */
    static void require(Verification verification, AccuracySetting setting) {
        if (!verification.hasPassed()) {
            throw new GuaranteeViolation("accuracy setting " + setting.label() + ": " + verification.text() + "; not measured");
        }
    }
}
