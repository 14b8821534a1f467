package lightning.editor.window;

import javafx.scene.layout.Background;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import lightning.editor.window.dock.DockSlot;
import lightning.editor.window.model.PanelPlace;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.ColorTheme;
import lightning.editor.window.widget.PictureView;

/**
 * First content of the window: the traced picture at its final position, and the backgrounds of all panes and docks. Has no controls and needs no
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
    private final Region leftDock = new Region();
    private final Region lowerDock = new Region();
    private final WindowLayout arrangement;

    /** @param arrangement stored arrangement of the panes */
    StartupView(ColorTheme looks, WindowLayout arrangement) {
        this.arrangement = arrangement;
        setId("opening");
        Color background = looks == ColorTheme.DARK ? Color.web("#1e1e1e") : Color.web("#f4f4f4");
        Color headerColor = looks == ColorTheme.DARK ? Color.web("#2a2a2a") : Color.web("#e9e9e9");
        setBackground(Background.fill(background));
        canvasDivider.setBackground(Background.fill(background));
        sideDivider.setBackground(Background.fill(background));
        leftDock.setBackground(Background.fill(background));
        lowerDock.setBackground(Background.fill(background));
        canvases.setBackground(Background.fill(CANVAS_COLOR));
        headers.setBackground(Background.fill(headerColor));
        tracedHeader.setBackground(Background.fill(headerColor));
        tracedFooter.setBackground(Background.fill(headerColor));
        getChildren().addAll(canvases, headers, tracedHeader, tracedFooter, canvasDivider, sideDivider, leftDock, lowerDock, picture);
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
        double workWidth = firstPaneWidth(getWidth(), EditorLayout.CANVAS_SHARE);
        double workBottom = getHeight() - EditorLayout.STATUS_HEIGHT;
        double workHeight = workBottom - EditorLayout.BARS_HEIGHT;
        double left = dockSize(PanelPlace.LEFT, workWidth, EditorLayout.LEFT_DOCK_WIDTH);
        double bottom = workBottom - dockSize(PanelPlace.BELOW, workHeight, EditorLayout.lowerDockHeight(arrangement, workHeight));
        double canvasWidth = workWidth - left;
        CanvasLayout choice = arrangement.canvasLayoutProperty().get();
        boolean isAlone = choice.hasInset() || choice.share() == 1;
        double width = isAlone ? canvasWidth : Math.max(0, firstPaneWidth(canvasWidth, choice.share()));
        double headerHeight = EditorLayout.headerHeight(width);
        double top = EditorLayout.BARS_HEIGHT + headerHeight;
        headers.resizeRelocate(0, EditorLayout.BARS_HEIGHT, getWidth(), EditorLayout.HEADER_HEIGHT);
        canvases.resizeRelocate(left, EditorLayout.BARS_HEIGHT + EditorLayout.HEADER_HEIGHT, canvasWidth,
                bottom - EditorLayout.BARS_HEIGHT - EditorLayout.HEADER_HEIGHT);
        tracedHeader.resizeRelocate(left, EditorLayout.BARS_HEIGHT, width, headerHeight);
        tracedFooter.resizeRelocate(left, bottom - EditorLayout.FOOTER_HEIGHT, width, EditorLayout.FOOTER_HEIGHT);
        canvasDivider.resizeRelocate(left + width, EditorLayout.BARS_HEIGHT, isAlone ? 0 : EditorLayout.DIVIDER_WIDTH,
                bottom - EditorLayout.BARS_HEIGHT);
        sideDivider.resizeRelocate(workWidth, EditorLayout.BARS_HEIGHT, EditorLayout.DIVIDER_WIDTH, workHeight);
        leftDock.resizeRelocate(0, EditorLayout.BARS_HEIGHT, left, bottom - EditorLayout.BARS_HEIGHT);
        lowerDock.resizeRelocate(0, bottom, workWidth, workBottom - bottom);
        picture.resizeRelocate(left, top, width, bottom - EditorLayout.FOOTER_HEIGHT - top);
    }

    /** Returns the size of a dock and its divider, pixels; 0 without panels. */
    private double dockSize(PanelPlace place, double total, double defaultSize) {
        return arrangement.panelsProperty().get().openIn(place).isEmpty() ? 0
                : DockSlot.size(total, arrangement.dockSizeProperty(place).get(), defaultSize) + EditorLayout.DIVIDER_WIDTH;
    }

    /** Returns the width of the first of two panes, pixels. */
    private static double firstPaneWidth(double totalWidth, double share) {
        return Math.rint(totalWidth * share - EditorLayout.DIVIDER_WIDTH / 2);
    }
}
