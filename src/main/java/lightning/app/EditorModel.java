package lightning.app;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Function;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.LongProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleLongProperty;
import javafx.beans.property.SimpleObjectProperty;
import javafx.beans.property.SimpleStringProperty;
import javafx.beans.property.StringProperty;
import lightning.edit.Autosave;
import lightning.edit.Change;
import lightning.edit.Command;
import lightning.edit.Frame;
import lightning.edit.OpenDocument;
import lightning.edit.PreviewCamera;
import lightning.edit.RenderLoop;
import lightning.edit.Selection;
import lightning.edit.Situation;
import lightning.image.ViewTransform;
import lightning.scene.Light;
import lightning.scene.Scene;

/**
 * What the panes of the editor show and do: the open document, its traced picture, the selection, and the commands. All
 * methods are called on the window's thread, and none of them waits.
 */
public final class EditorModel implements AutoCloseable {
    private final ReadOnlyObjectWrapper<OpenDocument> document = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<Scene> scene = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<Light> selectedLight = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<Situation> situation = new ReadOnlyObjectWrapper<>();
    private final ReadOnlyObjectWrapper<RenderState> rendering = new ReadOnlyObjectWrapper<>(RenderState.NONE);
    private final ObjectProperty<PreviewCamera> previewCamera = new SimpleObjectProperty<>();
    private final LongProperty previewFrames = new SimpleLongProperty();
    private final LongProperty repaints = new SimpleLongProperty();
    private final BooleanProperty live = new SimpleBooleanProperty();
    private final ObjectProperty<Precision> precision = new SimpleObjectProperty<>(Precision.EXACT);
    private final ObjectProperty<ViewTransform> view = new SimpleObjectProperty<>(ViewTransform.DEFAULT);
    private final StringProperty message = new SimpleStringProperty("");
    private final Map<Command, Runnable> actions = new EnumMap<>(Command.class);
    private final TracedRaster raster = new TracedRaster();
    private final Executor window;
    private final RenderLoop loop;
    private final Autosave autosave;
    private Scene wanted;
    private Scene staged;
    private Light copied;

    /**
     * Opens a document and starts to trace it.
     *
     * @param window   runs tasks in turn on the window's thread
     * @param autosave hears of every edit; closed with this
     */
    public EditorModel(OpenDocument first, Executor window, Autosave autosave) {
        this.window = window;
        this.autosave = autosave;
        loop = new RenderLoop(precision.get().options(), new RenderFeed(window, raster, this::heard));
        LightActions.addTo(this);
        precision.addListener((_, _, now) -> {
            loop.reopen(now.options());
            wanted = wanted == null ? null : rendering.get().frame() == null ? wanted : rendering.get().frame().scene();
            refresh();
        });
        view.addListener((_, _, now) -> {
            loop.setExposure(now.exposure());
            raster.setView(now);
            repaint();
        });
        live.addListener((_, _, on) -> goIfLive());
        open(first);
    }

    /** Takes another document in place of the open one, and traces it. */
    public final void open(OpenDocument other) {
        autosave.forget();
        document.set(other);
        staged = null;
        copied = null;
        previewCamera.set(PreviewCamera.of(other.scene()));
        if (!other.scene().lights().isEmpty()) {
            other.selectLight(other.scene().lights().getFirst().name());
        }
        autosave.changed(other);
        refresh();
        go();
    }

    public ReadOnlyObjectProperty<OpenDocument> documentProperty() {
        return document.getReadOnlyProperty();
    }

    /** The scene as edited: the document's, or what an open animation shows. */
    public ReadOnlyObjectProperty<Scene> sceneProperty() {
        return scene.getReadOnlyProperty();
    }

    /** The selected light as it is now; null if none is selected. */
    public ReadOnlyObjectProperty<Light> selectedLightProperty() {
        return selectedLight.getReadOnlyProperty();
    }

    /** Everything that decides which commands are enabled. */
    public ReadOnlyObjectProperty<Situation> situationProperty() {
        return situation.getReadOnlyProperty();
    }

    /** How far the traced picture is, and the last one. */
    public ReadOnlyObjectProperty<RenderState> renderingProperty() {
        return rendering.getReadOnlyProperty();
    }

    public ObjectProperty<PreviewCamera> previewCameraProperty() {
        return previewCamera;
    }

    /** Counts the frames that the preview has drawn. */
    public LongProperty previewFramesProperty() {
        return previewFrames;
    }

    /** Changes whenever the raster may have. */
    LongProperty repaintsProperty() {
        return repaints;
    }

    /** The raster was changed. */
    void repaint() {
        repaints.set(repaints.get() + 1);
    }

    /** Whether edits are rendered as they are made, without Go. */
    public BooleanProperty liveProperty() {
        return live;
    }

    public ObjectProperty<Precision> precisionProperty() {
        return precision;
    }

