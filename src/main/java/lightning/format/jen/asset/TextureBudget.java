package lightning.format.jen.asset;

/** Pixels that the textures of a scene may still have. */
final class TextureBudget {
    private long whole = JenLimits.TOTAL_TEXTURE_PIXELS;
    private long reduced = JenLimits.REDUCED_TEXTURE_PIXELS;

    /**
     * Returns the maximum number of pixels of the next texture: at least its own number if it can be whole, and at least 0.
     *
     * @param pixels number of pixels of its file
     */
    long limit(long pixels) {
        long limit = Math.min(whole, JenLimits.TEXTURE_PIXELS);
        return pixels <= limit || limit == JenLimits.TEXTURE_PIXELS ? limit : Math.min(reduced / 2, JenLimits.TEXTURE_PIXELS);
    }

    /**
     * Counts a texture.
     *
     * @param pixels number of pixels of its file
     * @param used number of its own pixels
     */
    void use(long pixels, long used) {
        if (used == pixels || whole >= JenLimits.TEXTURE_PIXELS) {
            whole -= used;
        } else {
            reduced -= used;
        }
    }
}
