package lightning.app.model;

/** How large the lights' wireframes are drawn. */
public enum GizmoSize {
    SMALL("Small", 0.6), NORMAL("Normal", 1), LARGE("Large", 1.6);

    private final String title;
    private final double factor;

    GizmoSize(String title, double factor) {
        this.title = title;
        this.factor = factor;
    }

    /** What multiplies the normal size. */
    public double factor() {
        return factor;
    }

    @Override
    public String toString() {
        return title;
    }
}
