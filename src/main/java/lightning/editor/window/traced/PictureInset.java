package lightning.editor.window.traced;

import javafx.beans.binding.Bindings;
import javafx.beans.binding.DoubleBinding;
import javafx.beans.property.ObjectProperty;
import javafx.beans.value.ObservableValue;
import javafx.css.PseudoClass;
import javafx.geometry.HPos;
import javafx.geometry.Point2D;
import javafx.geometry.Pos;
import javafx.scene.Cursor;
import javafx.scene.Node;
import javafx.scene.control.Label;
import javafx.scene.control.Tooltip;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.editor.Command;
import lightning.editor.window.model.CommandRegistry;
import lightning.editor.window.model.InsetPlace;
import lightning.editor.window.model.InsetPlace.Corner;
import org.kordamp.ikonli.Ikon;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignC;
import org.kordamp.ikonli.materialdesign2.MaterialDesignR;

/**
 * Pane in a corner of the picture, beside the picture where there is room. Under the mouse it shows handles: one moves it to another corner,
 * one at its inner corner resizes it, and a button hides it.
 */
final class PictureInset extends StackPane {
    /** Width of the inset as a share of the pane's. */
    private static final double INSET_SHARE = 0.3;
    /** Largest share of the picture that the inset covers. */
    private static final double MAX_COVERED = 0.2;
    /** Width in which an inset beside the picture is large enough, pixels. */
    private static final double ENOUGH_BESIDE = 140;

    private final Region area;
    private final ObjectProperty<InsetPlace> place;
    private final DoubleBinding largest;
    /** Where the mouse was pressed to move the inset, in the window. */
    private Point2D grabbed = Point2D.ZERO;

    /**
     * Creates the inset.
     *
     * @param pane content, which gets the picture's aspect ratio
     * @param area pane around the picture, to which the caller adds the inset
     * @param aspect ratio of the picture's width and height
     */
    PictureInset(Region pane, Region area, ObservableValue<Double> aspect, ObjectProperty<InsetPlace> place, CommandRegistry commands) {
        this.area = area;
        this.place = place;
        largest = Bindings.createDoubleBinding(() -> largestWidth(area.getWidth(), area.getHeight(), aspect.getValue()),
                area.widthProperty(), area.heightProperty(), aspect);
        var width = Bindings.createDoubleBinding(() -> largest.get() * place.get().size(), largest, place);
        maxWidthProperty().bind(width);
        maxHeightProperty().bind(Bindings.createDoubleBinding(() -> width.get() / aspect.getValue(), width, aspect));
        Label mover = handle("inset-move", MaterialDesignC.CURSOR_MOVE, Messages.tr("Drag to another corner of the picture"));
        mover.setCursor(Cursor.MOVE);
        mover.setOnMousePressed(event -> grabbed = new Point2D(event.getSceneX(), event.getSceneY()));
        mover.setOnMouseDragged(this::follow);
        mover.setOnMouseReleased(this::drop);
        Label sizer = handle("inset-size", MaterialDesignR.RESIZE, Messages.tr("Drag to resize"));
        sizer.setOnMouseDragged(this::resize);
        Label closer = handle("inset-hide", MaterialDesignC.CLOSE,
                Messages.tr("Hide the preview. {0} shows it again", commands.keyBindings().text(Command.PREVIEW_INSET)));
        closer.setOnMouseClicked(_ -> commands.run(Command.PREVIEW_INSET));
        var outer = new HBox(mover, closer);
        outer.setMaxSize(USE_PREF_SIZE, USE_PREF_SIZE);
        for (Node handle : new Node[] {outer, sizer}) {
            handle.visibleProperty().bind(hoverProperty().or(handle.pressedProperty()));
        }
        getChildren().setAll(pane, outer, sizer);
        place.subscribe(now -> {
            Corner corner = now.corner();
            StackPane.setAlignment(this, corner.position());
            StackPane.setAlignment(outer, corner.position());
            StackPane.setAlignment(sizer, corner.innerCorner());
            boolean isRising = (corner.position().getHpos() == HPos.RIGHT) == (corner.position().getVpos() == Pos.TOP_LEFT.getVpos());
            sizer.setCursor(isRising ? Cursor.NE_RESIZE : Cursor.NW_RESIZE);
            sizer.pseudoClassStateChanged(PseudoClass.getPseudoClass("rising"), isRising);
        });
    }

    /** Returns the largest width of an inset for a pane of some size, with a picture of some ratio of width and height in its middle. */
    static double largestWidth(double width, double height, double aspect) {
        double shown = Math.min(width, height * aspect);
        double beside = (width - shown) / 2;
        double largest = Math.min(INSET_SHARE * width, Math.sqrt(MAX_COVERED) * shown);
        return beside >= ENOUGH_BESIDE ? Math.min(largest, beside) : largest;
    }

    private static Label handle(String id, Ikon icon, String help) {
        var handle = new Label("", new FontIcon(icon));
        handle.setId(id);
        handle.getStyleClass().add("inset-handle");
        handle.setTooltip(new Tooltip(help));
        handle.setAccessibleText(help);
        return handle;
    }

    private void follow(MouseEvent event) {
        setTranslateX(event.getSceneX() - grabbed.getX());
        setTranslateY(event.getSceneY() - grabbed.getY());
    }

    private void drop(MouseEvent event) {
        setTranslateX(0);
        setTranslateY(0);
        Point2D at = area.sceneToLocal(event.getSceneX(), event.getSceneY());
        place.set(place.get().withCorner(Corner.nearest(at.getX() / area.getWidth(), at.getY() / area.getHeight())));
    }

    private void resize(MouseEvent event) {
        double x = sceneToLocal(event.getSceneX(), event.getSceneY()).getX();
        double width = place.get().corner().position().getHpos() == HPos.LEFT ? x : getWidth() - x;
        place.set(place.get().withSize(width / largest.get()));
    }
}
