package lightning.editor.window.timeline;

import static java.util.Objects.requireNonNull;

import java.util.Optional;
import java.util.function.Supplier;
import javafx.beans.property.IntegerProperty;
import javafx.beans.property.ReadOnlyBooleanWrapper;
import javafx.beans.property.ReadOnlyStringProperty;
import javafx.beans.property.ReadOnlyStringWrapper;
import javafx.beans.property.SimpleIntegerProperty;
import lightning.base.text.Messages;
import lightning.base.text.Quote;
import lightning.document.KeyEdits;
import lightning.document.OpenDocument;
import lightning.document.ShotFrame;
import lightning.document.motion.MotionPathFile;
import lightning.document.motion.MotionRecorder;
import lightning.document.motion.RecordedShot;
import lightning.editor.Command;
import lightning.editor.window.command.PathPrompt;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.ErrorMessage;
import lightning.scene.shot.AnimatedScene;
import lightning.scene.shot.Shot;
import org.jspecify.annotations.Nullable;

/**
 * Records the movement of the selected light into the shot, with a keyframe every few frames of the preview (paper §3.7), and converts its keyframes from
 * and to files.
 */
public final class MotionRecording {
    private static final String EXTENSION = "path";

    private final EditorModel model;
    private final Supplier<PathPrompt> prompt;
    private final ReadOnlyBooleanWrapper recording = new ReadOnlyBooleanWrapper();
    private final ReadOnlyStringWrapper status = new ReadOnlyStringWrapper("");
    private final IntegerProperty interval = new SimpleIntegerProperty(RecordedShot.DEFAULT_INTERVAL);
    private String light = "";
    private @Nullable OpenDocument document;
    private @Nullable MotionRecorder recorder;

    /** Registers the commands. @param prompt creates a prompt for files */
    public MotionRecording(EditorModel model, Supplier<PathPrompt> prompt) {
        this.model = model;
        this.prompt = prompt;
        model.commands().setToggle(Command.MAKE_ANIMATION, recording, this::toggle);
        model.commands().setAction(Command.WAY_TO_KEYS, this::open);
        model.commands().setAction(Command.KEYS_TO_WAY, this::save);
        model.previewSettings().framesProperty().addListener((_, _, _) -> recordFrame());
        // What was recorded belongs to the light that was selected.
        model.editor().editorStateProperty().subscribe(_ -> {
            if (recording.get() && (model.editor().document() != document || !model.editor().selection().lightName().equals(light))) {
                stop();
            }
        });
    }

    /** Returns the frames of the preview from one keyframe to the next, 1…{@value RecordedShot#MAX_INTERVAL}. */
    IntegerProperty intervalProperty() {
        return interval;
    }

    /** Returns what is recorded, as text; empty while nothing is recorded. */
    ReadOnlyStringProperty statusProperty() {
        return status.getReadOnlyProperty();
    }

    private void toggle() {
        if (recording.get()) {
            stop();
        } else {
            light = model.editor().selection().lightName();
            document = model.editor().document();
            recorder = new MotionRecorder(interval.get());
            model.layout().timelineShownProperty().set(true);
            recording.set(true);
            recordFrame();
        }
    }

    private void recordFrame() {
        if (recording.get()) {
            MotionRecorder running = requireNonNull(recorder);
            model.editor().scene().light(light).ifPresent(running::recordFrame);
            status.set(Messages.tr("Recording {0}: {1} frames", light, running.frameCount()));
        }
    }

    private void stop() {
        recording.set(false);
        status.set("");
        if (model.editor().document() == document) {
            requireNonNull(recorder).recordedShot().ifPresent(this::addKeys);
        }
    }

    /** Adds the movement to the shot, from the current frame on. Shows a message if that fails. */
    private void addKeys(RecordedShot recorded) {
        Optional<String> refusal = model.editor().editShotOrReport(scene -> {
            AnimatedScene sceneWithShot = KeyEdits.addShot(scene);
            Shot shot = sceneWithShot.shot().orElseThrow();
            int first = model.editor().document().shotFrame().map(ShotFrame::frame).orElse(shot.first());
            return sceneWithShot.withShot(recorded.addTo(shot, first));
        }, null);
        if (refusal.isEmpty()) {
            model.layout().timelineShownProperty().set(true);
            model.editor().message().show(Messages.tr("{0} keyframes over {1} frames", recorded.keyCount(), recorded.frameCount()));
        }
    }

    private void open() {
        String selected = model.editor().selection().lightName();
        OpenDocument opened = model.editor().document();
        prompt.get().fileToOpen(Messages.tr("Open Motion Path"), EXTENSION)
                .ifPresent(file -> model.files().runConcurrently(() -> MotionPathFile.load(file, selected), loaded -> {
                    if (model.editor().document() == opened) {
                        addKeys(loaded);
                    }
                }, failure -> show(Messages.tr("Not opened: {0}", ErrorMessage.of(failure)))));
    }

    private void save() {
        String selected = model.editor().selection().lightName();
        model.editor().document().shotFrame().flatMap(m -> RecordedShot.of(m.shot(), selected))
                .ifPresentOrElse(path -> save(path, selected), () -> show(
                        Messages.tr("Expected linear keyframes of position and direction at the same, evenly spaced frames")));
    }

    private void save(RecordedShot path, String selected) {
        String name = model.editor().document().name().replaceFirst("\\.[^.]*$", "") + "-" + selected + "." + EXTENSION;
        prompt.get().fileToSave(Messages.tr("Save Motion Path"), name, EXTENSION).ifPresent(file -> model.files().runInOrder(() -> {
            MotionPathFile.save(path, file);
            return file;
        }, saved -> show(Messages.tr("Saved to {0}", Quote.path(saved))),
                failure -> show(Messages.tr("Not saved: {0}", ErrorMessage.of(failure)))));
    }

    private void show(String text) {
        model.editor().message().show(text);
    }
}
