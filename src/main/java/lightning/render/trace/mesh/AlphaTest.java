package lightning.render.trace.mesh;

/** Tells where a ray passes a mesh that it meets. */
@FunctionalInterface
public interface AlphaTest {
    /** Whether a triangle that is met at a distance has a hole there. */
    boolean passes(int triangle, double t);
}
