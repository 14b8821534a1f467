package lightning.editor.window.model;

import lightning.base.text.Messages;
import lightning.render.RenderOptions;
import lightning.render.relight.paper.Accuracy;
import lightning.render.relight.paper.ReflectionMode;

/** Accuracy setting of the editor: the accuracy of updates and the handling of reflections. */
public enum AccuracyMode {
    EXACT(Messages.key("Exact"), Messages.key("Bit-identical to a full trace, reflections included"),
            Accuracy.EXACT, ReflectionMode.CURRENT),
    ON_DEMAND(Messages.key("Exact, reflections on request"),
            Messages.key("Bit-identical to a full trace, but reflections stay out of date until Update Reflections"),
            Accuracy.EXACT, ReflectionMode.STALE),
    RATIO(Messages.key("Fast, approximate (1998 method)"),
            Messages.key("The paper's ratio update, with a displayed error bound and reflections on request"),
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

    /** Returns the mode for another file. An approximation is a choice for one file. */
    public AccuracyMode forOtherFile() {
        return accuracy == Accuracy.EXACT ? this : EXACT;
    }

    @Override
    public String toString() {
        return Messages.tr(title);
    }
}
