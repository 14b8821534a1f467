package lightning.scene;

/**
 * The four leaves before a spot light or a rectangle, each by the angle from the light's axis at which it cuts the light off, in degrees,
 * −90 … 90; at 90 it is open. Left, right and top are as the light looks out, with y upwards, or with the rectangle's {@code up}.
 */
public record BarnDoors(double left, double right, double bottom, double top) {
    /** The angle of a leaf that cuts nothing off. */
    public static final double AWAY = 90;
    /** They cut nothing off. */
    public static final BarnDoors OPEN = new BarnDoors(AWAY, AWAY, AWAY, AWAY);

    public BarnDoors {
        Limits.range("doors left", left, -AWAY, AWAY);
        Limits.range("doors right", right, -AWAY, AWAY);
        Limits.range("doors bottom", bottom, -AWAY, AWAY);
        Limits.range("doors top", top, -AWAY, AWAY);
    }

    public boolean isOpen() {
        return equals(OPEN);
    }
}
