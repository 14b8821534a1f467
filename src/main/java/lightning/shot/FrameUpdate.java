package lightning.shot;

import lightning.image.Film;

/**
 * What was done for a frame.
 *
 * @param traced      whether it began with a first pass; else it was relit
 * @param plan        what was done, in words
 * @param rays        cast
 * @param nanoseconds from the wish to the finished film
 * @param film        of the whole frame; nobody writes to it any more
 */
public record FrameUpdate(int frame, boolean traced, String plan, long rays, long nanoseconds, Film film) {
    public double milliseconds() {
        return nanoseconds / 1e6;
    }
}
