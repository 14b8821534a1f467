package lightning.render.measure;

import java.util.List;
import lightning.render.image.Film;
import lightning.render.shading.RayCounts;
import lightning.scene.Scene;

/**
 * Cost and image error of each accuracy setting for one edit.
 *
 * @param original image before the edit
 * @param points   results per {@link AccuracySetting} of the scene, in order
 * @param fullRays rays of the full trace
 * @param isWarm   whether the JIT compiler had finished; otherwise times are unreliable and savings meaningless
 */
public record AccuracySweep(Scene before, Scene after, Film original, List<SweepPoint> points, RayCounts fullRays, boolean isWarm) {
    public AccuracySweep {
        points = List.copyOf(points);
    }

    /** @throws java.util.NoSuchElementException if the scene does not have the setting */
    public SweepPoint point(AccuracySetting setting) {
        return points.stream().filter(point -> point.setting() == setting).findFirst().orElseThrow();
    }

    /** Returns a setting's saving in percent of the full trace's time; negative if slower. */
    public double saving(AccuracySetting setting) {
        return point(setting).time().percentSavedOf(point(AccuracySetting.FULL_TRACE).time().median());
    }
}
