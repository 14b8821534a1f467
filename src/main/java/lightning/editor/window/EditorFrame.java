package lightning.editor.window;

import java.nio.file.Path;
import java.util.List;
import java.util.function.Supplier;
import javafx.beans.binding.BooleanExpression;
import javafx.geometry.Insets;
import javafx.geometry.Orientation;
import javafx.scene.Node;
import javafx.scene.control.Control;
import javafx.scene.control.Label;
import javafx.scene.control.SplitPane;
import javafx.scene.layout.BorderPane;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import javafx.scene.layout.VBox;
import lightning.base.text.Texts;
import lightning.editor.window.model.Arrangement;
import lightning.editor.window.model.Arrangement.Canvases;
import lightning.editor.window.widget.PaneHeader;
import lightning.editor.window.widget.PictureView;

/**
 * The places of the editor's panes. Each holds what says that the scene is being read, until its pane comes: the traced picture
 * first, then all others. Panes stay where they were put, since looks are lost on the way from one window into another.
 */
final class EditorFrame extends BorderPane {
    /** The share of the two pictures in the window's width. */
    static final double CANVASES = 0.74;
    private static final double LIST = 0.36;
    /** Of the timeline when it is first shown, pixels, and its most share of the height. */
    private static final double TIMELINE = 200;
    private static final double MOST_TIMELINE = 0.4;
    /** About what menu and tools take, and the line at the bottom, pixels: so that little moves when they come. */
    static final double BARS = 72;
    static final double LINE = 27;
    /** About what the head of a pane takes, and the lines below the traced picture of what a pixel is made of, pixels: for the same reason. */
    static final double HEAD = 36;
    static final double FOOT = 38;
    /** About how wide the traced picture is where all its controls are in a row, and what a second row takes, pixels. */
    private static final double ONE_ROW = 589;
    private static final double ROW = 30;
    /** Of the bar between two panes, pixels. */
    static final double DIVIDER = 4;
    /** Below the header, whose text begins there. */
    private static final Insets NOTE = new Insets(6, 12, 6, 12);

    private final PictureView picture;
    private final SplitPane canvases;
    /** The pictures, and below them the timeline. */
    private final SplitPane work;
    private final SplitPane side;
    private final SplitPane all;
    private Node traced;
    private Node preview;
    private Node timeline;
    /** Kept, since it is told only as long as somebody has it. */
    private BooleanExpression timelineWanted;
    /** Where the timeline begins; 0 before it was first shown. */
    private double below;
    /** Where the border of the panels was before they were hidden. */
    private double border = CANVASES;

    /**
     * @param file    what is being read
     * @param picture what is shown in the place of the traced picture, whose pane goes on with it; it may show something already
     */
    EditorFrame(Path file, PictureView picture) {
        this.picture = picture;
        setId("opening");
        getStyleClass().add("editor");
        String reading = Texts.of("Reading {0} …", file.getFileName());
        canvases = new SplitPane(glimpse(reading), note(Texts.of("Preview"), reading));
        side = new SplitPane(sideNote(reading));
        side.setOrientation(Orientation.VERTICAL);
        work = new SplitPane(canvases);
        work.setOrientation(Orientation.VERTICAL);
        all = new SplitPane(work, side);
        all.setDividerPositions(CANVASES);
        SplitPane.setResizableWithParent(side, false);
        setTop(space(BARS));
        setCenter(all);
        setBottom(space(LINE));
    }

    private static Region space(double height) {
        var space = new Region();
        space.setPrefHeight(height);
        return space;
    }

    private static BorderPane note(String title, String text) {
        var note = new Label(text);
        note.getStyleClass().add("canvas-note");
        var canvas = new StackPane(note);
        canvas.getStyleClass().add("canvas");
        var pane = new BorderPane(canvas);
        pane.setTop(new PaneHeader(title));
        return pane;
    }

    /** About what the head of the traced picture takes that is so wide, pixels. */
    static double head(double width) {
        return width < ONE_ROW ? HEAD + ROW : HEAD;
    }

