package lightning.editor.window.mixer;

import javafx.scene.layout.Region;

/** Level meter of a strip's share of the picture's light. */
final class Meter extends Region {
    private static final double WIDTH = 6;

    private final Region bar = new Region();
    private double level;

    Meter() {
        getStyleClass().add("meter");
        bar.getStyleClass().add("bar");
        bar.setManaged(false);
        getChildren().add(bar);
        setMinWidth(WIDTH);
        setMaxWidth(WIDTH);
        setMouseTransparent(true);
    }

    /**
     * Shows a share.
     *
     * @param v share, 0…1
     */
    void show(double v) {
        level = v;
        requestLayout();
    }

    @Override
    protected void layoutChildren() {
        double barHeight = Math.min(1, level) * getHeight();
        bar.resizeRelocate(0, getHeight() - barHeight, getWidth(), barHeight);
    }
}
