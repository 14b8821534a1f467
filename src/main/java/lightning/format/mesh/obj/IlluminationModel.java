package lightning.format.mesh.obj;

import java.util.Optional;

/**
 * The illumination models of MTL files, in the order of their numbers ({@code illum 0} to {@code illum 10}). Models 3 to 9 are the highlight
 * model with mirrored or refracted rays, or both, added; 10 is a surface that shows shadows alone.
 */
public enum IlluminationModel {
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

    private final boolean hasHighlights;
    private final boolean isReflective;
    private final boolean isTransmissive;
    private final boolean isRefractive;

    IlluminationModel(boolean hasHighlights, boolean isReflective, boolean isTransmissive, boolean isRefractive) {
        this.hasHighlights = hasHighlights;
        this.isReflective = isReflective;
        this.isTransmissive = isTransmissive;
        this.isRefractive = isRefractive;
    }

    /** The model of a number; empty if there is none. */
    static Optional<IlluminationModel> of(double number) {
        int index = (int) number;
        return index == number && index >= 0 && index < values().length ? Optional.of(values()[index]) : Optional.empty();
    }

    /** Whether lights leave highlights (Ks, Ns). */
    public boolean hasHighlights() {
        return hasHighlights;
    }

    /** Whether the surface mirrors other surfaces. */
    public boolean isReflective() {
        return isReflective;
    }

    /** Whether light passes through the surface even where no line says how much. */
    boolean isTransmissive() {
        return isTransmissive;
    }

    /** Whether the surface bends what is seen through it. */
    public boolean isRefractive() {
        return isRefractive;
    }
}
