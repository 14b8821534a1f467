package lightning.render.trace.mesh;

/** Code by which single rays are tested against boxes and triangles of meshes. Both find the same hits. */
public enum MeshTests {
    /** Plain loops, which are fast soon after the start of a process. */
    LOOPS,
    /** Vector lanes: about twice as fast, once the second compiler has compiled them. */
    LANES;

    private static volatile MeshTests current = LOOPS;

    /** Returns the tests that this process uses. */
    public static MeshTests current() {
        return current;
    }

    /** Sets the tests for all further rays. Compiled code belongs to the process, and so does this setting. */
    public static void use(MeshTests tests) {
        current = tests;
    }
}
