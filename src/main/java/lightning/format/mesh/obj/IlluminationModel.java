package lightning.format.mesh.obj;

import java.util.Optional;

/**
 * Illumination model of an MTL file, in numeric order ({@code illum 0} to {@code illum 10}). Models 3 to 9 add reflection,
 * refraction or both to the highlight model; 10 is a shadow catcher.
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

    /** Returns the model of a number; empty if there is none. */
    static Optional<IlluminationModel> of(double number) {
        int index = (int) number;
        return index == number && index >= 0 && index < values().length ? Optional.of(values()[index]) : Optional.empty();
    }

    /** Returns whether lights create highlights (Ks, Ns). */
    public boolean hasHighlights() {
        return hasHighlights;
    }

    /** Returns whether the surface reflects other surfaces. */
    public boolean isReflective() {
        return isReflective;
    }

    /** Returns whether the surface transmits light even without an opacity in the file. */
    boolean isTransmissive() {
        return isTransmissive;
    }

    /** Returns whether the surface refracts transmitted light. */
    public boolean isRefractive() {
        return isRefractive;
    }
}
