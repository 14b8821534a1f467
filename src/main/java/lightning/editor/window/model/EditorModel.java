package lightning.editor.window.model;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.function.UnaryOperator;
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
import lightning.base.text.Texts;
import lightning.editor.document.Change;
import lightning.editor.document.Command;
import lightning.editor.document.FileThread;
import lightning.editor.document.Moment;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Recovery;
import lightning.editor.document.Selection;
import lightning.editor.document.Situation;
import lightning.editor.document.Workbench;
import lightning.editor.loop.Frame;
import lightning.editor.loop.RenderState;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Light;
import lightning.scene.Node;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;

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
    private final PreviewLook previewLook = new PreviewLook();
    private final ObjectProperty<PreviewCamera> previewCamera = new SimpleObjectProperty<>();
    private final LongProperty previewFrames = new SimpleLongProperty();
    private final LongProperty repaints = new SimpleLongProperty();
    private final BooleanProperty live = new SimpleBooleanProperty();
    private final ObjectProperty<Precision> precision = new SimpleObjectProperty<>(Precision.EXACT);
    private final ObjectProperty<ViewTransform> view = new SimpleObjectProperty<>(ViewTransform.DEFAULT);
    private final StringProperty message = new SimpleStringProperty("");
    private final PicturePart part = new PicturePart();
    private final Commands commands = new Commands(situation, this::say);
    private final Keys keys = new Keys();
    private final UpdateLog updates = new UpdateLog();
    private final Arrangement arrangement = new Arrangement();
    private final MachineChoice machineChoice = new MachineChoice();
    private final ObjectProperty<Speech> speech = new SimpleObjectProperty<>(Speech.SYSTEM);
    private final TracedRaster raster;
    private final FileThread files;
    private final Workbench workbench;
    private final PictureLook look;
    private final MaterialChoice materials;
    private final LookThrough lookThrough;
    private final FileWork fileWork = new FileWork(this::refresh);
    private final KeyChoice keyChoice = new KeyChoice(this::refresh);
    private final FileBringer bringer = new FileBringer(this);
    /** What an open animation shows in place of the document; null where none is open. */
    private Scene staged;

    /**
     * Takes a document and starts to trace it.
     *
     * @param recovery keeps unsaved edits for the case of a crash
     * @param files    reads and writes beside the window's thread
     */
    public EditorModel(OpenDocument first, Recovery recovery, FileThread files) {
        this(first, Glimpse.none(ViewTransform.DEFAULT), recovery, files);
    }

    /**
     * The same where the scene is looked at already.
     *
     * @param seen of the document's scene
     */
    public EditorModel(OpenDocument first, Glimpse seen, Recovery recovery, FileThread files) {
        this.files = files;
        raster = seen.raster();
        view.set(raster.view());
        workbench = new Workbench(first, precision.get().options(), recovery, files, this::refresh, this::hear, raster,
                why -> window()
                        .execute(() -> say(Texts.of("The last edits could not be kept for the case of a crash: {0}", Sentence.of(why)))));
        LightActions.addTo(this);
        NodeActions.addTo(this);
        ShotActions.addTo(this);
        look = new PictureLook(this);
        materials = new MaterialChoice(this);
        lookThrough = new LookThrough(this);
        precision.addListener((_, _, now) -> workbench.reopen(now.options()));
        view.addListener((_, _, now) -> {
            workbench.setView(now);
            raster.setView(now);
            repaint();
        });
        live.addListener((_, _, on) -> {
            workbench.setLive(on);
            stage(staged);
        });
        commands.setSwitch(Command.LIVE, live);
        commands.setSwitch(Command.HIDE_PANELS, arrangement.panelsHiddenProperty());
        commands.setSwitch(Command.TIMELINE, arrangement.timelineShownProperty());
        commands.setSwitch(Command.FILM_STRIP, arrangement.filmStripShownProperty(), () -> {
            var shown = arrangement.filmStripShownProperty();
            shown.set(!shown.get());
            arrangement.timelineShownProperty().set(arrangement.timelineShownProperty().get() || shown.get());
        });
        commands.setSwitch(Command.HIDE_GIZMOS, previewLook.gizmosHiddenProperty());
        commands.setSwitch(Command.GLOWING_TEXTURES, previewLook.glowingProperty());
        opened();
        workbench.setView(view.get());
        workbench.begin(seen.coarse());
        workbench.go();
    }

    /** Takes another document in place of the open one, and traces it. Unsaved edits are lost: ask before. */
    public void open(OpenDocument other) {
        staged = null;
        workbench.open(other);
        repaint();
        opened();
    }

    /** Takes what a crash left unsaved in place of the open document, and traces it. */
    public void recover(Recovery.Found found, OpenDocument recovered) {
        staged = null;
        workbench.recover(found, recovered);
        repaint();
        opened();
    }

    private void opened() {
        previewCamera.set(PreviewCamera.of(document().scene()));
        arrangement.timelineShownProperty().set(document().moment().isPresent());
        document().scene().lights().stream().findFirst().ifPresent(l -> document().selectLight(l.name()));
        refresh();
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

    /** How the preview looks. */
    public PreviewLook previewLook() {
        return previewLook;
    }

    /** Counts the frames that the preview has drawn. */
    public LongProperty previewFramesProperty() {
        return previewFrames;
    }

    /** Changes whenever the raster may have. */
    public LongProperty repaintsProperty() {
        return repaints;
    }

    /** The raster was changed. */
    public void repaint() {
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

    /** What of the traced picture is shown. */
    public PictureLook look() {
        return look;
    }

    /** Which part of the traced picture the artist points at. */
    public PicturePart part() {
        return part;
    }

    /** Which material is edited. */
    public MaterialChoice materials() {
        return materials;
    }

    /** Brings files from elsewhere beside the scene. */
    public FileBringer bringer() {
        return bringer;
    }

    /** Whether the preview looks through the selected light. */
    public LookThrough lookThrough() {
        return lookThrough;
    }

    /** What the artist should read next: why an edit was refused, what was saved; empty where there is nothing. */
    public StringProperty messageProperty() {
        return message;
    }

    /** Runs tasks in turn on the window's thread. */
    public Executor window() {
        return files.window();
    }

    /** Reads and writes files beside the window's thread. */
    public FileThread files() {
        return files;
    }

    public TracedRaster raster() {
        return raster;
    }

    public OpenDocument document() {
        return workbench.document();
    }

    public Scene scene() {
        return staged == null ? workbench.scene() : staged;
    }

    public Light selectedLight() {
        return selectedLight.get();
    }

    /** The lights of the scene, in its order. */
    public List<Light> lights() {
        return scene().lights();
    }

    /** The last traced picture; null before the first. */
    public Frame frame() {
        return workbench.frame().orElse(null);
    }

    /** What the commands act on. */
    public Workbench workbench() {
        return workbench;
    }

    /** Tells the artist something in the status line, until the next edit. */
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
        say("");
        Change change = edit.apply(scene());
        if (staged == null) {
            return workbench.edit(change, gesture);
        }
        stage(change.or(staged));
        return change.refusal();
    }

    /**
     * Makes an edit of the scene with its shot: of keys, or of what is the same at all frames.
     *
     * @param edit    throws an {@link IllegalArgumentException} that says why it cannot be made
     * @param gesture as in {@link #edit(Function, Object)}
     * @return why it was refused; empty if it was made
     */
    public Optional<String> editAll(UnaryOperator<AnimatedScene> edit, Object gesture) {
        say("");
        if (staged != null) {
            return Optional.of(Texts.of("an animation is open; close it first"));
        }
        return workbench.editAll(() -> edit.apply(document().content()), gesture);
    }

    /**
     * Makes an edit of the document, and selects the shape or the group of a name then.
     *
     * @return why it was refused; empty if it was made
     */
    public Optional<String> editAndSelect(Function<Scene, Change> edit, String node) {
        say("");
        materials.inFrontProperty().set(false);
        return workbench.editAndSelect(edit.apply(document().scene()), new Selection.OfNode(node));
    }

    /** The frame of the shot that is shown; empty where the scene has none. */
    public Optional<Moment> moment() {
        return document().moment();
    }

    /** Shows a frame of the shot in both pictures; edits are made at it from then on. */
    public void showFrame(int frame) {
        PreviewCamera before = PreviewCamera.of(scene());
        say(workbench.showFrame(frame).orElse(""));
        if (previewCamera.get().equals(before)) {
            previewCamera.set(PreviewCamera.of(scene()));
        }
    }

    /**
     * Shows a film of the scene that is being worked at, as another machine made it, until its own picture is there; nothing where that is
     * there already, something else is worked at, or only a part of the picture is looked at.
     */
    public void showAhead(Film film, Scene of) {
        if (situation.get().inWork().filter(s -> s == of).isPresent() && look.isPlain()) {
            raster.ahead(film, of);
            repaint();
        }
    }

    /** Which keys of the shot are chosen. */
    public KeyChoice keyChoice() {
        return keyChoice;
    }

    /** Selects the light of that name; nothing where there is none, or for null. */
    public void selectLight(String name) {
        if (name == null) {
            workbench.select(Selection.NONE);
        } else {
            workbench.selectLight(name);
            materials.inFrontProperty().set(false);
        }
    }

    /** Selects the shape or the group of that name in place of a light; nothing where there is none. */
    public void selectNode(String name) {
        workbench.select(new Selection.OfNode(name));
        materials.inFrontProperty().set(false);
    }

    /** The selected shape or group as it is now; empty while a light is selected. */
    public Optional<Node> selectedNode() {
        return situation.get().node();
    }

    /** Renders the scene as edited. */
    public void go() {
        if (staged == null) {
            workbench.go();
        } else {
            workbench.show(staged);
        }
    }

    /** Whether an animation is open: edits then are no edits of the document, and are gone when it is closed. */
    public boolean isAnimating() {
        return staged != null;
    }

    public void beginAnimation() {
        staged = document().scene();
        workbench.setAnimating(true);
    }

    /** Shows and renders a scene of the animation. */
    public void animate(Scene frame) {
        staged = frame;
        workbench.show(frame);
    }

    private void stage(Scene frame) {
        staged = frame;
        refresh();
        if (staged != null && live.get() && situation.get().isPending()) {
            workbench.show(staged);
        }
    }

    /** Restores the document's scene, in the picture too. */
    public void endAnimation() {
        staged = null;
        workbench.setAnimating(false);
        if (situation.get().isPending()) {
            go();
        }
    }

    /** What the commands do, and which of them have something to do. */
    public Commands commands() {
        return commands;
    }

    /** How the window's room is shared. */
    public Arrangement arrangement() {
        return arrangement;
    }

    /** Which other machines hold frames, where the artist wants that. */
    public MachineChoice machineChoice() {
        return machineChoice;
    }

    /** What the editor speaks from its next start on; titles and labels that stand on the screen stay as they are. */
    public ObjectProperty<Speech> speechProperty() {
        return speech;
    }

    /** What the last updates of the picture did. */
    public UpdateLog updates() {
        return updates;
    }

    /** The keys of the commands. */
    public Keys keys() {
        return keys;
    }

    /** The file that is read or written, which may be given up. */
    public FileWork fileWork() {
        return fileWork;
    }

    /** Stops what runs, and waits no longer for what is read. */
    void cancel() {
        if (fileWork.giveUp()) {
            // How far it was.
            say("");
        }
        workbench.cancel();
    }

    /** Looks at everything anew. */
    public void refresh() {
        if (rendering.get() != workbench.rendering()) {
            hear();
        }
        document.set(document());
        scene.set(scene());
        Light light = document().selectedLight().flatMap(l -> scene().light(l.name())).orElse(null);
        selectedLight.set(light);
        Situation s = workbench.situation().withReading(fileWork.file() != null).withChosenKeys(keyChoice.settled(document().content()));
        situation.set(staged == null ? s : s.withStaged(staged, Optional.ofNullable(light), document().selection().node(staged)));
    }

    private void hear() {
        rendering.set(workbench.rendering());
        updates.hear(rendering.get());
        repaint();
    }

    /** Stops the threads; nothing is saved. */
    @Override
    public void close() {
        workbench.close();
    }
}
