package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import lightning.render.lobe.CoatShare;
import lightning.render.lobe.DirectionalAlbedo;
import lightning.render.lobe.SheenLobe;
import lightning.render.trace.HitRows;
import lightning.render.trace.MappedSurface;
import lightning.render.trace.SurfacePoint;

/**
 * Weights of what a principled surface reflects, seen from one direction.
 *
 * <pre>
 * I = emitted + kd·d·Idiff + (F0 + q·F0F0)·Ispec + Igraz
 * Ispec = Σ Ispec of lights + a·L      Igraz = Σ Igraz of lights + b·L' + coat
 * </pre>
 *
 * <p>L and L' are means of the light of the surroundings over the lobe, and a and b the shares of white light that it reflects ({@link
 * DirectionalAlbedo}). d is the share of light that neither the coat nor the surface reflects before it is scattered below (the albedo scaling of C. Kulla and A.
 * Conty, Revisiting physically based shading at Imageworks, 2017). q·F0F0 gives back the light that is scattered several times between facets: F0F0 is the mean
 * of F0² over the metal and the nonmetal part, and a white metal reflects all light (as E. Turquin, Practical multiple scattering compensation for
 * microfacet models, 2019).
 *
 * <p>Fibers scatter e·S, where S is their color and e their albedo, and all below receives 1 − e·max S, as in white light it then sends back the
 * rest. They change the sums ({@link SheenLayer}):
 *
 * <pre>
 * I = emitted + (1 − e·max S)·(kd·d·Idiff + (F0·a + b + q·F0F0·a)/(f·a + b)·Ispec) + S·Igraz
 * Ispec = Σ (f·Ispec + Igraz) of lights + (f·a + b)·L      Igraz = Σ of fibers + e·L″
 * </pre>
 *
 * <p>One instance per thread.
 */
public final class PrincipledWeights {
    /** Smallest share of single scattering by which multiple scattering is estimated: it keeps q below 4. */
    private static final float MIN_SHARE = 0.25f;
    /** Smallest share of light by which the first sum below fibers is scaled. */
    private static final float MIN_BELOW = 1e-6f;

    private float colored;
    private float grazing;
    private float diffuse;
    private float multiple;
    private float base;
    private float mirrorGrazing;
    private float coat;
    private float coatWeight;
    private float sheen;
    private final float[] sheenColor = new float[3];
    /** Share of light that reaches the surface below the fibers, and what the surface reflects if its reflectance is f. */
    private float left;
    private float below;

    /** Moves to a row of a material. @param at numbers of the row */
    public void moveTo(Bsdf.Principled m, MappedSurface at, HitRows rows, int row) {
        moveTo(m, at, rows.nx[row], rows.ny[row], rows.nz[row], rows.vx[row], rows.vy[row], rows.vz[row]);
    }

    /** Moves to a point. */
    public void moveTo(Bsdf.Principled m, SurfacePoint point) {
        moveTo(m, point.mapped(m.material()), point.nx(), point.ny(), point.nz(), point.vx(), point.vy(), point.vz());
    }

    private void moveTo(Bsdf.Principled m, MappedSurface at, float nx, float ny, float nz, float vx, float vy, float vz) {
        float roughness = (float) at.roughness();
        float cosine = Math.clamp(-(nx * vx + ny * vy + nz * vz), 0, 1);
        float a = DirectionalAlbedo.ofF0(cosine, roughness);
        float b = DirectionalAlbedo.grazing(cosine, roughness);
        colored = a;
        grazing = b;
        float rest = 1 - cosine;
        mirrorGrazing = rest * rest * (rest * rest) * rest;
        multiple = Math.max(0, 1 - a - b) / Math.max(a, MIN_SHARE);
        coatWeight = at.coatWeight();
        coat = m.coat() == null ? 0 : CoatShare.of(m.coat(), coatWeight, (float) at.coatRoughness(),
                at.coatCosine(vx, vy, vz, cosine));
        base = 1 - coat;
        float f0 = at.largestNonmetalF0();
        diffuse = base * Math.max(0, 1 - (f0 * a + b + multiple * (f0 * f0) * a));
        if (m.sheen() != null) {
            sheen = SheenLobe.albedo(at.sheenRoughness(), cosine);
            for (int c = 0; c < 3; c++) {
                sheenColor[c] = at.sheen(c);
            }
            left = 1 - sheen * at.largestSheen();
            diffuse *= left;
            below = Math.max(MIN_BELOW, base * m.sheen().below(a, b) + coat);
        }
    }

