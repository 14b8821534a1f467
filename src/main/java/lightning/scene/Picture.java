package lightning.scene;

/**
 * The picture that a scene asks for.
 *
 * @param width    pixels
 * @param height   pixels
 * @param depth    how many mirror bounces are followed, 0 to 10
 * @param sampling how many samples its pixels have
 */
public record Picture(int width, int height, int depth, Sampling sampling) {
    public static final Attribute<Picture, Integer> DEPTH = new Attribute<>("depth", "depth",
            Quantity.whole(0, Limits.MAX_DEPTH), 3, "mirror bounces", Picture::depth, Picture::withDepth);

    public static final Picture DEFAULT = new Picture(200, 200, DEPTH.initial());

    /** One sample a pixel. */
    public Picture(int width, int height, int depth) {
        this(width, height, depth, Sampling.DEFAULT);
    }

    public Picture {
        Limits.range("size: width", width, 1, Limits.MAX_SIZE);
        Limits.range("size: height", height, 1, Limits.MAX_SIZE);
        DEPTH.check(depth);
    }

    public Picture withSize(int newWidth, int newHeight) {
        return new Picture(newWidth, newHeight, depth, sampling);
    }

    public Picture withDepth(int newDepth) {
        return new Picture(width, height, newDepth, sampling);
    }

    public Picture withSampling(Sampling newSampling) {
        return new Picture(width, height, depth, newSampling);
    }
}
