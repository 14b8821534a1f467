package lightning.editor.window;

import javafx.scene.layout.Background;
import javafx.scene.layout.Region;
import javafx.scene.paint.Color;
import lightning.editor.window.traced.TracedPane;
import lightning.editor.window.widget.Looks;
import lightning.editor.window.widget.PictureView;

/**
 * What a window shows before anything else: the traced picture where it will stay, and the ground of all panes. It has no control and needs no
 * style sheet, which take longer to be there than the picture.
 */
final class FirstFrame extends Region {
    private static final Color CANVAS = Color.web("#121212");

    private final PictureView picture = TracedPane.view();
    private final Region canvases = new Region();
    private final Region heads = new Region();
    /** Of the traced picture. */
    private final Region own = new Region();
    private final Region foot = new Region();
    /** The bars between two panes. */
    private final Region between = new Region();
    private final Region beside = new Region();

    FirstFrame(Looks looks) {
        setId("opening");
        Color ground = looks == Looks.DARK ? Color.web("#1e1e1e") : Color.web("#f4f4f4");
        Color band = looks == Looks.DARK ? Color.web("#2a2a2a") : Color.web("#e9e9e9");
        setBackground(Background.fill(ground));
        between.setBackground(Background.fill(ground));
        beside.setBackground(Background.fill(ground));
        canvases.setBackground(Background.fill(CANVAS));
        heads.setBackground(Background.fill(band));
        own.setBackground(Background.fill(band));
        foot.setBackground(Background.fill(band));
        getChildren().addAll(canvases, heads, own, foot, between, beside, picture);
    }

    /** Shows the picture, here and wherever it is put. */
    PictureView picture() {
        return picture;
    }

    Region canvases() {
        return canvases;
    }

    Region heads() {
        return heads;
    }

    @Override
    protected void layoutChildren() {
        double pictures = share(getWidth(), EditorFrame.CANVASES);
        double width = share(pictures, 0.5);
        double head = EditorFrame.head(width);
        double top = EditorFrame.BARS + head;
        double bottom = getHeight() - EditorFrame.LINE;
        heads.resizeRelocate(0, EditorFrame.BARS, getWidth(), EditorFrame.HEAD);
        canvases.resizeRelocate(0, EditorFrame.BARS + EditorFrame.HEAD, pictures, bottom - EditorFrame.BARS - EditorFrame.HEAD);
        own.resizeRelocate(0, EditorFrame.BARS, width, head);
        foot.resizeRelocate(0, bottom - EditorFrame.FOOT, width, EditorFrame.FOOT);
        between.resizeRelocate(width, EditorFrame.BARS, EditorFrame.DIVIDER, bottom - EditorFrame.BARS);
        beside.resizeRelocate(pictures, EditorFrame.BARS, EditorFrame.DIVIDER, bottom - EditorFrame.BARS);
        picture.resizeRelocate(0, top, width, bottom - EditorFrame.FOOT - top);
    }

    /** What the first of two panes has of a width. */
    private static double share(double all, double share) {
        return Math.rint(all * share - EditorFrame.DIVIDER / 2);
    }
}
