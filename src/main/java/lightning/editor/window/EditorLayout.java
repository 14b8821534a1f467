package lightning.editor.window;

import static java.util.Objects.requireNonNull;

import java.nio.file.Path;
import java.util.List;
import javafx.beans.binding.Bindings;
import javafx.geometry.Insets;
import javafx.geometry.Orientation;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Control;
import javafx.scene.control.Label;
import javafx.scene.control.SplitPane;
import javafx.scene.control.TextInputControl;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.dock.DockSlot;
import lightning.editor.window.dock.TabDrag;
import lightning.editor.window.model.PanelPlace;
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.preview.PreviewPane;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.PaneHeader;
import lightning.editor.window.widget.PictureView;
import org.jspecify.annotations.Nullable;

/**
 * Layout of the editor's panes. Each area shows a loading note until its pane is added: the traced picture first, then all others. Panes
 * stay in their parents, because a move to another window discards their applied styles.
 */
final class EditorLayout extends BorderPane {
    /** Share of the window's width that the two picture panes take. */
    static final double CANVAS_SHARE = 0.74;
    private static final double LIST_SHARE = 0.36;
    /** Initial sizes of the docks, pixels. */
    private static final double MIN_LOWER_DOCK_HEIGHT = 290;
    private static final double LOWER_DOCK_SHARE = 0.43;
    static final double LEFT_DOCK_WIDTH = 300;
    /** Approximate height of menu bar and tool bar, pixels. Reserves their space, so that little moves when they are added. */
    static final double BARS_HEIGHT = 72;
    static final double STATUS_HEIGHT = 27;
    /** Approximate height of a pane's header, pixels. Reserves its space, so that little moves when it is added. */
    static final double HEADER_HEIGHT = 36;
    static final double FOOTER_HEIGHT = 38;
    /** Approximate width that fits the main controls of the traced picture in one row, pixels. */
    private static final double SINGLE_ROW_WIDTH = 310;
    private static final double EXTRA_ROW_HEIGHT = 30;
    /** Width of the divider between two panes, pixels. */
    static final double DIVIDER_WIDTH = 4;
    /** Minimum width of a page next to the traced picture, pixels. */
    private static final double MIN_PAGE_WIDTH = 460;
    /** Share of the width that a page always leaves free, unless the window is too narrow. */
    private static final double MIN_LEFT_SHARE = 0.45;
    /** Insets of a loading note, aligned with the text of the header above it. */
    private static final Insets NOTE_INSETS = new Insets(6, 12, 6, 12);

    private final PictureView picture;
    private final SplitPane canvases;
    /** Left dock and picture panes. */
    private final SplitPane upperArea;
    /** Left dock and picture panes, with the lower dock below. */
    private final SplitPane workArea;
    private final SplitPane sidePanels;
    private final SplitPane mainSplit;
    private final StackPane center;
    private @Nullable TracedPane traced;
    private @Nullable PreviewPane preview;
    private @Nullable Node properties;
    /** Empty docks that reserve the space of panels. */
    private List<DockSlot> reservedDocks = List.of();
    /** Divider position of the lists before their pane took the whole height. */
    private double listDivider = LIST_SHARE;
    /** Divider position of the side panels before they were hidden. */
    private double sideDivider = CANVAS_SHARE;

    /**
     * Creates the layout with loading notes.
     *
     * @param file file that is being read
     * @param picture picture view that the pane of the traced picture takes over; may already show an image
     */
    EditorLayout(Path file, PictureView picture) {
        this.picture = picture;
        setId("opening");
        getStyleClass().add("editor");
        String reading = Messages.tr("Reading {0} …", file.getFileName());
        canvases = new SplitPane(tracedPlaceholder(reading), placeholder(Messages.tr("Preview"), reading));
        sidePanels = new SplitPane(sidePlaceholder(reading));
        sidePanels.setOrientation(Orientation.VERTICAL);
        upperArea = new SplitPane(canvases);
        workArea = new SplitPane(upperArea);
        workArea.setOrientation(Orientation.VERTICAL);
        mainSplit = new SplitPane(workArea, sidePanels);
        mainSplit.setDividerPositions(CANVAS_SHARE);
        SplitPane.setResizableWithParent(sidePanels, false);
        setTop(spacer(BARS_HEIGHT));
        center = new StackPane(mainSplit);
        setCenter(center);
        setBottom(spacer(STATUS_HEIGHT));
    }

    private static Region spacer(double height) {
        var space = new Region();
        space.setPrefHeight(height);
        return space;
    }

