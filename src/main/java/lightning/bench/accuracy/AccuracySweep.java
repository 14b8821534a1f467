package lightning.bench.accuracy;

import java.util.List;
import lightning.render.image.Film;
import lightning.render.shading.RayCounts;
import lightning.scene.Scene;

/**
 * What each grade of accuracy costs for one edit, and how far its picture is from the full trace.
 *
 * @param original the picture before the edit
 * @param points    one for each {@link AccuracySetting} that the scene has, in their order
 * @param fullRays the rays of the full trace
 * @param isWarm     whether Java was warm to all of it: else the times tell little, and what they save nothing
 */
public record AccuracySweep(Scene before, Scene after, Film original, List<SweepPoint> points, RayCounts fullRays, boolean isWarm) {
    public AccuracySweep {
        points = List.copyOf(points);
    }

    /** @throws java.util.NoSuchElementException if the scene has no such grade */
    public SweepPoint point(AccuracySetting setting) {
        return points.stream().filter(point -> point.setting() == setting).findFirst().orElseThrow();
    }

    /** Percent of the full trace's time that a grade saves; negative where it takes longer. */
    public double saving(AccuracySetting setting) {
        return point(setting).time().percentSavedOf(point(AccuracySetting.FULL_TRACE).time().median());
    }
}
