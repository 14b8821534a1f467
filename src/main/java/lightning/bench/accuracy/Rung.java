package lightning.bench.accuracy;

import lightning.render.image.Film;
import lightning.render.relight.Update;

/**
 * One grade of the ladder: what it costs and what it shows.
 *
 * @param time   milliseconds from the edit to the finished film
 * @param error  how far the picture is from the full trace
 * @param film   the picture, at full size
 * @param update what the re-render did; null for {@link Grade#FULL_TRACE}. Of {@link Grade#EXACT_UPDATED} it is the
 *               plan of the mirrors' update, and the work of both
 */
public record Rung(Grade grade, Timing time, PictureError error, Film film, Update update) {}
