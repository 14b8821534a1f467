package lightning.format.jen;

/**
 * The limits of a scene file and its textures, so that no file exhausts the machine. Those of the
 * scene itself (counts, nesting, ranges) are in {@link lightning.scene.SceneLimits}.
 */
public final class JenLimits {
    /** Bytes of a scene file: 256 MiB, room for a million shapes of 268 bytes each. */
    public static final int FILE_BYTES = 256 << 20;
    /** Words, numbers, strings and braces in a scene file. */
    public static final int TOKENS = 40_000_000;
    /** Characters of one word, number or string. */
    public static final int TOKEN_LENGTH = 1000;
    /** Problems reported for one file; reading stops there. */
    public static final int PROBLEMS = 100;
    /** Different mesh files of one scene. */
    public static final int MESHES = 256;
    /** Triangles of all mesh files of one scene together. */
    public static final int TRIANGLES = 64_000_000;
    /** Different texture files of one scene. */
    public static final int TEXTURES = 256;
    /** Different profiles of lights of one scene: at most 2 MiB each when read. */
    public static final int PROFILES = 64;
    /** Bytes of one texture file: 64 MiB. */
    public static final int TEXTURE_BYTES = 64 << 20;
    /** Pixels along either side of a texture. */
    public static final int TEXTURE_SIDE = 16_384;
    /** Pixels of one texture: 16 Mi, which are 192 MiB when decoded. */
    public static final int TEXTURE_PIXELS = 16 << 20;
    /** Pixels of all textures of one scene together: 64 Mi, which are 768 MiB when decoded. */
    public static final long TOTAL_TEXTURE_PIXELS = 64 << 20;

    private JenLimits() {}
}
