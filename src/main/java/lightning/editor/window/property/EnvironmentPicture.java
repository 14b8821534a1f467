package lightning.editor.window.property;

import java.util.Optional;
import javafx.beans.value.ObservableValue;
import javafx.scene.Cursor;
import javafx.scene.control.Tooltip;
import javafx.scene.image.ImageView;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.shape.Rectangle;
import lightning.base.text.Messages;
import lightning.document.EditOutcome;
import lightning.editor.EditorState;
import lightning.editor.window.model.SceneEditor;
import lightning.editor.window.widget.PixelImage;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.DomeRotation;
import org.jspecify.annotations.Nullable;

/**
 * Picture of the environment map, as rotated: the direction −z is in its middle. A drag to the side or the arrow keys rotate the map, all in
 * one undo step.
 */
final class EnvironmentPicture extends Region {
    private static final int WIDTH = 288;
    private static final int HEIGHT = 96;
    /** Shown part of the map's height: the ground below the horizon is mostly dark and empty. */
    private static final double SHOWN_HEIGHT = 2.0 * HEIGHT / WIDTH;
    private static final double KEY_STEP = 5;
    /** A drag is rounded to multiples of this, degrees. */
    private static final double DRAG_STEP = 0.5;

    private final SceneEditor editor;
    private final ImageView left = new ImageView();
    private final ImageView right = new ImageView();
    private @Nullable EnvironmentMap shown;
    private @Nullable Object gesture;
    private double pressX;
    private double startRotation;

    EnvironmentPicture(SceneEditor editor, ObservableValue<EditorState> visibleState) {
        this.editor = editor;
        setId("environment-picture");
        getStyleClass().add("environment-picture");
        getChildren().addAll(left, right);
        setMinSize(WIDTH, HEIGHT);
        setMaxSize(WIDTH, HEIGHT);
        setClip(new Rectangle(WIDTH, HEIGHT));
        setCursor(Cursor.H_RESIZE);
        setFocusTraversable(true);
        setAccessibleText(Messages.tr("environment rotation"));
        Tooltip.install(this, new Tooltip(Messages.tr("Drag to the side to rotate the environment")));
        managedProperty().bind(visibleProperty());
        addEventHandler(MouseEvent.MOUSE_PRESSED, this::press);
        addEventHandler(MouseEvent.MOUSE_DRAGGED, this::drag);
        addEventHandler(MouseEvent.MOUSE_RELEASED, _ -> gesture = null);
        addEventHandler(KeyEvent.KEY_PRESSED, this::key);
        visibleState.subscribe(state -> show(Optional.ofNullable(state).map(s -> s.scene().world())));
    }

    private void press(MouseEvent event) {
        if (event.getButton() == MouseButton.PRIMARY) {
            requestFocus();
            gesture = new Object();
            pressX = event.getX();
            startRotation = World.ROTATION.get(editor.scene().world());
            event.consume();
        }
    }

    private void drag(MouseEvent event) {
        if (gesture != null) {
            double turned = startRotation - (event.getX() - pressX) / WIDTH * 360;
            rotate(Math.rint(turned / DRAG_STEP) * DRAG_STEP);
            event.consume();
        }
    }

    private void key(KeyEvent event) {
        if (event.getCode() == KeyCode.ESCAPE && gesture != null) {
            rotate(startRotation);
            gesture = null;
            event.consume();
        } else if (event.getCode() == KeyCode.LEFT || event.getCode() == KeyCode.RIGHT) {
            rotate(World.ROTATION.get(editor.scene().world()) + (event.getCode() == KeyCode.LEFT ? KEY_STEP : -KEY_STEP));
            event.consume();
        }
    }

    private void rotate(double degrees) {
        double wrapped = degrees - 360 * Math.floor((degrees + 180) / 360);
        editor.editOrReport(scene -> EditOutcome.of(() -> scene.withWorld(World.ROTATION.with(scene.world(), wrapped))), gesture);
    }

    private void show(Optional<World> world) {
        Optional<EnvironmentMap> map = world.flatMap(w -> w.environment().map(e -> e.map()));
        setVisible(map.isPresent());
        map.ifPresent(newMap -> {
            if (newMap != shown) {
                shown = newMap;
                left.setImage(PixelImage.of(WIDTH, HEIGHT, pixels(newMap)));
                right.setImage(left.getImage());
            }
            double turns = World.ROTATION.get(world.orElseThrow()) / 360;
            double shift = Math.rint((turns - Math.floor(turns)) * WIDTH);
            left.setLayoutX(-shift);
            right.setLayoutX(WIDTH - shift);
        });
    }

    /** Returns display colors of the map without rotation. */
    private static int[] pixels(EnvironmentMap map) {
        float[] rgb = new float[3 * WIDTH * HEIGHT];
        double[] color = new double[3];
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            double azimuth = 2 * Math.PI * ((i % WIDTH + 0.5) / WIDTH - 0.5);
            double polar = Math.PI * (i / WIDTH + 0.5) / HEIGHT * SHOWN_HEIGHT;
            map.radiance(Math.sin(polar) * Math.sin(azimuth), Math.cos(polar), -Math.sin(polar) * Math.cos(azimuth), DomeRotation.NONE,
                    color);
            for (int c = 0; c < 3; c++) {
                rgb[3 * i + c] = (float) color[c];
            }
        }
        return AutoExposure.toPixels(rgb);
    }

    @Override
    protected double computePrefWidth(double height) {
        return WIDTH;
    }

    @Override
    protected double computePrefHeight(double width) {
        return HEIGHT;
    }
}
