package lightning.render.trace.mesh;

/** Alpha test of a group's rays against a mesh with cutouts. */
@FunctionalInterface
public interface GroupAlphaTest {
    /**
     * Returns whether a triangle has a hole where a ray hits it at a distance.
     *
     * @param ray ray number: {@code k · WIDTH + i} for ray i of packet k
     */
    boolean isHole(int ray, int triangle, double t);
}
