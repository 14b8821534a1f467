package lightning.render.lobe;

/** Directions of a {@link SheenLobe}, in the frame of {@link ReflectionLobe}. All have the same weight. One instance per thread. */
public final class SheenDirections {
    private double roughness = 1;
    private double cosine;
    private double sine;
    private double x;
    private double y;
    private double z;

    /**
     * Sets the sheen and the view.
     *
     * @param itsRoughness of the sheen, 0…1
     * @param cosine of the angle between the normal and the view, above 0
     */
    public void aim(double itsRoughness, double cosine) {
        roughness = itsRoughness;
        this.cosine = cosine;
        sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
    }

    /**
     * Computes a direction.
     *
     * @param share squared distance from the middle of the disk below a hemisphere, 0…1
     * @param cos   of the angle around the normal, with {@code sin}
     */
    public void scatter(double share, double cos, double sin) {
        double radius = Math.sqrt(share);
        double a = SheenLobe.a(roughness, cosine);
        z = Math.sqrt(Math.max(0, 1 - share));
        x = (radius * cos - SheenLobe.slant(roughness, cosine) * sine * z) / a;
        y = radius * sin / a;
        double length = Math.sqrt(x * x + y * y + z * z);
        x /= length;
        y /= length;
        z /= length;
    }

    /** Moves to a unit direction above the surface. */
    public void moveTo(double toX, double toY, double toZ) {
        x = toX;
        y = toY;
        z = toZ;
    }

    /** Returns the density of the directions of {@link #scatter}, per steradian. */
    public double density() {
        return SheenLobe.shape(roughness, cosine, z, sine * x + cosine * z) / Math.PI;
    }

    /** Returns component x of the unit direction. */
    public double x() {
        return x;
    }

    /** Returns component y of the unit direction. */
    public double y() {
        return y;
    }

    /** Returns component z of the unit direction, above 0. */
    public double z() {
        return z;
    }
}
