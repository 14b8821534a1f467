package lightning.document.loop;

/** Expected time of tracing paths of indirect light again after an edit of objects, from the last such update. Not thread-safe. */
final class PathTimes {
    /** Usual time from which a picture with direct light is shown first, in seconds. */
    static final double SLOW_SECONDS = 0.15;
    /** Usual time of an edit's paths, relative to that of all paths: half of the rays and filters are kept. */
    private static final double REPEATED_SHARE = 0.5;

    private final double slowSeconds;
    private double pathSeconds;
    private double directSeconds;

    /** @param slowSeconds time from which a picture with direct light is shown first, in seconds */
    PathTimes(double slowSeconds) {
        this.slowSeconds = slowSeconds;
    }

    /** Returns whether the next edit of objects is expected to spend long on paths. */
    boolean areSlow() {
        return pathSeconds > slowSeconds;
    }

    /** Records that all paths were built, for a picture with direct light. */
    void recordBuild(double seconds) {
        pathSeconds = REPEATED_SHARE * seconds;
    }

    /**
     * Records an edit of objects in two steps.
     *
     * @param direct time of the update with direct light, in seconds
     * @param both   time of the update with direct and indirect light
     */
    void recordSteps(double direct, double both) {
        directSeconds = direct;
        pathSeconds = Math.max(0, both - direct);
    }

    /** Records an edit of objects in one step. */
    void recordUpdate(double seconds) {
        pathSeconds = Math.max(0, seconds - directSeconds);
    }
}