    private BorderPane glimpse(String text) {
        var pane = note(Texts.of("Ray traced"), text);
        ((Region) pane.getTop()).prefHeightProperty().bind(pane.widthProperty().map(w -> head(w.doubleValue())));
        pane.setCenter(new StackPane(pane.getCenter(), picture));
        Region foot = space(FOOT);
        foot.getStyleClass().add("pane-footer");
        pane.setBottom(foot);
        return pane;
    }

    PictureView picture() {
        return picture;
    }

    private static VBox sideNote(String text) {
        var note = new Label(text);
        note.getStyleClass().add("pane-note");
        VBox.setMargin(note, NOTE);
        var side = new VBox(new PaneHeader(Texts.of("Lights")), note);
        side.getStyleClass().add("lights");
        return side;
    }

    void showTraced(Node pane) {
        traced = pane;
        canvases.getItems().set(0, pane);
    }

    /** Puts in all but the traced picture. */
    void fill(Node bars, Node previewed, Node lights, Node properties, Node status) {
        setId("editor");
        preview = previewed;
        canvases.getItems().set(1, preview);
        side.getItems().setAll(lights, properties);
        side.setDividerPositions(LIST);
        setTop(bars);
        setBottom(status);
    }

    /**
     * Shows the timeline below the pictures while it is wanted and the panels are not hidden; it is made when it first is.
     *
     * @return makes it before
     */
    Runnable addTimeline(Arrangement arrangement, Supplier<Node> made) {
        Runnable make = () -> {
            if (timeline == null) {
                timeline = made.get();
                SplitPane.setResizableWithParent(timeline, false);
            }
        };
        var wanted = arrangement.timelineShownProperty().and(arrangement.panelsHiddenProperty().not());
        timelineWanted = wanted;
        wanted.subscribe(on -> {
            if (on) {
                make.run();
            }
            if (on && work.getItems().size() == 1) {
                // A pane that comes while its neighbours' room is about to change gets the least that it can do with.
                applyCss();
                layout();
                work.getItems().add(timeline);
                if (below > 0) {
                    work.setDividerPositions(below);
                } else {
                    work.heightProperty().subscribe(_ -> firstTimeline());
                }
            } else if (!on && work.getItems().size() == 2) {
                below = work.getDividerPositions()[0];
                work.getItems().remove(timeline);
            }
        });
        return make;
    }

    private void firstTimeline() {
        if (below == 0 && work.getHeight() > 0 && work.getItems().size() == 2) {
            below = 1 - Math.min(MOST_TIMELINE, TIMELINE / work.getHeight());
            work.setDividerPositions(below);
        }
    }

    /** Gives the pictures their room, now and whenever it is wanted otherwise. */
    void follow(Arrangement arrangement) {
        arrangement.canvasesProperty().subscribe(this::arrange);
        arrangement.panelsHiddenProperty().subscribe(this::hidePanels);
    }

    private void arrange(Canvases wanted) {
        List<Node> seen = wanted.share() == 1 ? List.of(traced) : wanted.share() == 0 ? List.of(preview) : List.of(traced, preview);
        canvases.getItems().retainAll(seen);
        for (int i = 0; i < seen.size(); i++) {
            if (!canvases.getItems().contains(seen.get(i))) {
                canvases.getItems().add(i, seen.get(i));
            }
        }
        if (seen.size() == 2) {
            canvases.setDividerPositions(wanted.share());
        }
    }

    private void hidePanels(boolean hidden) {
        if (hidden && all.getItems().size() == 2) {
            border = all.getDividerPositions()[0];
            // What stays is never taken out: it would lose the keyboard and the mouse.
            all.getItems().remove(side);
        } else if (!hidden && all.getItems().size() == 1) {
            all.getItems().add(side);
            all.setDividerPositions(border);
        }
    }

    /** Whether the mouse is over one of the pictures, and what has the keyboard needs neither Tab nor the space bar. */
    boolean isOverPictures() {
        return canvases.isHover() && (getScene() == null || !(getScene().getFocusOwner() instanceof Control));
    }
}
