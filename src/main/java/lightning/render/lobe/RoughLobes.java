package lightning.render.lobe;

import java.util.List;
import lightning.scene.material.Anisotropy;
import lightning.scene.material.Coat;
import lightning.scene.material.Material;
import org.jspecify.annotations.Nullable;

/**
 * Lobes by which a principled material blurs its surroundings. Smooth ones reflect a mirrored ray and are not among them. A frosted material
 * has one that reflects and one that lets light pass; its coat, if any, reflects as the surface does.
 *
 * @param alpha     width α of the surface below the coat, with the mean of its map; 0 if it is smooth
 * @param anisotropy of the surface below the coat; null if its width is the same in all directions
 * @param coatAlpha width α of the coat, with the mean of its map; 0 if it is smooth or there is none
 * @param coat      coat with the means of its maps, smooth or not; null for none
 * @param frost     what lets light pass; null for an opaque material
 * @param fibers    sheen; null for none
 * @param f0        reflectance of the surface at normal incidence with the means of its maps, rounded up: one of few, so that few edits of a color cast other rays
 */
public record RoughLobes(double alpha, @Nullable Anisotropy anisotropy, double coatAlpha, @Nullable Coat coat, @Nullable Frost frost,
        @Nullable Fibers fibers, double f0) {
    /** Width α that stands for that of a sheen, which is wide at any roughness. */
    public static final double SHEEN_ALPHA = 0.4;

    private static final List<Double> F0_BOUNDS = List.of(0.08, 0.25);
    /** Angle between the directions of two lobes at which one does not stand for the other, in ratios of their widths. */
    private static final double TWIST = 1.5;

    /**
     * Surface of a frosted body.
     *
     * @param ior index of refraction; 1 for a thin sheet
     * @param f0  reflectance at normal incidence
     */
    public record Frost(double ior, double f0) {}

    /**
     * Sheen of a surface.
     *
     * @param roughness its roughness, with the mean of its map
     * @param f0   reflectance at normal incidence for which the mean of the lobes below it is computed
     */
    public record Fibers(double roughness, double f0) {}

    /** Kind of a lobe. */
    public enum Kind {
        SURFACE, COAT, PASSING, SHEEN
    }

    private static final List<Kind> KINDS = List.of(Kind.values());

    /** Returns the lobes of a material; null if it reflects nothing or sharply. */
    public static @Nullable RoughLobes of(Material m) {
        return !m.reflectsRoughly() ? null
                : new RoughLobes(m.isSmooth() ? 0 : Material.alpha(m.meanRoughness()), m.isAnisotropic() ? m.anisotropy() : null,
                        m.coat().isVisible() && !m.hasSmoothCoat() && !m.isFrosted() ? m.meanCoat().alpha() : 0,
                        m.coat().isVisible() ? m.meanCoat() : null,
                        m.isFrosted() ? new Frost(m.transmission().thin() ? 1 : m.transmission().ior(), m.f0()) : null,
                        m.hasSheen() ? new Fibers(m.meanSheen().roughness(), m.f0UnderSheen()) : null, f0(m));
    }

    private static double f0(Material m) {
        double metal = m.meanMetalness();
        double f0 = metal * m.base().max() + (1 - metal) * m.meanF0() * m.meanSpecularTint().max();
        return F0_BOUNDS.stream().filter(bound -> f0 <= bound).findFirst().orElse(1.0);
    }

    /**
     * Returns about the share of light that all lobes reflect or let pass, rounded up, 0…1.
     *
     * @param cosine    between the normal and the view, 0…1
     * @param roughness of the surface there, with its map
     */
    public double share(float cosine, float roughness) {
        if (frost != null) {
            return 1;
        }
        double surface = alpha == 0 ? 0 : f0 * DirectionalAlbedo.ofF0(cosine, roughness) + DirectionalAlbedo.grazing(cosine, roughness);
        double over = coat == null || coatAlpha == 0 ? 0 : CoatShare.of(coat, cosine);
        return Math.min(1, surface + over + (fibers == null ? 0 : SheenLobe.albedo(fibers.roughness(), cosine)));
    }

    private boolean areTwo() {
        return alpha > 0 && coatAlpha > 0;
    }

    private boolean isSheenOnly() {
        return alpha == 0 && coatAlpha == 0;
    }

    /** Returns the width α of the narrowest lobe. */
    public double narrowest() {
        return fibers == null ? narrowestBelow() : isSheenOnly() ? SHEEN_ALPHA : Math.min(SHEEN_ALPHA, narrowestBelow());
    }

    private double narrowestBelow() {
        double across = narrow(Kind.SURFACE, alpha);
        return alpha == 0 ? coatAlpha : coatAlpha == 0 ? across : Math.min(across, coatAlpha);
    }

    /** Returns the width of a lobe across its direction, where it is narrowest. @param lobeAlpha its α */
    public double narrow(Kind kind, double lobeAlpha) {
        return anisotropy != null && kind == Kind.SURFACE ? anisotropy.across(lobeAlpha) : lobeAlpha;
    }

    /**
     * Returns the largest sine of the angle between the directions of two points of the surface at which their lobes are alike, 0…1.
     */
    public double twist() {
        double round = Math.max(alpha, Material.alpha(0));
        return anisotropy == null ? 1 : Math.min(1, TWIST * anisotropy.across(round) / anisotropy.along(round));
    }

    /**
     * Returns the lobe of a ray. If there are several, each has rays in all rows and columns. A sheen has half of the rays.
     *
     * @param row of the ray in the grid of a point's rays, as {@code column}
     */
    public Kind kind(int row, int column) {
        if (fibers != null) {
            return isSheenOnly() || (row + column & 1) == 1 ? Kind.SHEEN
                    : areTwo() ? (row + column & 2) == 0 ? Kind.COAT : Kind.SURFACE : alpha == 0 ? Kind.COAT : Kind.SURFACE;
        }
        return frost != null ? row == column ? Kind.SURFACE : Kind.PASSING
                : areTwo() ? (row + column & 1) == 1 ? Kind.COAT : Kind.SURFACE : alpha == 0 ? Kind.COAT : Kind.SURFACE;
    }

    /** Returns the number of rays of the lobe that has the fewest, of those that have any; {@code side} as in {@link #rays}. */
    public int fewestRays(int side) {
        int fewest = side * side;
        for (Kind kind : KINDS) {
            fewest = has(kind) ? Math.min(fewest, rays(kind, side)) : fewest;
        }
        return fewest;
    }

    private boolean has(Kind kind) {
        return switch (kind) {
            case SURFACE -> alpha > 0;
            case COAT -> coatAlpha > 0;
            case PASSING -> frost != null;
            case SHEEN -> fibers != null;
        };
    }

    /**
     * Returns the number of rays of a lobe.
     *
     * @param side rays along each side of the grid, an even number
     */
    public int rays(Kind kind, int side) {
        if (fibers != null) {
            return isSheenOnly() ? side * side : kind == Kind.SHEEN || !areTwo() ? side * side / 2 : side * side / 4;
        }
        return frost != null ? kind == Kind.SURFACE ? side : kind == Kind.PASSING ? side * side - side : 0
                : areTwo() ? side * side / 2 : side * side;
    }
}
