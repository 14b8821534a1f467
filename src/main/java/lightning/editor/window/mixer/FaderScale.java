package lightning.editor.window.mixer;

/**
 * Scale of a fader: a hyperbolic sine, on which stops near 0 have most of the travel. With a range of 10 stops, the middle 6 have 59 % of it.
 *
 * @param range distance of both ends from 0, stops
 */
record FaderScale(double range) {
    /** Hyperbolic angle of the ends. */
    private static final double END = 3;
    /** Minimum travel, pixels: a low fader moves less than the mouse, so that a drag of 20 pixels stays below one stop. */
    private static final double MIN_TRAVEL = 160;

    /** Returns the position of a value in stops: −1 at the lower end, 0 at 0 stops, 1 at the upper end. */
    double position(double stops) {
        double x = Math.clamp(stops, -range, range) / range * Math.sinh(END);
        return Math.clamp(Math.copySign(Math.log(Math.abs(x) + Math.hypot(x, 1)), x) / END, -1, 1);
    }

    /** Returns the stops at a position from −1 to 1. */
    double stops(double position) {
        return Math.abs(position) == 1 ? position * range : range * Math.sinh(END * position) / Math.sinh(END);
    }

    /**
     * Returns the change of the position by a drag.
     *
     * @param pixels distance of the drag upward
     * @param length length of the fader, pixels
     */
    static double drag(double pixels, double length) {
        return 2 * pixels / Math.max(MIN_TRAVEL, length);
    }
}
