package lightning.format.exchange;

/** Choice whether an imported scene has indirect light. */
public enum IndirectChoice {
    /** Only if the camera is in a closed room. */
    AUTO,
    ON,
    OFF;

    /** Returns the scene with this choice. Takes a moment for large scenes. */
    public ImportedScene apply(ImportedScene imported) {
        return this == ON || this == AUTO && ClosedRoom.contains(imported.scene()) ? imported.withIndirect() : imported;
    }
}
