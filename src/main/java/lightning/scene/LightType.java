package lightning.scene;

/** The kinds of light, the paper's three (§2.2) and two that are surfaces; the kind decides which attributes act. */
public enum LightType {
    /** Infinitely far away: intensity, color, direction. */
    DIRECTIONAL,
    /** Shines everywhere from one place: intensity, color, position, attenuation. */
    POINT,
    /** A cone from one place: all attributes. */
    SPOT,
    /** A rectangle that shines to one side, as a softbox does. */
    RECT,
    /** A disc that shines to one side. */
    DISC;

    /** Whether the light shines from its position. */
    public boolean hasPosition() {
        return this != DIRECTIONAL;
    }

    public boolean hasDirection() {
        return this != POINT;
    }

    /** Whether it shines to one side of a surface alone: most along its direction, and as the cosine of the angle from it elsewhere. */
    public boolean isSurface() {
        return this == RECT || this == DISC;
    }

    /** Whether angle and dropoff act. */
    public boolean hasCone() {
        return this == SPOT;
    }
}