    /** How linear light becomes display pixels. */
    public ObjectProperty<ViewTransform> viewProperty() {
        return view;
    }

    /** What the artist should read next: why an edit was refused, what was saved; empty where there is nothing. */
    public StringProperty messageProperty() {
        return message;
    }

    /** Runs tasks in turn on the window's thread. */
    Executor window() {
        return window;
    }

    TracedRaster raster() {
        return raster;
    }

    public OpenDocument document() {
        return document.get();
    }

    public Scene scene() {
        return scene.get();
    }

    public Light selectedLight() {
        return selectedLight.get();
    }

    /** The last traced picture; null before the first. */
    public Frame frame() {
        return rendering.get().frame();
    }

    public void say(String sentence) {
        message.set(sentence);
    }

    /**
     * Makes an edit, of the document or of the animation that is open.
     *
     * @return why it was refused; empty if it was made
     */
    public Optional<String> edit(Function<Scene, Change> edit) {
        return edit(edit, null);
    }

    /**
     * The same as part of a gesture, all of which is one step to undo.
     *
     * @param gesture any object that stands for one drag, told by identity; null for a step of its own
     */
    public Optional<String> edit(Function<Scene, Change> edit, Object gesture) {
        Change change = edit.apply(scene());
        if (staged != null) {
            staged = change.or(staged);
        } else {
            document().apply(change, gesture);
        }
        documentChanged();
        return change.refusal();
    }

    /** Tells that the document was changed: undone, reloaded, saved or edited. */
    public void documentChanged() {
        autosave.changed(document());
        message.set("");
        refresh();
        goIfLive();
    }

    /** Selects the light of that name; nothing where there is none, or for null. */
    public void selectLight(String name) {
        if (name == null) {
            document().select(Selection.NONE);
        } else {
            document().selectLight(name);
        }
        refresh();
    }

    /** Renders the scene as edited, if the picture does not show it yet. */
    public void go() {
        render(scene());
    }

    private void goIfLive() {
        if (live.get() && situation.get().isPending()) {
            go();
        }
    }

    private void render(Scene next) {
        wanted = next;
        loop.render(next);
        refresh();
    }

    /** Makes the mirrors show the lights that the picture shows. */
    public void updateReflections() {
        loop.updateReflections();
    }

    public void verify() {
        loop.verify();
    }

    /** Stops what is being rendered or verified. */
    public void cancel() {
        loop.cancel();
        refresh();
    }

    /** Whether an animation is open: edits then are no edits of the document, and are gone when it is closed. */
    public boolean isAnimating() {
        return staged != null;
    }

    public void beginAnimation() {
        staged = document().scene();
        refresh();
    }

    /** Shows and renders a scene of the animation. */
    public void animate(Scene frame) {
        staged = frame;
        refresh();
        go();
    }

    /** Restores the document's scene, in the picture too. */
    public void endAnimation() {
        staged = null;
        refresh();
        if (situation.get().isPending()) {
            go();
        }
    }

    /** The light whose settings were copied; null if none was. */
    public Light copied() {
        return copied;
    }

    public void copy(Light settings) {
        copied = settings;
        refresh();
    }

    /** Says what a command does; a pane that asks the artist something first says so for its commands. */
    public void setAction(Command command, Runnable action) {
        actions.put(command, action);
    }

    /** Does the command if it is enabled. */
    public void run(Command command) {
        Runnable action = actions.get(command);
        if (enabled(command) && action != null) {
            action.run();
        }
    }

    public boolean enabled(Command command) {
        return command.isEnabled(situation.get());
    }

    /** Why the command is disabled; empty if it is enabled. */
    public Optional<String> reason(Command command) {
        return command.obstacle(situation.get());
    }

    /** The window's focus is back: the file may have changed. */
    public void refresh() {
        OpenDocument open = document();
        if (!loop.isBusy()) {
            wanted = null;
        }
        scene.set(staged == null ? open.scene() : staged);
        Light light = open.selectedLight().flatMap(l -> scene().light(l.name())).orElse(null);
        selectedLight.set(light);
        Situation now = Situation.of(open, Optional.ofNullable(frame()));
        situation.set(new Situation(scene(), now.rendered(), now.mirrored(), Optional.ofNullable(wanted),
                rendering.get().isVerifying(), Optional.ofNullable(light), now.undo(), now.redo(), now.undoLight(),
                now.redoLight(), now.dirty(), now.changedOnDisk(), Optional.ofNullable(copied), staged != null));
    }

    private void heard(RenderState state) {
        rendering.set(state);
        refresh();
        repaint();
    }

    /** The lights of the scene, in its order. */
    public List<Light> lights() {
        return scene().lights();
    }

    /** Stops the threads; nothing is saved. */
    @Override
    public void close() {
        autosave.forget();
        loop.close();
        autosave.close();
    }
}
