package lightning.format.mesh.obj;

/**
 * Image of a material with its options.
 *
 * @param path       path as written
 * @param isNormal   true if it is a normal map in any case: the statement norm
 * @param multiplier -bm, strength of a bump or normal map
 * @param scaleU     -s, repetitions along u
 * @param scaleV     repetitions along v
 * @param offsetU    -o, added to the scaled coordinate u
 * @param offsetV    added to the scaled coordinate v
 * @param isClamped  -clamp, true if its edge pixels are repeated instead of the image
 */
public record MtlImage(String path, boolean isNormal, double multiplier, double scaleU, double scaleV, double offsetU, double offsetV,
        boolean isClamped) {
    /** Creates an image without options. */
    public MtlImage(String path) {
        this(path, false, 1, 1, 1, 0, 0, false);
    }

    /** Returns whether it is moved. */
    public boolean isMoved() {
        return offsetU != 0 || offsetV != 0;
    }

    /** Returns whether both are moved by as much. */
    public boolean isMovedLike(MtlImage other) {
        return offsetU == other.offsetU && offsetV == other.offsetV;
    }
}
