package lightning.editor.window.widget;

import java.util.Optional;
import javafx.scene.AccessibleRole;
import javafx.scene.Cursor;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.Region;
import javafx.scene.shape.Circle;
import lightning.base.math.Rgb;
import lightning.base.text.Messages;
import lightning.document.HsvColor;
import lightning.render.image.ViewTransform;
import org.jspecify.annotations.Nullable;

/** Color picker for one hue: saturation to the right, display-encoded value upwards. Drag, or use the arrow keys. */
final class ColorSquare extends Region {
    private static final int COLUMNS = 96;
    private static final int ROWS = 64;
    private static final double HEIGHT = 112;
    private static final int WHITE = 255;
    private static final double KEY_SATURATION = 0.01;
    private static final int KEY_CODES = 4;

    private final WritableImage image = new WritableImage(COLUMNS, ROWS);
    private final ImageView view = new ImageView(image);
    private final Circle marker = new Circle(5);
    private final Setter setter;
    private HsvColor shown = new HsvColor(0, 0, 1);
    private double drawnHue = -1;
    private @Nullable Object gesture;

    /** Receiver of edits; returns why an edit was refused. */
    interface Setter {
        Optional<String> set(HsvColor color, @Nullable Object gesture);
    }

    ColorSquare(Setter setter) {
        this.setter = setter;
        getStyleClass().add("color-square");
        setAccessibleRole(AccessibleRole.SLIDER);
        setAccessibleText(Messages.tr("saturation and value"));
        setFocusTraversable(true);
        setCursor(Cursor.CROSSHAIR);
        marker.getStyleClass().add("marker");
        marker.setManaged(false);
        view.setManaged(false);
        getChildren().addAll(view, marker);
        setMinHeight(HEIGHT);
        setPrefHeight(HEIGHT);
        setOnMousePressed(this::press);
        setOnMouseDragged(this::drag);
        setOnMouseReleased(_ -> gesture = null);
        setOnKeyPressed(this::handleKey);
    }

    void show(HsvColor color) {
        shown = color;
        if (color.hue() != drawnHue) {
            drawnHue = color.hue();
            draw();
        }
        setAccessibleHelp(String.format(Messages.locale(), Messages.tr("saturation %.2f, value %.2f"), color.saturation(), color.value()));
        requestLayout();
    }

    @Override
    protected void layoutChildren() {
        view.setFitWidth(getWidth());
        view.setFitHeight(getHeight());
        marker.setCenterX(shown.saturation() * getWidth());
        marker.setCenterY((1 - code(shown.value()) / (double) WHITE) * getHeight());
        marker.setFill(DisplayColors.color(shown.rgb()));
    }

    private void draw() {
        int[] pixels = new int[COLUMNS * ROWS];
        for (int y = 0; y < ROWS; y++) {
            double value = ViewTransform.linear(WHITE - y * WHITE / (ROWS - 1));
            for (int x = 0; x < COLUMNS; x++) {
                Rgb c = new HsvColor(drawnHue, x / (COLUMNS - 1.0), value).rgb();
                pixels[y * COLUMNS + x] = 0xFF000000 | code(c.r()) << 16 | code(c.g()) << 8 | code(c.b());
            }
        }
        image.getPixelWriter().setPixels(0, 0, COLUMNS, ROWS, PixelFormat.getIntArgbInstance(), pixels, 0, COLUMNS);
    }

    private void press(MouseEvent event) {
        requestFocus();
        gesture = new Object();
        drag(event);
    }

    private void drag(MouseEvent event) {
        if (gesture != null) {
            double saturation = Math.clamp(event.getX() / getWidth(), 0, 1);
            int code = (int) Math.rint(Math.clamp(1 - event.getY() / getHeight(), 0, 1) * WHITE);
            setter.set(new HsvColor(shown.hue(), saturation, ViewTransform.linear(code)), gesture);
            event.consume();
        }
    }

    private void handleKey(KeyEvent event) {
        int right = switch (event.getCode()) {
            case RIGHT -> 1;
            case LEFT -> -1;
            default -> 0;
        };
        int up = switch (event.getCode()) {
            case UP -> 1;
            case DOWN -> -1;
            default -> 0;
        };
        if (right != 0 || up != 0) {
            double saturation = Math.clamp(shown.saturation() + right * KEY_SATURATION, 0, 1);
            double value = up == 0 ? shown.value()
                    : ViewTransform.linear(Math.clamp(code(shown.value()) + up * KEY_CODES, 0, WHITE));
            setter.set(new HsvColor(shown.hue(), saturation, value), null);
            event.consume();
        }
    }

    private static int code(double linear) {
        return ViewTransform.DEFAULT.encode((float) linear);
    }
}
