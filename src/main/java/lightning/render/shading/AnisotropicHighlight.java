package lightning.render.shading;

import lightning.scene.material.Anisotropy;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Highlight of an anisotropic material: GGX with two widths (B. Burley, Physically-based shading at Disney, 2012, appendix B), and Smith's visibility
 * for them (E. Heitz, Understanding the masking-shadowing function in microfacet-based BRDFs, 2014, §5.4). As in the isotropic term of
 * {@link LightingEquation}, the masking of light and view are independent.
 *
 * <p>With the direction X of the material, Y = N × X and H = L − V:
 *
 * <pre>
 * c = H·H / ((X·H)²/α∥² + (Y·H)²/α⊥² + (N·H)²)
 * N·L·D·V = N·L·c² / (α∥·α⊥·g(L)·g(V))       g(w) = N·w + √(α∥²·(X·w)² + α⊥²·(Y·w)² + (N·w)²)
 * </pre>
 *
 * @param anisotropy widths and rotation
 * @param cos        of the rotation from the tangent, with {@code sin}
 */
public record AnisotropicHighlight(Anisotropy anisotropy, double cos, double sin) {
    /** Returns the highlight of a material; null if it is isotropic. */
    static @Nullable AnisotropicHighlight of(Material m) {
        if (!m.isAnisotropic()) {
            return null;
        }
        double angle = Math.toRadians(m.anisotropy().rotation());
        return new AnisotropicHighlight(m.anisotropy(), StrictMath.cos(angle), StrictMath.sin(angle));
    }

    /** Returns α∥², before it is widened by the light of one sample. @param alpha α of the roughness */
    public double squareAlong(double alpha) {
        double along = anisotropy.along(alpha);
        return along * along;
    }

    /** Returns α⊥², before it is widened by the light of one sample. @param alpha α of the roughness */
    public double squareAcross(double alpha) {
        double across = anisotropy.across(alpha);
        return across * across;
    }

    /**
     * Returns N·L·D·V, for a surface that faces the light; D without its 1/π. At most 1/(2·α∥·α⊥²) apart from roundings: D is at most 1/(α∥·α⊥), and
     * V at most 1/(2·N·L·α⊥).
     *
     * @param vx component x of the unit direction of the ray that hit the surface
     * @param tx component x of the tangent
     * @param lx component x of the unit vector to the light
     * @param a  widened α∥²
     * @param b  widened α⊥²
     */
    public double term(float nx, float ny, float nz, float vx, float vy, float vz, float tx, float ty, float tz, double lx, double ly,
            double lz, double a, double b) {
        double bx = (double) ny * tz - (double) nz * ty;
        double by = (double) nz * tx - (double) nx * tz;
        double bz = (double) nx * ty - (double) ny * tx;
        double xx = cos * tx + sin * bx;
        double xy = cos * ty + sin * by;
        double xz = cos * tz + sin * bz;
        double yx = cos * bx - sin * tx;
        double yy = cos * by - sin * ty;
        double yz = cos * bz - sin * tz;
        double nl = nx * lx + ny * ly + nz * lz;
        double xl = xx * lx + xy * ly + xz * lz;
        double yl = yx * lx + yy * ly + yz * lz;
        double nv = -((double) nx * vx + (double) ny * vy + (double) nz * vz);
        double xv = -(xx * vx + xy * vy + xz * vz);
        double yv = -(yx * vx + yy * vy + yz * vz);
        double nh = nl + nv;
        double xh = xl + xv;
        double yh = yl + yv;
        double x = xh * xh;
        double y = yh * yh;
        double n = nh * nh;
        double c = (x + y + n) / (x / a + y / b + n);
        // If H has no direction, this is NaN.
        c = c > 0 ? c > 1 ? 1 : c : 0;
        nv = nv > 0 ? nv : 0;
        double gl = nl + Math.sqrt(a * (xl * xl) + b * (yl * yl) + nl * nl);
        double gv = nv + Math.sqrt(a * (xv * xv) + b * (yv * yv) + nv * nv);
        return nl * (c * c) / (Math.sqrt(a * b) * (gl * gv));
    }
}
