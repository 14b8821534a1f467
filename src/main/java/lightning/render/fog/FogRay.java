package lightning.render.fog;

/** Ray along which fog is sampled, in render space. Reused for one ray after the other. */
public final class FogRay {
    /** Origin, scene units. */
    public double ox;
    public double oy;
    public double oz;
    /** Unit direction. */
    public double dx;
    public double dy;
    public double dz;
    /** Phase of its samples, 0…3. */
    public int phase;

    /** Returns x of the point at a distance. */
    public double x(double distance) {
        return ox + distance * dx;
    }

    public double y(double distance) {
        return oy + distance * dy;
    }

    public double z(double distance) {
        return oz + distance * dz;
    }
}
