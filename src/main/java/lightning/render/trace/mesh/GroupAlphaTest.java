package lightning.render.trace.mesh;

/** Tells where rays of a group pass a mesh that they meet. */
@FunctionalInterface
public interface GroupAlphaTest {
    /**
     * Whether a triangle that is met at a distance has a hole there.
     *
     * @param ray ray i of packet k has the number {@code k · WIDTH + i}
     */
    boolean passes(int ray, int triangle, double t);
}
