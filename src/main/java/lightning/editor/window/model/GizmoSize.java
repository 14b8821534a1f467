package lightning.editor.window.model;

import lightning.base.text.Messages;

/** Display size of the lights' wireframes. */
public enum GizmoSize {
    SMALL(Messages.key("Small"), 0.6), NORMAL(Messages.key("Normal"), 1), LARGE(Messages.key("Large"), 1.6);

    private final String title;
    private final double factor;

    GizmoSize(String title, double factor) {
        this.title = title;
        this.factor = factor;
    }

    /** Returns the factor relative to the normal size. */
    public double factor() {
        return factor;
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
