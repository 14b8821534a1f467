package lightning.render.lobe;

/**
 * Directions into which a GGX surface reflects a view, in the frame of its normal: the normal is z, and the view lies in the plane of x and z.
 * Microfacet normals are distributed as the view sees them (J. Dupuy and A. Benyoub, Sampling visible GGX normals with spherical caps, 2023).
 * The weight of a direction then is its masking (B. Walter and others, Microfacet models for refraction through rough surfaces, 2007), which
 * is independent of that of the view, as in the lighting equation. A surface may have two widths, along a direction and across it. One instance per
 * thread.
 */
public final class ReflectionLobe {
    /** View in the frame of the widths; y is 0 if they are equal. */
    private double viewX;
    private double viewY;
    private double viewZ;
    private double alpha;
    private double alphaY;
    /** Direction of the first width in the frame of the view; x for equal ones. */
    private double turnX;
    private double turnY;
    private boolean isRound;
    /** View, stretched to that of a hemisphere. */
    private double stretchedX;
    private double stretchedY;
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
     * @param alpha  width α, above 0
     */
    public void aim(double cosine, double alpha) {
        viewX = Math.sqrt(Math.max(0, 1 - cosine * cosine));
        viewY = 0;
        viewZ = cosine;
        this.alpha = alpha;
        alphaY = alpha;
        isRound = true;
        double length = Math.sqrt(alpha * alpha * viewX * viewX + viewZ * viewZ);
        stretchedX = alpha * viewX / length;
        stretchedY = 0;
        stretchedZ = viewZ / length;
    }

    /**
     * Sets the view and the roughness of an anisotropic surface.
     *
     * @param cosine of the angle between the normal and the view, above 0
     * @param along  α along the direction, above 0
     * @param across α across it, above 0
     * @param x      component x of the direction, perpendicular to the normal, with {@code y}; of length 1
     */
    public void aim(double cosine, double along, double across, double x, double y) {
        double sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
        turnX = x;
        turnY = y;
        viewX = sine * x;
        viewY = -sine * y;
        viewZ = cosine;
        alpha = along;
        alphaY = across;
        isRound = false;
        double length = stretched(viewX, viewY, viewZ);
        stretchedX = alpha * viewX / length;
        stretchedY = alphaY * viewY / length;
        stretchedZ = viewZ / length;
    }

    private double stretched(double a, double b, double c) {
        return Math.sqrt(alpha * alpha * (a * a) + alphaY * alphaY * (b * b) + c * c);
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
        double hy = alphaY * (radius * sin + stretchedY);
        double hz = Math.max(0, capZ + stretchedZ);
        double length = Math.sqrt(hx * hx + hy * hy + hz * hz);
        if (!(length > 0)) {
            hz = 1;
            length = 1;
        }
        double vh = (viewX * hx + viewY * hy + viewZ * hz) / length;
        double twice = 2 * vh / length;
        x = twice * hx - viewX;
        y = twice * hy - viewY;
        z = twice * hz - viewZ;
        if (isRound) {
            weigh(hz / length, vh);
        } else {
            weighStretched(hx / length, hy / length, hz / length, vh);
            turn();
        }
        facetX = hx / length;
        facetY = hy / length;
        facetZ = hz / length;
        facetCosine = vh;
    }

    /** Turns the direction from the frame of the widths to that of the view. */
    private void turn() {
        double a = turnX * x - turnY * y;
        y = turnY * x + turnX * y;
        x = a;
    }

    /**
     * Replaces the direction of {@link #reflect} of a surface with one width by the one that passes the same facet, below the surface.
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
        x = isRound ? toX : turnX * toX + turnY * toY;
        y = isRound ? toY : turnX * toY - turnY * toX;
        z = toZ;
        double hx = viewX + x;
        double hy = viewY + y;
        double hz = viewZ + z;
        double length = Math.sqrt(hx * hx + hy * hy + hz * hz);
        double vh = (viewX * hx + viewY * hy + viewZ * hz) / length;
        if (isRound) {
            weigh(hz / length, vh);
        } else {
            weighStretched(hx / length, hy / length, hz / length, vh);
            x = toX;
            y = toY;
        }
    }

    /** Weighs the direction of a surface with two widths. @param vh cosine between the view and the facet's normal */
    private void weighStretched(double facetsX, double facetsY, double facetsZ, double vh) {
        weight = z > 0 ? 2 * z / (z + stretched(x, y, z)) : 0;
        double rest = 1 - Math.clamp(vh, 0, 1);
        schlick = rest * rest * (rest * rest) * rest;
        double a = facetsX / alpha;
        double b = facetsY / alphaY;
        double t = a * a + b * b + facetsZ * facetsZ;
        density = facetsZ < 0 ? 0 : 1 / (Math.PI * alpha * alphaY * t * t) / (2 * (viewZ + stretched(viewX, viewY, viewZ)));
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
