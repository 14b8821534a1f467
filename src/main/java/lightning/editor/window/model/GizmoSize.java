package lightning.editor.window.model;

import lightning.base.text.Texts;

/** How large the lights' wireframes are drawn. */
public enum GizmoSize {
    SMALL(Texts.key("Small"), 0.6), NORMAL(Texts.key("Normal"), 1), LARGE(Texts.key("Large"), 1.6);

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
        return Texts.of(title);
    }
}
