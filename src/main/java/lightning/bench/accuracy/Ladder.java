package lightning.bench.accuracy;

import java.util.List;
import lightning.render.image.Film;
import lightning.render.shading.TraceCounts;
import lightning.scene.Scene;

/**
 * What each grade of accuracy costs for one edit, and how far its picture is from the full trace.
 *
 * @param original the picture before the edit
 * @param rungs    one for each {@link Grade} that the scene has, in their order
 * @param fullRays the rays of the full trace
 * @param warm     whether Java was warm to all of it: else the times tell little, and what they save nothing
 */
public record Ladder(Scene before, Scene after, Film original, List<Rung> rungs, TraceCounts fullRays, boolean warm) {
    public Ladder {
        rungs = List.copyOf(rungs);
    }

    /** @throws java.util.NoSuchElementException if the scene has no such grade */
    public Rung rung(Grade grade) {
        return rungs.stream().filter(rung -> rung.grade() == grade).findFirst().orElseThrow();
    }

    /** Percent of the full trace's time that a grade saves; negative where it takes longer. */
    public double saving(Grade grade) {
        return rung(grade).time().savingOf(rung(Grade.FULL_TRACE).time().median());
    }
}
