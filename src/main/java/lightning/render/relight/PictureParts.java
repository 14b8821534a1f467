package lightning.render.relight;

/** Parts of an anti-aliased picture whose memory is checked. */
enum PictureParts {
    /** Pixel centers, without the finer samples at edges. */
    CENTERS,
    /** Pixel centers and finer samples. */
    ALL
}