    /** Returns the share of light that the coat lets through, 0…1. */
    public float base() {
        return base;
    }

    /** Returns the part of the mean light of rough lobes that F0 multiplies, or all that is reflected below fibers. */
    public float reflected(Bsdf.Principled m) {
        if (m.sheen() != null) {
            return (m.isSmooth() ? 0 : base * m.sheen().below(colored, grazing)) + (m.isCoatSmooth() ? 0 : coat);
        }
        return m.isSmooth() ? 0 : base * colored;
    }

    /** Returns the part of the mean light of rough lobes that no color multiplies, or that fibers scatter. */
    public float reflectedGrazing(Bsdf.Principled m) {
        return m.sheen() != null ? sheen : (m.isSmooth() ? 0 : base * grazing) + (m.isCoatSmooth() ? 0 : coat);
    }

    /** Returns the part of a mirrored ray's color that F0 multiplies, or all that is mirrored below fibers. */
    public float mirrored(Bsdf.Principled m) {
        if (m.sheen() != null) {
            return (m.isSmooth() ? base * m.sheen().below(1 - mirrorGrazing, mirrorGrazing) : 0) + (m.isCoatSmooth() ? coat : 0);
        }
        return m.isSmooth() ? base * (1 - mirrorGrazing) : 0;
    }

    /** Returns the part of a mirrored ray's color that no color multiplies. */
    public float mirroredGrazing(Bsdf.Principled m) {
        return m.sheen() != null ? 0 : (m.isSmooth() ? base * mirrorGrazing : 0) + (m.isCoatSmooth() ? coat : 0);
    }

    /**
     * Returns the grazing term of a light on a coated surface.
     *
     * @param grazing       term of the surface below the coat
     * @param coatSpecular  specular term of a surface with the roughness of the coat
     * @param coatGrazing   grazing term of such a surface
     */
    public float coatedGrazing(Bsdf.Principled m, float grazing, float coatSpecular, float coatGrazing) {
        var layer = requireNonNull(m.coat());
        return base * grazing + coatWeight * ((float) layer.f0() * coatSpecular + coatGrazing);
    }

    /** Returns the factor of diffuse light, kd·d, of a channel. @param kd diffuse color, including the texture */
    public float diffuse(float kd) {
        return kd * diffuse;
    }

    /**
     * Returns the factor of Ispec in a channel.
     *
     * @param f0     F0, including the texture
     * @param square F0F0, including the texture
     */
    public float shine(Bsdf.Principled m, float f0, float square) {
        return m.sheen() == null ? f0 + multiple * square
                : left * ((base * (f0 * colored + grazing + multiple * square * colored) + coat) / below);
    }

    /** Returns the factor of Igraz in channel {@code c}. */
    public float graze(Bsdf.Principled m, int c) {
        return m.sheen() == null ? 1 : sheenColor[c];
    }

    /** Returns the factor of the first mean light of rough lobes, L. @param shine {@link #shine}, as {@code graze} is {@link #graze} */
    public float first(Bsdf.Principled m, float shine, float graze) {
        return shine * reflected(m) + (m.isFrosted() ? graze * reflectedGrazing(m) : 0);
    }

    /** Returns the factor of the second mean light in channel {@code c}: L' of rough lobes, L″ of fibers, or what passes a frosted material. */
    public float second(Bsdf.Principled m, int c, float graze) {
        return !m.isFrosted() ? graze * reflectedGrazing(m) : m.sheen() == null ? requireNonNull(m.passing())[c] * diffuse : 0;
    }

    /** Returns the factor of the color of the mirrored ray; 0 if the material casts none. Parameters as above. */
    public float mirror(Bsdf.Principled m, float shine, float graze) {
        return m.isMirror() ? shine * mirrored(m) + graze * mirroredGrazing(m) : 0;
    }
}
