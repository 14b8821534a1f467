package lightning.editor.window;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import javafx.beans.binding.Bindings;
import javafx.beans.binding.BooleanExpression;
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
import lightning.editor.window.model.WindowLayout;
import lightning.editor.window.model.WindowLayout.CanvasLayout;
import lightning.editor.window.preview.PreviewPane;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.PaneHeader;
import lightning.editor.window.widget.PictureView;

/**
 * Layout of the editor's panes. Each area shows a loading note until its pane is added: the traced picture first, then all others. Panes
 * stay in their parents, because a move to another window discards their applied styles.
 */
final class EditorLayout extends BorderPane {
    /** Share of the window's width that the two picture panes take. */
    static final double CANVAS_SHARE = 0.74;
    private static final double LIST_SHARE = 0.36;
    /** Initial height of the timeline, pixels; {@link #MAX_TIMELINE_SHARE} limits it further. */
    private static final double TIMELINE_HEIGHT = 200;
    private static final double MAX_TIMELINE_SHARE = 0.4;
    /** Approximate height of menu bar and tool bar, pixels. Reserves their space, so that little moves when they are added. */
    static final double BARS_HEIGHT = 72;
    static final double STATUS_HEIGHT = 27;
    /** Approximate height of a pane's header, pixels. Reserves its space, so that little moves when it is added. */
    static final double HEADER_HEIGHT = 36;
    static final double FOOTER_HEIGHT = 38;
    /** Approximate width that fits all controls of the traced picture in one row, pixels. */
    private static final double SINGLE_ROW_WIDTH = 589;
    private static final double EXTRA_ROW_HEIGHT = 30;
    /** Width of the divider between two panes, pixels. */
    static final double DIVIDER_WIDTH = 4;
    /** Minimum width of a page next to the traced picture, pixels. */
    private static final double MIN_PAGE_WIDTH = 460;
    /** Share of the width that a page always leaves free, unless the window is too narrow. */
    private static final double MIN_LEFT_SHARE = 0.3;
    /** Insets of a loading note, aligned with the text of the header above it. */
    private static final Insets NOTE_INSETS = new Insets(6, 12, 6, 12);

    private final PictureView picture;
    private final SplitPane canvases;
    /** Picture panes with the timeline below. */
    private final SplitPane workArea;
    private final SplitPane sidePanels;
    private final SplitPane mainSplit;
    private final StackPane center;
    private TracedPane traced;
    private PreviewPane preview;
    private Node timeline;
    /** Strong reference: the binding notifies its listeners only while it is reachable. */
    private BooleanExpression timelineShown;
    /** Divider position of the timeline; 0 before the timeline is first shown. */
    private double timelineDivider;
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
        workArea = new SplitPane(canvases);
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
    void reserve(CanvasLayout choice) {
        if (choice.hasInset() || choice.share() == 1) {
            canvases.getItems().remove(1);
        } else {
            canvases.setDividerPositions(choice.share());
        }
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
        sidePanels.getItems().setAll(lights, properties);
        sidePanels.setDividerPositions(LIST_SHARE);
        setTop(bars);
        setBottom(status);
    }

    /**
     * Shows the timeline below the pictures while it is switched on and the panels are not hidden. Creates it on first use.
     *
     * @return action that creates the timeline ahead of time
     */
    Runnable addTimeline(WindowLayout arrangement, Supplier<Node> factory) {
        Runnable create = () -> {
            if (timeline == null) {
                timeline = factory.get();
                SplitPane.setResizableWithParent(timeline, false);
            }
        };
        var shown = arrangement.timelineShownProperty().and(arrangement.panelsHiddenProperty().not());
        timelineShown = shown;
        shown.subscribe(on -> {
            if (on) {
                create.run();
            }
            if (on && workArea.getItems().size() == 1) {
                // Without this layout pass, the split pane would give the new pane only its minimum height.
                applyCss();
                layout();
                workArea.getItems().add(timeline);
                if (timelineDivider > 0) {
                    workArea.setDividerPositions(timelineDivider);
                } else {
                    workArea.heightProperty().subscribe(_ -> placeTimelineDivider());
                }
            } else if (!on && workArea.getItems().size() == 2) {
                timelineDivider = workArea.getDividerPositions()[0];
                workArea.getItems().remove(timeline);
            }
        });
        return create;
    }

    private void placeTimelineDivider() {
        if (timelineDivider == 0 && workArea.getHeight() > 0 && workArea.getItems().size() == 2) {
            timelineDivider = 1 - Math.min(MAX_TIMELINE_SHARE, TIMELINE_HEIGHT / workArea.getHeight());
            workArea.setDividerPositions(timelineDivider);
        }
    }

    /** Shows a page over everything right of the traced picture, or over part of the picture if the rest is narrower than the page. */
    void showPage(Region page) {
        page.setMaxHeight(Double.MAX_VALUE);
        StackPane.setAlignment(page, Pos.CENTER_RIGHT);
        page.maxWidthProperty().bind(Bindings.createDoubleBinding(this::pageWidth, traced.boundsInParentProperty(),
                canvases.widthProperty(), center.widthProperty()));
        center.getChildren().add(page);
    }

    private double pageWidth() {
        boolean isTracedVisible = canvases.getItems().size() == 2 && canvases.getItems().contains(traced);
        double right = isTracedVisible ? traced.getBoundsInParent().getMaxX() : 0;
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
        traced.setInset(null);
        canvases.getItems().retainAll(visible);
        preview.setCompact(choice.hasInset());
        if (choice.hasInset()) {
            traced.setInset(preview);
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

    /** Returns true if the mouse is over a picture and the focused control uses neither Tab nor the space bar. */
    boolean isOverPictures() {
        return canvases.isHover() && (getScene() == null || !needsTab(getScene().getFocusOwner()));
    }

    /** Returns true if Tab should move the focus: from a text field, or from a control that was reached by the keyboard, not by a click. */
    private static boolean needsTab(Node focusOwner) {
        return focusOwner instanceof TextInputControl || focusOwner instanceof Control && focusOwner.isFocusVisible();
    }
}
