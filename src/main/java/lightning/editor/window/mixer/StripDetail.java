package lightning.editor.window.mixer;

/** Parts of the mixer's strips that fit into the mixer's height. */
enum StripDetail {
    /** Thumbnail, share, fader, both numbers and switches. */
    FULL,
    /** As {@link #FULL}, without the thumbnail. */
    NO_THUMBNAIL,
    /** Fader, stops and switches. */
    NO_INTENSITY,
    /** Fader and switches. */
    FADER_ONLY;

    /** Minimum height of a mixer with thumbnails, pixels. */
    private static final double FULL_HEIGHT = 316;
    /** Minimum height of a mixer with both numbers, pixels. */
    private static final double NUMBERS_HEIGHT = 248;
    /** Minimum height of a mixer with stops, pixels. */
    private static final double STOPS_HEIGHT = 192;

    /** Returns whether a strip that shows this much has all parts of the other. */
    boolean includes(StripDetail other) {
        return compareTo(other) <= 0;
    }

    /** @param height height of the mixer, pixels */
    static StripDetail of(double height) {
        return height >= FULL_HEIGHT ? FULL
                : height >= NUMBERS_HEIGHT ? NO_THUMBNAIL : height >= STOPS_HEIGHT ? NO_INTENSITY : FADER_ONLY;
    }
}
