package lightning.editor.window.model;

import lightning.base.text.Messages;
import lightning.render.relight.plan.Accuracy;
import lightning.render.relight.plan.ReflectionMode;
import lightning.render.relight.tile.RenderOptions;

/** What the artist chooses between speed and exactness. */
public enum AccuracyMode {
    EXACT(Messages.key("Exact"), Messages.key("Equal to a full trace in every bit of every pixel, mirrors too"),
            Accuracy.EXACT, ReflectionMode.CURRENT),
    ON_DEMAND(Messages.key("As in 1998: mirrors on demand"),
            Messages.key("Equal to a full trace in every bit, but mirrors show older lights until Update Reflections"),
            Accuracy.EXACT, ReflectionMode.STALE),
    RATIO(Messages.key("As in 1998: ratio"),
            Messages.key("The paper's own update, which multiplies what is stored, with an error bound that is shown; mirrors on demand"),
            Accuracy.RATIO, ReflectionMode.STALE);

    private final String title;
    private final String explanation;
    private final Accuracy accuracy;
    private final ReflectionMode reflections;

    AccuracyMode(String title, String explanation, Accuracy accuracy, ReflectionMode reflections) {
        this.title = title;
        this.explanation = explanation;
        this.accuracy = accuracy;
        this.reflections = reflections;
    }

    public String explanation() {
        return Messages.tr(explanation);
    }

    public RenderOptions options() {
        return RenderOptions.DEFAULT.withAccuracy(accuracy).withReflections(reflections);
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
