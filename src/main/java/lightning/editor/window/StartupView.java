package lightning.editor.window;

import javafx.scene.layout.Background;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.PictureView;

/**
 * First content of the window: the traced picture at its final position, and the backgrounds of all panes. Has no controls and needs no
 * style sheet, since both take longer to load than the picture.
 */
final class StartupView extends Region {
    private static final Color CANVAS_COLOR = Color.web("#121212");

    private final PictureView picture = TracedPane.createView();
    private final Region canvases = new Region();
    private final Region headers = new Region();
    /** Header of the traced picture. */
    private final Region tracedHeader = new Region();
    private final Region tracedFooter = new Region();
    /** Dividers between the panes. */
    private final Region canvasDivider = new Region();
    private final Region sideDivider = new Region();

    StartupView(ColorTheme looks) {
        setId("opening");
        Color background = looks == ColorTheme.DARK ? Color.web("#1e1e1e") : Color.web("#f4f4f4");
        Color headerColor = looks == ColorTheme.DARK ? Color.web("#2a2a2a") : Color.web("#e9e9e9");
        setBackground(Background.fill(background));
        canvasDivider.setBackground(Background.fill(background));
        sideDivider.setBackground(Background.fill(background));
        canvases.setBackground(Background.fill(CANVAS_COLOR));
        headers.setBackground(Background.fill(headerColor));
        tracedHeader.setBackground(Background.fill(headerColor));
        tracedFooter.setBackground(Background.fill(headerColor));
        getChildren().addAll(canvases, headers, tracedHeader, tracedFooter, canvasDivider, sideDivider, picture);
    }

    /** Returns the picture view, which can later move to another parent. */
    PictureView picture() {
        return picture;
    }

    Region canvases() {
        return canvases;
    }

    Region headers() {
        return headers;
    }

    @Override
    protected void layoutChildren() {
        double canvasWidth = firstPaneWidth(getWidth(), EditorLayout.CANVAS_SHARE);
        double width = firstPaneWidth(canvasWidth, 0.5);
        double headerHeight = EditorLayout.headerHeight(width);
        double top = EditorLayout.BARS_HEIGHT + headerHeight;
        double bottom = getHeight() - EditorLayout.STATUS_HEIGHT;
        headers.resizeRelocate(0, EditorLayout.BARS_HEIGHT, getWidth(), EditorLayout.HEADER_HEIGHT);
        canvases.resizeRelocate(0, EditorLayout.BARS_HEIGHT + EditorLayout.HEADER_HEIGHT, canvasWidth,
                bottom - EditorLayout.BARS_HEIGHT - EditorLayout.HEADER_HEIGHT);
        tracedHeader.resizeRelocate(0, EditorLayout.BARS_HEIGHT, width, headerHeight);
        tracedFooter.resizeRelocate(0, bottom - EditorLayout.FOOTER_HEIGHT, width, EditorLayout.FOOTER_HEIGHT);
        canvasDivider.resizeRelocate(width, EditorLayout.BARS_HEIGHT, EditorLayout.DIVIDER_WIDTH, bottom - EditorLayout.BARS_HEIGHT);
        sideDivider.resizeRelocate(canvasWidth, EditorLayout.BARS_HEIGHT, EditorLayout.DIVIDER_WIDTH, bottom - EditorLayout.BARS_HEIGHT);
        picture.resizeRelocate(0, top, width, bottom - EditorLayout.FOOTER_HEIGHT - top);
    }

    /** Returns the width of the first of two panes, pixels. */
    private static double firstPaneWidth(double totalWidth, double share) {
        return Math.rint(totalWidth * share - EditorLayout.DIVIDER_WIDTH / 2);
    }
}
