package lightning.bench.accuracy;

import lightning.render.image.Film;
import lightning.render.relight.UpdateResult;

/**
 * One grade of the ladder: what it costs and what it shows.
 *
 * @param time   milliseconds from the edit to the finished film
 * @param error  how far the picture is from the full trace
 * @param film   the picture, at full size
 * @param update what the re-render did; null for {@link AccuracySetting#FULL_TRACE}. Of {@link AccuracySetting#EXACT_UPDATED} it is the
 *               plan of the mirrors' update, and the work of both
 */
public record SweepPoint(AccuracySetting setting, Timing time, PictureError error, Film film, UpdateResult update) {}
