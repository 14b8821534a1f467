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
import lightning.base.text.Texts;
import lightning.base.work.Progress;
import lightning.editor.window.model.Sentence;
import lightning.editor.window.widget.Obstacle;
import lightning.editor.window.widget.WhileSeen;
import org.kordamp.ikonli.javafx.FontIcon;
import org.kordamp.ikonli.materialdesign2.MaterialDesignS;
import org.kordamp.ikonli.materialdesign2.MaterialDesignT;

/** The buttons that measure something beside the editor and cancel it, and how far that is. */
final class MeasureBar extends HBox {
    private static final double SPACING = 8;

    private final Button measure = new Button(Texts.of("Measure"), new FontIcon(MaterialDesignT.TIMER_OUTLINE));
    private final Button cancel = new Button(Texts.of("Cancel"), new FontIcon(MaterialDesignS.STOP));
    private final ProgressBar bar = new ProgressBar(0);
    private final Obstacle measuring;
    private final Obstacle cancelling;
    private Optional<String> obstacle = Optional.empty();
    private MeasureTask<?> task;

    /**
     * @param suffix of the buttons' ids, {@code measure} and {@code cancel-measure}
     * @param hint   what measuring does, a sentence without a full stop
     */
    MeasureBar(String suffix, String hint) {
        super(SPACING);
        setAlignment(Pos.CENTER_LEFT);
        measure.setId("measure" + suffix);
        measure.getStyleClass().add("accent");
        measure.setMinWidth(Region.USE_PREF_SIZE);
        cancel.setId("cancel-measure" + suffix);
        cancel.setMinWidth(Region.USE_PREF_SIZE);
        cancel.setOnAction(_ -> stop());
        bar.setAccessibleText(Texts.of("Progress of measuring"));
        var measureBox = new StackPane(measure);
        var cancelBox = new StackPane(cancel);
        measuring = new Obstacle(measureBox, measure, hint);
        cancelling = new Obstacle(cancelBox, cancel, Texts.of("Stop measuring"));
        getChildren().addAll(bar, measureBox, cancelBox);
        update();
        // Nothing is measured for a window that is closed.
        WhileSeen.follow(this, () -> this::stop);
    }

    /** Says what begins when the artist asks to measure. */
    void setOnMeasure(Runnable begin) {
        measure.setOnAction(_ -> begin.run());
    }

    /** Why there is nothing to measure, a clause; empty where there is. */
    void setObstacle(Optional<String> reason) {
        obstacle = reason;
        update();
    }

    boolean isBusy() {
        return task != null;
    }

    /**
     * Begins to measure; what follows is called on the window's thread.
     *
     * @param finished hears what came of it
     * @param ended    hears why nothing came of it
     */
    <T> void begin(String thread, Function<Progress, T> work, Consumer<T> finished, Consumer<String> ended) {
        var own = new MeasureTask<>(thread, work);
        task = own;
        own.setOnSucceeded(_ -> {
            over();
            finished.accept(own.getValue());
        });
        own.setOnFailed(_ -> {
            over();
            ended.accept(Sentence.of(own.getException()));
        });
        own.setOnCancelled(_ -> {
            over();
            ended.accept(Texts.of("Cancelled"));
        });
        bar.progressProperty().bind(own.progressProperty());
        own.begin();
        update();
    }

    private void over() {
        bar.progressProperty().unbind();
        task = null;
        update();
    }

    private void update() {
        measuring.set(isBusy() ? Optional.of(Texts.of("it is being measured")) : obstacle);
        cancelling.set(isBusy() ? Optional.empty() : Optional.of(Texts.of("nothing is being measured")));
        bar.setVisible(isBusy());
    }

    /** Gives up what is being measured. */
    private void stop() {
        if (task != null) {
            // Without an interrupt, which would break the workers' waiting.
            task.cancel(false);
        }
    }
}
