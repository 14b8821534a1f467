package lightning.format.mesh.obj;

import java.util.Optional;

/**
 * The illumination models of MTL files, in the order of their numbers ({@code illum 0} to {@code illum 10}). Models 3 to 9 are the highlight
 * model with mirrored or refracted rays, or both, added; 10 is a surface that shows shadows alone.
 */
public enum Illumination {
    CONSTANT(false, false, false, false),
    DIFFUSE(false, false, false, false),
    HIGHLIGHT(true, false, false, false),
    REFLECTION(true, true, false, false),
    GLASS(true, false, true, false),
    FRESNEL(true, true, false, false),
    REFRACTION(true, true, true, true),
    FRESNEL_REFRACTION(true, true, true, true),
    REFLECTION_MAP(true, true, false, false),
    GLASS_MAP(true, false, true, false),
    SHADOW_CATCHER(false, false, false, false);

    private final boolean highlights;
    private final boolean mirrors;
    private final boolean transmits;
    private final boolean refracts;

    Illumination(boolean highlights, boolean mirrors, boolean transmits, boolean refracts) {
        this.highlights = highlights;
        this.mirrors = mirrors;
        this.transmits = transmits;
        this.refracts = refracts;
    }

    /** The model of a number; empty if there is none. */
    static Optional<Illumination> of(double number) {
        int index = (int) number;
        return index == number && index >= 0 && index < values().length ? Optional.of(values()[index]) : Optional.empty();
    }

    /** Whether lights leave highlights (Ks, Ns). */
    public boolean highlights() {
        return highlights;
    }

    /** Whether the surface mirrors other surfaces. */
    public boolean mirrors() {
        return mirrors;
    }

    /** Whether light passes through the surface even where no line says how much. */
    boolean transmits() {
        return transmits;
    }

    /** Whether the surface bends what is seen through it. */
    public boolean refracts() {
        return refracts;
    }
}
