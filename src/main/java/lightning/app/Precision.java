package lightning.app;

import lightning.relight.Accuracy;
import lightning.relight.Options;
import lightning.relight.Reflections;

/** What the artist chooses between speed and exactness. */
public enum Precision {
    RATIO("Ratio", "The paper's update on stored contributions: fastest, with an error bound that is shown",
            Accuracy.RATIO, Reflections.STALE),
    EXACT("Exact", "Bit-equal to a full trace; mirrors show an older light until Update Reflections",
            Accuracy.EXACT, Reflections.STALE),
    CURRENT("Exact, reflections current", "Bit-equal to a full trace in every pixel, mirrors too",
            Accuracy.EXACT, Reflections.CURRENT);

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
        return explanation;
    }

    Options options() {
        return Options.DEFAULT.withAccuracy(accuracy).withReflections(reflections);
    }

    @Override
    public String toString() {
        return title;
    }
}
