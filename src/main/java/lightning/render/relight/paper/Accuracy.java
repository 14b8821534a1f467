package lightning.render.relight.paper;

/** Accuracy of updates after an edit. */
public enum Accuracy {
    /** The paper's update on stored contributions, with a running error bound. */
    RATIO,
    /** Bit-equal to a full trace. */
    EXACT;

    /** Returns whether films have the bits of a full trace. */
    public boolean isExact() {
        return this == EXACT;
    }
}
