package lightning.editor.window.match;

import java.util.Optional;

/**
 * Rectangle of a picture, in shares of its width and height.
 *
 * @param left 0 to 1; {@code top}, {@code right} and {@code bottom} too
 */
record MatchRegion(double left, double top, double right, double bottom) {
    /** Smallest side. */
    private static final double LEAST = 0.01;

    /** Returns the rectangle between two corners; empty if it is too small to be meant. */
    static Optional<MatchRegion> between(double x, double y, double otherX, double otherY) {
        MatchRegion region = new MatchRegion(Math.min(x, otherX), Math.min(y, otherY), Math.max(x, otherX), Math.max(y, otherY));
        return region.right - region.left < LEAST || region.bottom - region.top < LEAST ? Optional.empty() : Optional.of(region);
    }

    boolean contains(double x, double y) {
        return x >= left && x < right && y >= top && y < bottom;
    }
}
