package lightning.shot;

import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import lightning.render.image.Film;

/**
 * What was done for a frame.
 *
 * @param traced      whether it began with a first pass; else it was relit
 * @param plan        what was done, in words
 * @param rays        cast
 * @param nanoseconds from the wish to the finished film
 * @param filmSource      gives the film, from afar where it is kept there
 */
public record FrameUpdate(int frame, boolean traced, String plan, long rays, long nanoseconds, Supplier<Film> filmSource) {

    /**
     * The film of the whole frame; nobody writes to it any more. May wait for another machine.
     *
     * @throws CancellationException if it is there no more: a newer edit took its place, or what held it is lost
     */
    public Film film() {
        return filmSource.get();
    }
}
