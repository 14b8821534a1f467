package lightning.scene.light;

/** Types of light: the paper's three (§2.2) and area lights. The type decides which attributes act. */
public enum LightType {
    /** Infinitely distant light: intensity, color, direction. */
    DIRECTIONAL,
    /** Shines in all directions from one point: intensity, color, position, attenuation. */
    POINT,
    /** Shines in a cone from one point: all attributes. */
    SPOT,
    /** Rectangle that shines to one side, like a softbox. */
    RECT,
    /** Disc that shines to one side. */
    DISC,
    /** Cylinder that shines from its side, like a fluorescent lamp. Its direction is its axis. */
    TUBE,
    /** Surface of a shape of the scene, hidden or not, each point of which shines as bright to all sides. */
    OBJECT;

    /** Returns whether the light has a position. */
    public boolean hasPosition() {
        return this != DIRECTIONAL;
    }

    public boolean hasDirection() {
        return this != POINT && this != OBJECT;
    }

    /** Returns whether it is a one-sided area light: its intensity is proportional to the cosine of the angle from its direction. */
    public boolean isSurface() {
        return this == RECT || this == DISC;
    }

    /** Returns whether its angle acts. */
    public boolean hasCone() {
        return this == SPOT;
    }
}