    private static BorderPane placeholder(String title, String text) {
        var note = new Label(text);
        note.getStyleClass().add("canvas-note");
        var canvas = new StackPane(note);
        canvas.getStyleClass().add("canvas");
        var pane = new BorderPane(canvas);
        pane.setTop(new PaneHeader(title));
        return pane;
    }

    /** Returns the approximate height of the traced picture's header at a given width, pixels. */
    static double headerHeight(double width) {
        return width < SINGLE_ROW_WIDTH ? HEADER_HEIGHT + EXTRA_ROW_HEIGHT : HEADER_HEIGHT;
    }

    private BorderPane tracedPlaceholder(String text) {
        var pane = placeholder(Messages.tr("Ray traced"), text);
        ((Region) pane.getTop()).prefHeightProperty().bind(pane.widthProperty().map(w -> headerHeight(w.doubleValue())));
        pane.setCenter(new StackPane(pane.getCenter(), picture));
        Region foot = spacer(FOOTER_HEIGHT);
        foot.getStyleClass().add("pane-footer");
        pane.setBottom(foot);
        return pane;
    }

    /** Reserves the space of an arrangement before the panes exist, so that the first picture has the right size. */
    void reserve(WindowLayout arrangement) {
        CanvasLayout choice = arrangement.canvasLayoutProperty().get();
        if (choice.hasInset() || choice.share() == 1) {
            canvases.getItems().remove(1);
        } else {
            canvases.setDividerPositions(choice.share());
        }
        reservedDocks = List.of(reserveDock(arrangement, PanelPlace.LEFT), reserveDock(arrangement, PanelPlace.BELOW));
    }

    private DockSlot reserveDock(WindowLayout arrangement, PanelPlace place) {
        DockSlot slot = dockSlot(arrangement, place, new Region());
        slot.setShown(!arrangement.panelsProperty().get().openIn(place).isEmpty());
        return slot;
    }

    private DockSlot dockSlot(WindowLayout arrangement, PanelPlace place, Region dock) {
        boolean isLeft = place == PanelPlace.LEFT;
        return new DockSlot(isLeft ? upperArea : workArea, dock, isLeft ? 0 : 1, arrangement.dockSizeProperty(place),
                isLeft ? _ -> LEFT_DOCK_WIDTH : total -> lowerDockHeight(arrangement, total));
    }

    /**
     * Returns the default height of the dock below the pictures, pixels. In a high window the mixer has room for its thumbnails.
     *
     * @param total height of pictures and dock, pixels
     */
    static double lowerDockHeight(WindowLayout arrangement, double total) {
        boolean hasMixer = arrangement.panelsProperty().get().openIn(PanelPlace.BELOW).contains(Command.MIXER);
        return hasMixer ? Math.max(MIN_LOWER_DOCK_HEIGHT, LOWER_DOCK_SHARE * total) : MIN_LOWER_DOCK_HEIGHT;
    }

    PictureView picture() {
        return picture;
    }

    private static VBox sidePlaceholder(String text) {
        var note = new Label(text);
        note.getStyleClass().add("pane-note");
        VBox.setMargin(note, NOTE_INSETS);
        var side = new VBox(new PaneHeader(Messages.tr("Lights")), note);
        side.getStyleClass().add("lights");
        return side;
    }

    void showTraced(TracedPane pane) {
        traced = pane;
        canvases.getItems().set(0, pane);
    }

    /** Adds all panes except the traced picture. */
    void setPanes(Node bars, PreviewPane previewPane, Node lights, Node properties, Node status) {
        setId("editor");
        preview = previewPane;
        if (canvases.getItems().size() == 1) {
            canvases.getItems().add(preview);
        } else {
            canvases.getItems().set(1, preview);
        }
        this.properties = properties;
        sidePanels.getItems().setAll(lights, properties);
        sidePanels.setDividerPositions(LIST_SHARE);
        setTop(bars);
        setBottom(status);
    }

    /** Shows the docks while they have open panels and the panels are not hidden. */
    void addDocks(WindowLayout arrangement, DockedPanels panels) {
        reservedDocks.forEach(slot -> slot.setShown(false));
        addDock(arrangement, PanelPlace.LEFT, dockSlot(arrangement, PanelPlace.LEFT, panels.left()));
        addDock(arrangement, PanelPlace.BELOW, dockSlot(arrangement, PanelPlace.BELOW, panels.below()));
        panels.bind();
        var target = new Region();
        var drag = new TabDrag(workArea, target, panels::drop);
        drag.attach(panels.left());
        drag.attach(panels.below());
        center.getChildren().add(target);
    }

