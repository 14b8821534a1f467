package lightning.format.mesh;

/** Limits of a mesh file, so that no file exhausts the machine. */
public final class MeshLimits {
    /** Maximum file size in bytes: that of an array, enough for ten million triangles in any format. */
    public static final int FILE_BYTES = Integer.MAX_VALUE - 64;
    /** Maximum number of vertices in all meshes of a file. */
    public static final int VERTICES = 64_000_000;
    /** Maximum number of triangles in all meshes of a file. */
    public static final int TRIANGLES = 64_000_000;
    /** Maximum number of parts of a file. */
    public static final int PARTS = 100_000;
    /** Maximum bytes of a header line, or of a token in a text file. */
    public static final int WORD_BYTES = 1000;

    private MeshLimits() {}
}
