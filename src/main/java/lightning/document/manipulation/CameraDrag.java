package lightning.document.manipulation;

/** Camera action of a drag in the preview. With Shift, the start of the drag chooses it (paper §3.6). */
public enum CameraDrag {
    ZOOM,
    PAN,
    TRACKBALL,
    /** Turns about the target; the vertical axis stays upright. */
    ORBIT;

    /** Width of the border that starts a trackball drag, as a share of the shorter side. */
    static final double EDGE_SHARE = 0.1;

    /**
     * Returns the action for a start position and first movement.
     *
     * @param x     pixels from the left
     * @param y     pixels from the top
     * @param right pixels of movement to the right
     * @param down  pixels of movement down
     */
    public static CameraDrag of(Viewport canvas, double x, double y, double right, double down) {
        double edge = EDGE_SHARE * Math.min(canvas.width(), canvas.height());
        boolean isNearEdge = x < edge || y < edge || x >= canvas.width() - edge || y >= canvas.height() - edge;
        if (isNearEdge) {
            return TRACKBALL;
        }
        return Math.abs(down) > Math.abs(right) ? ZOOM : PAN;
    }

    /** Applies the total movement of the drag so far to the camera at its start. */
    public PreviewCamera apply(PreviewCamera start, Viewport canvas, double right, double down) {
        return switch (this) {
            case ZOOM -> start.zoom(-down, canvas);
            case PAN -> start.pan(right, -down, canvas);
            case TRACKBALL -> start.trackball(right, -down, canvas);
            case ORBIT -> start.orbit(right, -down, canvas);
        };
    }
}
