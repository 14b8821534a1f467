package lightning.render.shading;

import lightning.base.math.PowerFunction;
import lightning.scene.value.Attenuation;
import org.jspecify.annotations.Nullable;

/**
 * Lighting equation (paper §2.2), term by term, for one row and one light.
 *
 * <pre>
 * I     = [(ka·ambience + glow) + kd·Σ Idiff]·(1 − kr) + (ks·Σ Ispec + Σ Igraz) + kr·Cr
 * Idiff = weight·(cosine·falloff)      weight  = color·intensity
 * Ispec = weight·(specular·falloff)    falloff = atten·spot·doors
 * Igraz = weight·(grazing·falloff)     metallic materials only
 * </pre>
 *
 * <p>A clear surface mirrors m = kr + (1 − kr)·F with the Fresnel share F ({@link lightning.render.trace.Refraction}). The path inside
 * transmits T = tint<sup>path/distance</sup> (Beer's law), and b = 1 − the largest channel of kt:
 *
 * <pre>
 * I     = {[(ka·ambience + glow) + kd·Σ Idiff]·(1 − m)·b + (ks·Σ Ispec + Σ Igraz) + m·Cr + (1 − m)·kt·Ct}·T
 * </pre>
 *
 * <p>Metallic materials follow glTF 2.0 (appendix B.3): D is GGX, V is Smith's visibility, F is Schlick's F0 + (1 − F0)·s with
 * s = (1 − V·H)⁵, so that F·D·V = F0·D·V·(1 − s) + D·V·s. As in Phong's model, a white surface reflects 1 under a light of weight 1:
 * the irradiance is π·cosine, which cancels the π of D and of Lambert's law. Diffuse light passes the surface twice
 * (Shirley and others, A practitioners' assessment of light reflection models, 1997, without their factor 21/20):
 * (1 − f0)·(1 − (1 − N·L)⁵)·(1 − (1 − N·V)⁵). Its first factor is part of kd.
 *
 * <p>An instance holds the vector from the row to the light. Points and vectors are in render space. Float parameters were rounded
 * when the row was stored.
 */
public final class LightingEquation {
    /** At smaller distances, the squared distance has too few digits to normalize the vector; the distance counts as 0. */
    public static final double MIN_DISTANCE = 0x1p-500;

    private final LightSource source;
    private double lx;
    private double ly;
    private double lz;
    /** 1 for a directional light. */
    private double distance = 1;
    /** Computed on first use, because most samples of an area light are not lit. */
    private @Nullable AngularMask angularMask;
    private final boolean hasAngularMask;
    private float px;
    private float py;
    private float pz;

    public LightingEquation(LightSource source) {
        this.source = source;
        hasAngularMask = AngularMask.isActive(source);
    }

    /** Moves to a row: its point and its unit normal. At distance 0 the light is straight above. */
    public void moveTo(float x, float y, float z, float nx, float ny, float nz) {
        moveTo(x, y, z, nx, ny, nz, source.position().x(), source.position().y(), source.position().z());
    }

    /**
     * Moves to a row, lit from a place on an area light.
     *
     * @param toX component x of the position of the light, or of its direction if it has no position
     */
    public void moveTo(float x, float y, float z, float nx, float ny, float nz, double toX, double toY, double toZ) {
        px = x;
        py = y;
        pz = z;
        if (!source.type().hasPosition()) {
            aim(toX, toY, toZ, 1);
            return;
        }
        double vx = toX - x;
        double vy = toY - y;
        double vz = toZ - z;
        double d = Math.sqrt(vx * vx + vy * vy + vz * vz);
        double inverse = 1 / d;
        if (d < MIN_DISTANCE) {
            aim(nx, ny, nz, d);
        } else {
            aim(vx * inverse, vy * inverse, vz * inverse, d);
        }
    }

    /** Sets the unit vector to the light, and its distance. */
    public void aim(double x, double y, double z, double newDistance) {
        lx = x;
        ly = y;
        lz = z;
        distance = newDistance;
    }

    /** Returns component x of the unit vector to the light. */
    public double x() {
        return lx;
    }

    /** Returns component y of the unit vector to the light. */
    public double y() {
        return ly;
    }

    /** Returns component z of the unit vector to the light. */
    public double z() {
        return lz;
    }

    /** Returns the distance of the light; 1 for a directional light. */
    public double distance() {
        return distance;
    }

