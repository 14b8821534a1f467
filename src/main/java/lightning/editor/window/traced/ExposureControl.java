package lightning.editor.window.traced;

import java.util.List;
import java.util.Optional;
import javafx.geometry.Pos;
import javafx.scene.Node;
import javafx.scene.control.Slider;
import javafx.scene.control.Tooltip;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.scene.layout.HBox;
import lightning.base.text.Messages;
import lightning.base.text.NumberUnit;
import lightning.document.StepRange;
import lightning.editor.window.model.StatusMessage;
import lightning.editor.window.model.ViewActions;
import lightning.editor.window.widget.NumberField;
import lightning.editor.window.widget.NumberSetting;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignB;

/** Exposure of the scene's view in stops, as a slider and a number field. */
final class ExposureControl extends HBox {
    private static final StepRange STEPS = ViewActions.EXPOSURE_RANGE;
    private static final double KEY_STOPS = 0.25;
    /** Width of the slider's track, pixels: one pixel is about a tenth of a stop. */
    private static final double TRACK_WIDTH = 136;
    /** Minimum distance of a drag from the press, pixels. Ignores small movements during a double-click. */
    private static final double DRAG_THRESHOLD = 3;

    private static final double NARROW_WIDTH = 72;
    private static final double GAP = 4;
    /** Width that a narrow slider saves, pixels. */
    static final double NARROW_SAVING = TRACK_WIDTH - NARROW_WIDTH;
    /** Width that hiding a narrow slider saves, pixels. */
    static final double SLIDER_SAVING = NARROW_WIDTH + GAP;

    private final ViewActions views;
    private final StatusMessage message;
    private final Slider slider = new Slider(STEPS.min(), STEPS.max(), 0);
    private boolean isUpdating;
    /** Identifies the drag of the slider; null while it is not dragged. */
    private @Nullable Object drag;
    /** True if the last press became a drag: a press soon after it is not a double-click. */
    private boolean isDrag;
    private double pressedX;
    private double startStops;

    ExposureControl(ViewActions views, StatusMessage message) {
        this.views = views;
        this.message = message;
        slider.setId("exposure");
        slider.setAccessibleText(Messages.tr("Exposure"));
        slider.setBlockIncrement(KEY_STOPS);
        setNarrow(false);
        // The slider's own mouse handlers would jump to the pointer at the first press of a double-click, which is an edit.
        slider.addEventFilter(MouseEvent.MOUSE_PRESSED, this::press);
        slider.addEventFilter(MouseEvent.MOUSE_DRAGGED, this::drag);
        slider.addEventFilter(MouseEvent.MOUSE_RELEASED, this::release);
        // Dragging sets tenths of a stop; typed values keep all digits. The slider's first value is not an edit.
        slider.valueProperty().subscribe((_, v) -> {
            if (!isUpdating) {
                set(Math.rint(v.doubleValue() / STEPS.step()) / Math.rint(1 / STEPS.step()), drag);
            }
        });
        var stops =
                new NumberField(Messages.tr("Exposure in stops"), NumberSetting.of("exposure", STEPS, NumberUnit.STOPS, this::set));
        stops.setId("exposure-stops");
        Tooltip.install(this, new Tooltip(
                Messages.tr("Exposure of the view in stops (double-click to reset).\nSaved in the scene; the lights do not change.")));
        setAlignment(Pos.CENTER);
        setSpacing(GAP);
        getChildren().setAll(List.<Node>of(new FontIcon(MaterialDesignB.BRIGHTNESS_6), slider, stops));
        views.viewProperty().subscribe(now -> {
            isUpdating = true;
            slider.setValue(now.exposure());
            isUpdating = false;
            stops.show(now.exposure());
        });
    }

    private void press(MouseEvent e) {
        slider.requestFocus();
        e.consume();
        if (e.getButton() != MouseButton.PRIMARY) {
            return;
        }
        if (e.getClickCount() == 2 && !isDrag) {
            set(0, null);
            return;
        }
        drag = new Object();
        isDrag = false;
        pressedX = e.getX();
        startStops = slider.getValue();
    }

    private void drag(MouseEvent e) {
        e.consume();
        isDrag |= drag != null && Math.abs(e.getX() - pressedX) >= DRAG_THRESHOLD;
        if (drag != null && isDrag) {
            slider.setValue(startStops + (e.getX() - pressedX) * (STEPS.max() - STEPS.min()) / slider.getMinWidth());
        }
    }

    private void release(MouseEvent e) {
        e.consume();
        drag = null;
    }

    /** Makes the slider shorter; it still sets tenths of a stop, by more than one for each pixel. */
    void setNarrow(boolean narrow) {
        slider.setMinWidth(narrow ? NARROW_WIDTH : TRACK_WIDTH);
        slider.setPrefWidth(narrow ? NARROW_WIDTH : TRACK_WIDTH);
    }

    /** Leaves only the number field. */
    void setSliderHidden(boolean hidden) {
        slider.setVisible(!hidden);
        slider.setManaged(!hidden);
    }

    private Optional<String> set(double stops, @Nullable Object gesture) {
        Optional<String> refusal = views.setExposure(stops, gesture);
        refusal.ifPresent(message::show);
        return refusal;
    }
}
