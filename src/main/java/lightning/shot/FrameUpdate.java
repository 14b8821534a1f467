package lightning.shot;

import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import lightning.render.image.Film;

/**
 * Result of a frame's update.
 *
 * @param traced      true for a full trace, false for a relight
 * @param plan        description of the update
 * @param rays        number of rays
 * @param nanoseconds from the request to the finished film
 * @param filmSource  supplier of the film, which may fetch it from a remote host
 */
public record FrameUpdate(int frame, boolean traced, String plan, long rays, long nanoseconds, Supplier<Film> filmSource) {

    /**
     * Returns the film of the whole frame, which is not written any more. May wait for another machine.
     *
     * @throws CancellationException if the film is gone: replaced by a newer revision, or lost with its host
     */
    public Film film() {
        return filmSource.get();
    }
}
