package lightning.scene;

/**
 * The four leaves before a spot light or a rectangle, each by the angle from the light's axis at which it cuts the light off, in degrees,
 * −90 … 90; at 90 it is open. Left, right and top are as the light looks out, with y upwards, or with the rectangle's {@code up}.
 */
public record BarnDoors(double left, double right, double bottom, double top) {
    /** The angle of a leaf that cuts nothing off. */
    public static final double OPEN_ANGLE = 90;
    /** They cut nothing off. */
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
