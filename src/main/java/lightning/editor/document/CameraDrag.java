package lightning.editor.document;

/** What a drag with Shift does to the preview's camera, decided by how it begins (paper §3.6). */
public enum CameraDrag {
    ZOOM,
    PAN,
    TRACKBALL;

    /** How close to the edge a trackball begins, as a share of the shorter side. */
    static final double EDGE_SHARE = 0.1;

    /**
     * The kind of a drag that begins at a place and goes a first way.
     *
     * @param x     pixels from the left; likewise {@code y} from the top
     * @param right pixels; likewise {@code down}
     */
    public static CameraDrag of(Viewport canvas, double x, double y, double right, double down) {
        double edge = EDGE_SHARE * Math.min(canvas.width(), canvas.height());
        boolean isNearEdge = x < edge || y < edge || x >= canvas.width() - edge || y >= canvas.height() - edge;
        if (isNearEdge) {
            return TRACKBALL;
        }
        return Math.abs(down) > Math.abs(right) ? ZOOM : PAN;
    }

    /** The camera of the drag's begin, after the whole way of the drag so far. */
    public PreviewCamera apply(PreviewCamera start, Viewport canvas, double right, double down) {
        return switch (this) {
            case ZOOM -> start.zoom(-down, canvas);
            case PAN -> start.pan(right, -down, canvas);
            case TRACKBALL -> start.trackball(right, -down, canvas);
        };
    }
}
