package lightning.accuracy;

import lightning.image.Film;
import lightning.relight.Update;

/**
 * One level of the ladder: what it costs and what it shows.
 *
 * @param time   milliseconds from the edit to the finished film
 * @param error  how far the picture is from the full trace
 * @param film   the picture, at full size
 * @param update what the re-render did; null for {@link Level#FULL_TRACE}. Of {@link Level#EXACT_UPDATED} it is the
 *               plan of the mirrors' update, and the work of both
 */
public record Rung(Level level, Timing time, PictureError error, Film film, Update update) {}
