package lightning.editor.window.measure;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.geometry.Pos;
import javafx.scene.control.Button;
import javafx.scene.control.ProgressBar;
import javafx.scene.layout.HBox;
import javafx.scene.layout.Region;
import javafx.scene.layout.StackPane;
import lightning.base.text.Messages;
import lightning.base.work.Progress;
import lightning.editor.window.model.ErrorMessage;
import lightning.editor.window.widget.DisabledReason;
import lightning.editor.window.widget.VisibilityListener;
import org.jspecify.annotations.Nullable;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;
import org.kordamp.ikonli.materialdesign2.MaterialDesignT;

/** Buttons to start and cancel a background measurement, with a progress bar. */
final class MeasureBar extends HBox {
    private static final double SPACING = 8;

    private final Button measure = new Button(Messages.tr("Measure"), new FontIcon(MaterialDesignT.TIMER_OUTLINE));
    private final Button cancel = new Button(Messages.tr("Cancel"), new FontIcon(MaterialDesignS.STOP));
    private final ProgressBar bar = new ProgressBar(0);
    private final DisabledReason measureReason;
    private final DisabledReason cancelReason;
    private Optional<String> disabledReason = Optional.empty();
    private @Nullable MeasureTask<?> task;

    /**
     * @param suffix  suffix of the buttons' ids, {@code measure} and {@code cancel-measure}
     * @param hint  tooltip without a full stop
     */
    MeasureBar(String suffix, String hint) {
        super(SPACING);
        setAlignment(Pos.CENTER_LEFT);
        measure.setId("measure" + suffix);
        measure.getStyleClass().add("accent");
        measure.setMinWidth(Region.USE_PREF_SIZE);
        cancel.setId("cancel-measure" + suffix);
        cancel.setMinWidth(Region.USE_PREF_SIZE);
        cancel.setOnAction(_ -> cancelTask());
        bar.setAccessibleText(Messages.tr("Measurement progress"));
        var measureBox = new StackPane(measure);
        var cancelBox = new StackPane(cancel);
        measureReason = new DisabledReason(measureBox, measure, hint);
        cancelReason = new DisabledReason(cancelBox, cancel, Messages.tr("Stop measuring"));
        getChildren().addAll(bar, measureBox, cancelBox);
        update();
        // Closing the window cancels the measurement.
        VisibilityListener.attach(this, () -> this::cancelTask);
    }

    /** Sets the action of the Measure button. */
    void setOnMeasure(Runnable action) {
        measure.setOnAction(_ -> action.run());
    }

    /** Sets why measuring is disabled, as a clause; empty to enable it. */
    void setDisabledReason(Optional<String> reason) {
        disabledReason = reason;
        update();
    }

    boolean isBusy() {
        return task != null;
    }

    /**
     * Starts a measurement. The callbacks run on the window's thread.
     *
     * @param thread  name of the measurement's thread
     * @param onFinished  receives the result
     * @param onFailed  receives the message of a failure or cancellation
     */
    <T> void start(String thread, Function<Progress, T> work, Consumer<T> onFinished, Consumer<String> onFailed) {
        var newTask = new MeasureTask<>(thread, work);
        task = newTask;
        newTask.setOnSucceeded(_ -> {
            finishTask();
            onFinished.accept(newTask.getValue());
        });
        newTask.setOnFailed(_ -> {
            finishTask();
            onFailed.accept(ErrorMessage.of(newTask.getException()));
        });
        newTask.setOnCancelled(_ -> {
            finishTask();
            onFailed.accept(Messages.tr("Canceled"));
        });
        bar.progressProperty().bind(newTask.progressProperty());
        newTask.start();
        update();
    }

    private void finishTask() {
        bar.progressProperty().unbind();
        task = null;
        update();
    }

    private void update() {
        measureReason.set(isBusy() ? Optional.of(Messages.tr("a measurement is running")) : disabledReason);
        cancelReason.set(isBusy() ? Optional.empty() : Optional.of(Messages.tr("no measurement is running")));
        bar.setVisible(isBusy());
    }

    /** Cancels the measurement. */
    private void cancelTask() {
        if (task != null) {
            // No interrupt, which would break the waits of the workers.
            task.cancel(false);
        }
    }
}
