package lightning.scene;

/** The three kinds of light (paper §2.2); the kind decides which attributes act. */
public enum LightType {
    /** Infinitely far away: intensity, colour, direction. */
    DIRECTIONAL,
    /** Shines everywhere from one place: intensity, colour, position, attenuation. */
    POINT,
    /** A cone from one place: all attributes. */
    SPOT;

    /** Whether the light shines from its position. */
    public boolean hasPosition() {
        return this != DIRECTIONAL;
    }

    public boolean hasDirection() {
        return this != POINT;
    }

    /** Whether angle and dropoff act. */
    public boolean hasCone() {
        return this == SPOT;
    }
}
