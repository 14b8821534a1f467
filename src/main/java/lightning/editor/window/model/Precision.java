package lightning.editor.window.model;

import lightning.base.text.Texts;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.tile.Options;

/** What the artist chooses between speed and exactness. */
public enum Precision {
    EXACT(Texts.key("Exact"), Texts.key("Equal to a full trace in every bit of every pixel, mirrors too"),
            Accuracy.EXACT, Reflections.CURRENT),
    ON_DEMAND(Texts.key("As in 1998: mirrors on demand"),
            Texts.key("Equal to a full trace in every bit, but mirrors show older lights until Update Reflections"),
            Accuracy.EXACT, Reflections.STALE),
    RATIO(Texts.key("As in 1998: ratio"),
            Texts.key("The paper's own update, which multiplies what is stored, with an error bound that is shown; mirrors on demand"),
            Accuracy.RATIO, Reflections.STALE);

    private final String title;
    private final String explanation;
    private final Accuracy accuracy;
    private final Reflections reflections;

    Precision(String title, String explanation, Accuracy accuracy, Reflections reflections) {
        this.title = title;
        this.explanation = explanation;
        this.accuracy = accuracy;
        this.reflections = reflections;
    }

    public String explanation() {
        return Texts.of(explanation);
    }

    public Options options() {
        return Options.DEFAULT.withAccuracy(accuracy).withReflections(reflections);
    }

    @Override
    public String toString() {
        return Texts.of(title);
    }
}
