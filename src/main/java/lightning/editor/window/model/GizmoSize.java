package lightning.editor.window.model;

import lightning.base.text.Messages;

/** How large the lights' wireframes are drawn. */
public enum GizmoSize {
    SMALL(Messages.key("Small"), 0.6), NORMAL(Messages.key("Normal"), 1), LARGE(Messages.key("Large"), 1.6);

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
        return Messages.tr(title);
    }
}