    /** Returns N·L; the row faces away unless this is above 0. A row behind a sample of an object faces away from it: 0. */
    public float cosine(float nx, float ny, float nz) {
        return source.isBehind(px, py, pz) ? 0 : (float) lightCosine(nx, ny, nz);
    }

    /** Returns N·L. */
    public double lightCosine(float nx, float ny, float nz) {
        return nx * lx + ny * ly + nz * lz;
    }

    /** Returns −L·direction, the cosine of the angle between a light's axis and the row, −1…1. */
    public double axisCosine(LightSource of) {
        double c = -(lx * of.axis().x() + ly * of.axis().y() + lz * of.axis().z());
        return c < -1 ? -1 : c > 1 ? 1 : c;
    }

    /** Returns whether the row is in the light's cone, edge included. */
    public boolean insideCone() {
        return !source.hasCone() || axisCosine(source) >= source.cosAngle();
    }

    /**
     * Returns max(V·R, 0)<sup>shininess</sup> with R = 2N(N·−L) + L, both normalized.
     *
     * @param vx component x, as {@code vy} and {@code vz}, of the unit direction of the ray that hit the row
     */
    public float specular(float nx, float ny, float nz, float vx, float vy, float vz, double shininess) {
        double twice = 2 * (nx * lx + ny * ly + nz * lz);
        double rx = lx - twice * nx;
        double ry = ly - twice * ny;
        double rz = lz - twice * nz;
        double dot = vx * rx + vy * ry + vz * rz;
        double lengths = ((double) vx * vx + (double) vy * vy + (double) vz * vz) * (rx * rx + ry * ry + rz * rz);
        double c = dot / Math.sqrt(lengths);
        c = c > 0 ? c : 0;
        c = c > 1 ? 1 : c;
        return (float) PowerFunction.pow(c, shininess);
    }

    /**
     * Returns N·L·(1 − (1 − N·L)⁵)·(1 − (1 − N·V)⁵): the diffuse term of a metallic material, for a row that faces the light.
     *
     * @param vx component x, as {@code vy} and {@code vz}, of the unit direction of the ray that hit the row
     */
    public float metallicDiffuse(float nx, float ny, float nz, float vx, float vy, float vz) {
        double nl = nx * lx + ny * ly + nz * lz;
        double nv = -((double) nx * vx + (double) ny * vy + (double) nz * vz);
        nv = nv > 0 ? nv : 0;
        return (float) (nl * (1 - pow5(1 - nl)) * (1 - pow5(1 - nv)));
    }

    /** Returns α² of a highlight, widened by the light of one sample (see {@link LightSource#highlightWidening}), at most 1. */
    private double widenedSquare(double alpha) {
        return widened(alpha * alpha);
    }

    private double widened(double square) {
        double widening = source.highlightWidening();
        if (widening == 0) {
            return square;
        }
        double widened = square + widening / (distance * distance);
        return widened < 1 ? widened : 1;
    }

    /**
     * Returns N·L·D·V of a metallic material, for a row that faces the light; D without its 1/π. N and H are normalized for their
     * angle. The lengths of the others are off by 2⁻²³, which is not visible.
     *
     * <p>Apart from roundings it is at most 1/(2α³): D is at most 1/α², and V at most 1/(2·N·L·α). That is 6.1e7 for the smallest
     * effective roughness.
     *
     * @param alpha the width of the highlight before it is widened, above 0
     */
    public double facets(float nx, float ny, float nz, float vx, float vy, float vz, double alpha) {
        double hx = lx - vx;
        double hy = ly - vy;
        double hz = lz - vz;
        double nh = nx * hx + ny * hy + nz * hz;
        double lengths = ((double) nx * nx + (double) ny * ny + (double) nz * nz) * (hx * hx + hy * hy + hz * hz);
        double c = nh * nh / lengths;
        // If H has no direction, this is NaN.
        c = c > 0 ? c : 0;
        c = c > 1 ? 1 : c;
        double nl = nx * lx + ny * ly + nz * lz;
        double nv = -((double) nx * vx + (double) ny * vy + (double) nz * vz);
        nv = nv > 0 ? nv : 0;
        double a = widenedSquare(alpha);
        double t = c * (a - 1) + 1;
        double gl = nl + Math.sqrt(a + (1 - a) * (nl * nl));
        double gv = nv + Math.sqrt(a + (1 - a) * (nv * nv));
        return nl * a / (t * t * (gl * gv));
    }

