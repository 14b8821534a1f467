package lightning.render.trace.mesh;

import java.util.function.Supplier;

/**
 * Tests of a single ray against the eight boxes of a node or the eight triangles of a leaf, in place of the loops of {@link MeshTraversal} and
 * {@link MeshRay}. They find at least the children and slots that the loops find, so that the hits are the same. Each instance holds the scratch memory
 * of a thread.
 */
abstract class MeshTests {
    /** No tests but the loops, which are fast soon after the start of a process. */
    static final Supplier<MeshTests> LOOPS = () -> {
        throw new IllegalStateException("loops have no tests");
    };

    private static volatile Supplier<MeshTests> current = LOOPS;

    /** Returns the tests that this process uses. */
    static Supplier<MeshTests> current() {
        return current;
    }

    /** Sets the tests for all further rays. Compiled code belongs to the process, and so does this setting. */
    static void use(Supplier<MeshTests> tests) {
        current = tests;
    }

    /**
     * Sets a ray.
     *
     * @param maxCoordinate largest absolute coordinate of the mesh
     * @return false if the tests cannot follow the ray, which is then left to the loops
     */
    abstract boolean setRay(MeshRay ray, double maxCoordinate);

    /**
     * Returns the children of a node, one bit each, whose boxes the padded ray may enter at a distance up to {@code limit}; writes the entry
     * distances of all.
     *
     * @param limit ≥ 0
     */
    abstract int entered(float[] box, int node, double limit);

    /** Returns the entry distances of the children of the last node, not above those of the loops; they may be just below 0. */
    abstract float[] entries();

    /** Returns the slots of {@link MeshRay#hitSlots}. */
    abstract int hitSlots(MeshRay ray, float[] v, int at);
}