    private static void addDock(WindowLayout arrangement, PanelPlace place, DockSlot slot) {
        Runnable update = () -> slot
                .setShown(!arrangement.panelsHiddenProperty().get() && !arrangement.panelsProperty().get().openIn(place).isEmpty());
        arrangement.panelsProperty().subscribe(update);
        arrangement.panelsHiddenProperty().subscribe(update);
        update.run();
    }

    /** Shows a page over everything right of the traced picture, or over part of the picture if the rest is narrower than the page. */
    void showPage(Region page) {
        page.setMaxHeight(Double.MAX_VALUE);
        StackPane.setAlignment(page, Pos.CENTER_RIGHT);
        page.maxWidthProperty().bind(Bindings.createDoubleBinding(this::pageWidth, tracedPane().boundsInParentProperty(),
                canvases.boundsInParentProperty(), upperArea.boundsInParentProperty(), center.widthProperty()));
        center.getChildren().add(page);
    }

    private double pageWidth() {
        boolean isTracedVisible = canvases.getItems().size() == 2 && canvases.getItems().contains(traced);
        double right = isTracedVisible
                ? center.sceneToLocal(tracedPane().localToScene(tracedPane().getBoundsInLocal())).getMaxX() : 0;
        return Math.max(Math.min(MIN_PAGE_WIDTH, center.getWidth()),
                center.getWidth() - Math.max(right, center.getWidth() * MIN_LEFT_SHARE));
    }

    void hidePage(Region page) {
        center.getChildren().remove(page);
        page.maxWidthProperty().unbind();
    }

    /** Applies the layout now and on every change of it. */
    void bindTo(WindowLayout arrangement) {
        arrangement.canvasLayoutProperty().subscribe(this::showCanvases);
        arrangement.panelsHiddenProperty().subscribe(this::hidePanels);
    }

    private void showCanvases(CanvasLayout choice) {
        List<Node> visible = choice.share() == 1 || choice.hasInset() ? List.of(traced) : choice.share() == 0 ? List.of(preview)
                : List.of(traced, preview);
        Node focusOwner = getScene() == null ? null : getScene().getFocusOwner();
        if (focusOwner != null && canvases.getItems().stream().anyMatch(c -> !visible.contains(c) && isIn(focusOwner, c))) {
            // The toolkit would focus the first button of the tool bar, which the next key would press.
            canvases.requestFocus();
        }
        tracedPane().setInset(null);
        canvases.getItems().retainAll(visible);
        requireNonNull(preview).setCompact(choice.hasInset());
        if (choice.hasInset()) {
            tracedPane().setInset(preview);
        }
        for (int i = 0; i < visible.size(); i++) {
            if (!canvases.getItems().contains(visible.get(i))) {
                canvases.getItems().add(i, visible.get(i));
            }
        }
        if (visible.size() == 2) {
            canvases.setDividerPositions(choice.share());
        }
    }

    /** Gives the lists' pane the whole height of the side panels, or shares it with the properties. */
    void showLists(boolean wholeHeight) {
        if (wholeHeight && sidePanels.getItems().contains(properties)) {
            listDivider = sidePanels.getDividerPositions()[0];
            sidePanels.getItems().remove(properties);
        } else if (!wholeHeight && !sidePanels.getItems().contains(properties)) {
            sidePanels.getItems().add(properties);
            sidePanels.setDividerPositions(listDivider);
        }
    }

    private static boolean isIn(@Nullable Node node, Node ancestor) {
        return node != null && (node == ancestor || isIn(node.getParent(), ancestor));
    }

    private void hidePanels(boolean hidden) {
        if (hidden && mainSplit.getItems().size() == 2) {
            sideDivider = mainSplit.getDividerPositions()[0];
            // Visible panes are never removed, because they would lose keyboard focus and mouse events.
            mainSplit.getItems().remove(sidePanels);
        } else if (!hidden && mainSplit.getItems().size() == 1) {
            mainSplit.getItems().add(sidePanels);
            mainSplit.setDividerPositions(sideDivider);
        }
    }

    /** Returns whether the mouse is over a picture and the focused control uses neither Tab nor the space bar. */
    boolean isOverPictures() {
        return canvases.isHover() && (getScene() == null || !needsTab(getScene().getFocusOwner()));
    }

    /** Returns whether Tab should move the focus: from a text field, or from a control that was reached by the keyboard, not by a click. */
    private static boolean needsTab(Node focusOwner) {
        return focusOwner instanceof TextInputControl || focusOwner instanceof Control && focusOwner.isFocusVisible();
    }

    /** Returns the pane of the traced picture, which was added with the other panes. */
    private TracedPane tracedPane() {
        return requireNonNull(traced);
    }
}