    /** Returns (1 − V·H)⁵ with V and H normalized; 1 if H has no direction. */
    public double schlick(float vx, float vy, float vz) {
        double hx = lx - vx;
        double hy = ly - vy;
        double hz = lz - vz;
        double vh = -(vx * hx + vy * hy + vz * hz);
        double lengths = ((double) vx * vx + (double) vy * vy + (double) vz * vz) * (hx * hx + hy * hy + hz * hz);
        double c = vh / Math.sqrt(lengths);
        c = c > 0 ? c : 0;
        c = c > 1 ? 1 : c;
        return pow5(1 - c);
    }

    private static double pow5(double x) {
        double square = x * x;
        return square * square * x;
    }

    /** Returns N·L·D·V·(1 − (1 − V·H)⁵): the specular term of a metallic material, which F0 multiplies. */
    public float metallicSpecular(float nx, float ny, float nz, float vx, float vy, float vz, double alpha) {
        return (float) (facets(nx, ny, nz, vx, vy, vz, alpha) * (1 - schlick(vx, vy, vz)));
    }

    /** Returns N·L·D·V·(1 − V·H)⁵: the grazing term of a metallic material, which no color multiplies. */
    public float metallicGrazing(float nx, float ny, float nz, float vx, float vy, float vz, double alpha) {
        return (float) (facets(nx, ny, nz, vx, vy, vz, alpha) * schlick(vx, vy, vz));
    }

    /**
     * Returns {@link #facets} of an anisotropic material.
     *
     * @param t tangent: x, y, z
     */
    public double anisotropicFacets(float nx, float ny, float nz, float vx, float vy, float vz, float[] t, AnisotropicHighlight highlight,
            double alpha) {
        return highlight.term(nx, ny, nz, vx, vy, vz, t[0], t[1], t[2], lx, ly, lz, widened(highlight.squareAlong(alpha)),
                widened(highlight.squareAcross(alpha)));
    }

    /** Returns the sheen term of a principled material, for a row that faces the light: {@link SheenLayer#term}. @param roughness of the sheen */
    public float sheen(float nx, float ny, float nz, float vx, float vy, float vz, double roughness) {
        return SheenLayer.term(roughness, nx, ny, nz, vx, vy, vz, lx, ly, lz);
    }

    private double maskFactor() {
        if (hasAngularMask && angularMask == null) {
            angularMask = AngularMask.of(source);
        }
        return angularMask == null ? 1 : angularMask.factor(px, py, pz);
    }

    /** Returns atten·spot·doors·fog: 1 for a directional light in clear air. */
    public float falloff() {
        double mask = maskFactor();
        return (float) (source.type().hasPosition() ? falloff(source, distance, axisCosine(source)) * mask : mask);
    }

    /**
     * Returns atten·spot of a light with a position, where atten is min(1 / (cc + cl·d + cq·d²), max), and 1/0 counts as max.
     *
     * @param d      distance
     * @param cosine {@link #axisCosine}; unread without a cone
     */
    public static double falloff(LightSource light, double d, double cosine) {
        Attenuation a = light.light().distanceTerms();
        double max = light.light().maxFalloff();
        double factor = 1 / (a.constant() + a.linear() * d + a.quadratic() * (d * d));
        factor = factor < max ? factor : max;
        return light.hasCone() ? factor * PowerFunction.pow(cosine > 0 ? cosine : 0, light.dropoff()) : factor;
    }

    /** Returns the cosine of the angle between a unit vector and the direction to the light. */
    public double towardLight(double x, double y, double z) {
        return lx * x + ly * y + lz * z;
    }

    /**
     * Returns one channel of a light's contribution: weight times cosine (or specular term), falloff and tint.
     *
     * @param tint 1 if nothing clear is in between
     */
    public static float contribution(float weight, float term, float falloff, float tint) {
        return weight * (term * falloff * tint);
    }

    /** Returns the mean of a light's samples from their sum, first to last, of exact products {@code term·falloff}. */
    public static float mean(double sum, int samples) {
        return (float) (sum / samples);
    }

    /** Returns a mean of colors, weighted by the terms of samples; 1 if all terms are 0. */
    public static float weightedMean(double sum, double weight) {
        return weight > 0 ? (float) (sum / weight) : 1;
    }

    /** Adds {@code terms[from … to)} as a balanced tree: the first half's sum plus the second's. */
    public static float sum(float[] terms, int from, int to) {
        if (to - from < 2) {
            return from == to ? 0 : terms[from];
        }
        int middle = (from + to) >>> 1;
        return sum(terms, from, middle) + sum(terms, middle, to);
    }
}
