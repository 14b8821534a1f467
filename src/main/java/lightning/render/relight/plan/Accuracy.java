package lightning.render.relight.plan;

/** How an edit is carried out. */
public enum Accuracy {
    /** The paper's update on stored contributions, with a running error bound. */
    RATIO,
    /** Bit-equal to a full trace. */
    EXACT;

    /** Whether films have the bits of a full trace. */
    public boolean isExact() {
        return this == EXACT;
    }
}
