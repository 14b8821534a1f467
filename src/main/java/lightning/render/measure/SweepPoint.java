package lightning.render.measure;

import lightning.render.image.Film;
import lightning.render.relight.UpdateResult;
import org.jspecify.annotations.Nullable;

/**
 * Cost and image of one accuracy setting.
 *
 * @param time   milliseconds from the edit to the finished film
 * @param error  error against the full trace
 * @param film   image at full size
 * @param update work of the re-render; null for {@link AccuracySetting#FULL_TRACE}. For {@link AccuracySetting#EXACT_UPDATED}, the plan of
 *         the reflections' update and the work of both
 */
public record SweepPoint(AccuracySetting setting, Timing time, PictureError error, Film film, @Nullable UpdateResult update) {}
