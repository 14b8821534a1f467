package lightning.render.trace.mesh;

/** Alpha test of one ray against a mesh with cutouts. */
@FunctionalInterface
public interface AlphaTest {
    /** Returns whether a triangle has a hole where the ray hits it at a distance. */
    boolean isHole(int triangle, double t);
}
