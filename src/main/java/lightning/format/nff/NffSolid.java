package lightning.format.nff;

import lightning.base.math.Vec3;

/** A shape of a formula, in scene units. */
public sealed interface NffSolid {
    /** Which of the file's fills it has; −1 for none. */
    int fill();

    /** @param radius at least 0 */
    record Sphere(int fill, Vec3 center, double radius) implements NffSolid {}

    /**
     * A cone that is cut at both ends, or a cylinder where both radii are the same; open at both ends.
     *
     * @param baseRadius at least 0, as the other one
     */
    record Cone(int fill, Vec3 base, double baseRadius, Vec3 apex, double apexRadius) implements NffSolid {}
}
