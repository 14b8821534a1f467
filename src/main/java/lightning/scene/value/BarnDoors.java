package lightning.scene.value;

/**
 * Four barn doors of a spot, rectangle or disc light. Each is the angle from the light's axis at which it cuts the light off, in degrees, −90 …
 * 90; 90 is open. Left, right and top are seen from the light, with y, or the {@code up} of a rectangle or disc, upwards.
 */
public record BarnDoors(double left, double right, double bottom, double top) {
    /** Angle of an open door. */
    public static final double OPEN_ANGLE = 90;
    /** All doors open. */
    public static final BarnDoors OPEN = new BarnDoors(OPEN_ANGLE, OPEN_ANGLE, OPEN_ANGLE, OPEN_ANGLE);

    public BarnDoors {
        SceneLimits.checkRange("doors left", left, -OPEN_ANGLE, OPEN_ANGLE);
        SceneLimits.checkRange("doors right", right, -OPEN_ANGLE, OPEN_ANGLE);
        SceneLimits.checkRange("doors bottom", bottom, -OPEN_ANGLE, OPEN_ANGLE);
        SceneLimits.checkRange("doors top", top, -OPEN_ANGLE, OPEN_ANGLE);
    }

    public boolean isOpen() {
        return equals(OPEN);
    }
}
