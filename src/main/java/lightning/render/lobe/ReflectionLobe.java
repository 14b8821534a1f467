package lightning.render.lobe;

/**
 * Directions into which a GGX surface reflects a view, in the frame of its normal: the normal is z, and the view lies in the plane of x and z.
 * Microfacet normals are distributed as the view sees them (J. Dupuy and A. Benyoub, Sampling visible GGX normals with spherical caps, 2023).
 * The weight of a direction then is its masking (B. Walter and others, Microfacet models for refraction through rough surfaces, 2007), which
 * is independent of that of the view, as in the lighting equation. One instance per thread.
 */
public final class ReflectionLobe {
    private double viewX;
    private double viewZ;
    private double alpha;
    /** View, stretched to that of a hemisphere. */
    private double stretchedX;
    private double stretchedZ;
    private double x;
    private double y;
    private double z;
    private double weight;
    private double schlick;
    private double density;
    /** Normal of the facet, and the cosine between it and the view. */
    private double facetX;
    private double facetY;
    private double facetZ;
    private double facetCosine;

    /**
     * Sets the view and the roughness.
     *
     * @param cosine of the angle between the normal and the view, above 0
     * @param width  α, above 0
     */
    public void aim(double cosine, double width) {
        viewX = Math.sqrt(Math.max(0, 1 - cosine * cosine));
        viewZ = cosine;
        alpha = width;
        double length = Math.sqrt(alpha * alpha * viewX * viewX + viewZ * viewZ);
        stretchedX = alpha * viewX / length;
        stretchedZ = viewZ / length;
    }

    /**
     * Computes a direction.
     *
     * @param share height in the cap of visible normals, 0…1
     * @param cos   of the angle around it, with {@code sin}
     */
    public void reflect(double share, double cos, double sin) {
        double capZ = (1 - share) * (1 + stretchedZ) - stretchedZ;
        double radius = Math.sqrt(Math.max(0, 1 - capZ * capZ));
        double hx = alpha * (radius * cos + stretchedX);
        double hy = alpha * (radius * sin);
        double hz = Math.max(0, capZ + stretchedZ);
        double length = Math.sqrt(hx * hx + hy * hy + hz * hz);
        if (!(length > 0)) {
            hz = 1;
            length = 1;
        }
        double vh = (viewX * hx + viewZ * hz) / length;
        double twice = 2 * vh / length;
        x = twice * hx - viewX;
        y = twice * hy;
        z = twice * hz - viewZ;
        weigh(hz / length, vh);
        facetX = hx / length;
        facetY = hy / length;
        facetZ = hz / length;
        facetCosine = vh;
    }

    /**
     * Replaces the direction of {@link #reflect} by the one that passes the same facet, below the surface.
     *
     * @param ior of the body; 1 for a thin sheet, which mirrors the reflected direction to its other side
     */
    public void pass(double ior) {
        if (ior == 1) {
            z = -z;
        } else {
            double eta = 1 / ior;
            double along = eta * facetCosine - Math.sqrt(Math.max(0, 1 - eta * eta * (1 - facetCosine * facetCosine)));
            x = along * facetX - eta * viewX;
            y = along * facetY;
            z = along * facetZ - eta * viewZ;
        }
        double square = alpha * alpha;
        weight = z < 0 ? -2 * z / (-z + Math.sqrt(square + (1 - square) * (z * z))) : 0;
        density = 0;
    }

    /** Moves to a unit direction. */
    public void moveTo(double toX, double toY, double toZ) {
        x = toX;
        y = toY;
        z = toZ;
        double hx = viewX + x;
        double hz = viewZ + z;
        double length = Math.sqrt(hx * hx + y * y + hz * hz);
        weigh(hz / length, (viewX * hx + viewZ * hz) / length);
    }

    /** @param nh cosine between the normal and that of the facet, as {@code vh} between the view and the facet's */
    private void weigh(double nh, double vh) {
        double square = alpha * alpha;
        weight = z > 0 ? 2 * z / (z + Math.sqrt(square + (1 - square) * (z * z))) : 0;
        double rest = 1 - Math.clamp(vh, 0, 1);
        schlick = rest * rest * (rest * rest) * rest;
        double t = nh * nh * (square - 1) + 1;
        // Facets below the surface are not seen.
        density = nh < 0 ? 0 : square / (Math.PI * t * t) / (2 * (viewZ + Math.sqrt(square + (1 - square) * (viewZ * viewZ))));
    }

    /** Returns the density of the directions of {@link #reflect}, per steradian. */
    public double density() {
        return density;
    }

    /** Returns component x of the unit direction. */
    public double x() {
        return x;
    }

    /** Returns component y of the unit direction. */
    public double y() {
        return y;
    }

    /** Returns component z of the direction: 0 or less below the surface. */
    public double z() {
        return z;
    }

    /** Returns the share of the light from the direction that the surface reflects if its facets are perfect mirrors, 0…1. */
    public double weight() {
        return weight;
    }

    /** Returns (1 − V·H)⁵: facets reflect F0·(1 − that) + that. */
    public double schlick() {
        return schlick;
    }
}
