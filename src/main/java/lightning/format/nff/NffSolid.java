package lightning.format.nff;

import lightning.base.math.Vec3;

/** Analytic shape, in scene units. */
public sealed interface NffSolid {
    /** Returns the index of its fill; −1 for none. */
    int fill();

    /**
     * Sphere.
     *
     * @param radius at least 0
     */
    record Sphere(int fill, Vec3 center, double radius) implements NffSolid {}

    /**
     * Truncated cone, or a cylinder if both radii are equal; open at both ends.
     *
     * @param baseRadius at least 0
     * @param apexRadius at least 0
     */
    record Cone(int fill, Vec3 base, double baseRadius, Vec3 apex, double apexRadius) implements NffSolid {}
}
