package lightning.format.mesh;

/** The limits of a file of meshes, so that no file exhausts the machine. */
public final class MeshLimits {
    /** Bytes of one file: as many as an array can hold, room for ten million triangles in any format. */
    public static final int FILE_BYTES = Integer.MAX_VALUE - 64;
    /** Vertices of all meshes of a file together, and of any one. */
    public static final int VERTICES = 64_000_000;
    /** Triangles of all meshes of a file together, and of any one. */
    public static final int TRIANGLES = 64_000_000;
    /** Parts of one file. */
    public static final int PARTS = 100_000;
    /** Bytes of one line of a header, or of one word, in files of text. */
    public static final int WORD_BYTES = 1000;

    private MeshLimits() {}
}
