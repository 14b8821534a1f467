package lightning.format.jen.asset;

/**
 * Limits of a scene file and its assets, so that no file exhausts the machine. Limits of the scene itself (counts, nesting,
 * ranges) are in {@link lightning.scene.value.SceneLimits}.
 */
public final class JenLimits {
    /** Maximum size of a scene file in bytes: 256 MiB, enough for a million shapes of 268 bytes each. */
    public static final int FILE_BYTES = 256 << 20;
    /** Maximum number of tokens in a scene file. */
    public static final int TOKENS = 40_000_000;
    /** Maximum length of a token in characters. */
    public static final int TOKEN_LENGTH = 1000;
    /** Maximum number of problems reported for one file; reading stops there. */
    public static final int PROBLEMS = 100;
    /** Maximum number of mesh files of a scene. */
    public static final int MESHES = 256;
    /** Maximum number of triangles in all mesh files of a scene. */
    public static final int TRIANGLES = 64_000_000;
    /** Maximum number of texture files of a scene. */
    public static final int TEXTURES = 256;
    /** Maximum number of light profiles of a scene, at most 2 MiB each in memory. */
    public static final int PROFILES = 64;
    /** Maximum size of a texture file in bytes: 64 MiB. */
    public static final int TEXTURE_BYTES = 64 << 20;
    /** Maximum width and height of a texture in pixels. */
    public static final int TEXTURE_SIDE = 16_384;
    /** Maximum number of pixels of a texture: 16 Mi, 192 MiB when decoded. */
    public static final int TEXTURE_PIXELS = 16 << 20;
    /** Maximum number of pixels of all textures of a scene that are not reduced: 64 Mi, 768 MiB when decoded. */
    public static final long TOTAL_TEXTURE_PIXELS = 64 << 20;
    /** Maximum number of pixels of the textures that are reduced because of the limit above: each has at most half of those that are left. */
    static final long REDUCED_TEXTURE_PIXELS = 32 << 20;

    private JenLimits() {}
}
