package lightning.editor.window.model;

import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.base.text.Texts;
import lightning.editor.document.Command;
import lightning.editor.document.FileThread;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.Recovery;
import lightning.editor.document.Workbench;
import lightning.render.image.ViewTransform;

/**
 * Makes the objects that a window's panes work on, connects them, and opens documents in them. Panes take those that they need. All of them
 * belong to the window's thread, and none of their methods waits.
 */
public final class EditorModel implements AutoCloseable {
    private final FileThread files;
    private final FileWork fileWork = new FileWork(this::refresh);
    private final KeyChoice keyChoice = new KeyChoice(this::refresh);
    private final Arrangement arrangement = new Arrangement();
    private final MachineChoice machineChoice = new MachineChoice();
    private final PreviewLook previewLook = new PreviewLook();
    private final PicturePart part = new PicturePart();
    private final ObjectProperty<Precision> precision = new SimpleObjectProperty<>(Precision.EXACT);
    private final ObjectProperty<Speech> speech = new SimpleObjectProperty<>(Speech.SYSTEM);
    private final Workbench workbench;
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final Commands commands;
    private final PictureLook look;
    private final MaterialChoice materials;
    private final FileBringer bringer;
    private final UpdateLog updates;

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
        workbench = new Workbench(first, precision.get().options(), recovery, files, this::refresh, this::progressed, seen.raster(),
                why -> files.window().execute(() -> sayNotKept(why)));
        editor = new SceneEditor(workbench, previewLook.cameraProperty(), fileWork, keyChoice);
        picture = new TracedPicture(workbench, seen.raster());
        updates = new UpdateLog(picture.renderingProperty());
        commands = new Commands(editor.situationProperty(), editor.message());
        look = new PictureLook(editor, workbench, commands);
        materials = new MaterialChoice(editor);
        bringer = new FileBringer(editor, files);
        precision.addListener((_, _, now) -> workbench.reopen(now.options()));
        addCommands();
        opened();
        workbench.begin(seen.coarse());
        workbench.go();
    }

    private void sayNotKept(Throwable why) {
        editor.message().show(Texts.of("The last edits could not be kept for the case of a crash: {0}", Sentence.of(why)));
    }

    private void addCommands() {
        commands.setAction(Command.GO, editor::go);
        commands.setAction(Command.UPDATE_REFLECTIONS, workbench::updateReflections);
        commands.setAction(Command.VERIFY, workbench::verify);
        commands.setAction(Command.CANCEL, this::cancel);
        commands.setAction(Command.UNDO, workbench::undo);
        commands.setAction(Command.REDO, workbench::redo);
        LightActions.addTo(editor, workbench, commands);
        NodeActions.addTo(editor, commands);
        ShotActions.addTo(editor, keyChoice, arrangement, commands);
        LookThrough.addTo(commands, editor, previewLook.cameraProperty());
        commands.setSwitch(Command.LIVE, editor.liveProperty());
        commands.setSwitch(Command.HIDE_PANELS, arrangement.panelsHiddenProperty());
        commands.setSwitch(Command.TIMELINE, arrangement.timelineShownProperty());
        commands.setSwitch(Command.FILM_STRIP, arrangement.filmStripShownProperty(), () -> {
            var shown = arrangement.filmStripShownProperty();
            shown.set(!shown.get());
            arrangement.timelineShownProperty().set(arrangement.timelineShownProperty().get() || shown.get());
        });
        commands.setSwitch(Command.HIDE_GIZMOS, previewLook.gizmosHiddenProperty());
        commands.setSwitch(Command.GLOWING_TEXTURES, previewLook.glowingProperty());
    }

    /** Takes another document in place of the open one, and traces it. Unsaved edits are lost: ask before. */
    public void open(OpenDocument other) {
        editor.dropAnimation();
        workbench.open(other);
        picture.repaint();
        opened();
    }

    /** Takes what a crash left unsaved in place of the open document, and traces it. */
    public void recover(Recovery.Found found, OpenDocument recovered) {
        editor.dropAnimation();
        workbench.recover(found, recovered);
        picture.repaint();
        opened();
    }

    private void opened() {
        OpenDocument document = workbench.document();
        previewLook.cameraProperty().set(PreviewCamera.of(document.scene()));
        arrangement.timelineShownProperty().set(document.moment().isPresent());
        document.scene().lights().stream().findFirst().ifPresent(l -> document.selectLight(l.name()));
        refresh();
    }

    /** Stops what runs, and waits no longer for what is read. */
    private void cancel() {
        if (fileWork.giveUp()) {
            // How far it was.
            editor.message().clear();
        }
        workbench.cancel();
    }

    private void refresh() {
        picture.refresh();
        editor.refresh();
    }

    private void progressed() {
        picture.progressed();
    }

    /** The open document's scene, its selection, and the edits of both. */
    public SceneEditor editor() {
        return editor;
    }

    /** The traced picture, and how far the next one is. */
    public TracedPicture picture() {
        return picture;
    }

    /** What of the traced picture is shown. */
    public PictureLook look() {
        return look;
    }

    /** Which part of the traced picture the artist points at. */
    public PicturePart part() {
        return part;
    }

    /** How the preview looks, and from where. */
    public PreviewLook previewLook() {
        return previewLook;
    }

    /** What the commands do, their keys, and which of them have something to do. */
    public Commands commands() {
        return commands;
    }

    /** What the commands act on. */
    public Workbench workbench() {
        return workbench;
    }

    public ObjectProperty<Precision> precisionProperty() {
        return precision;
    }

    /** Which material is edited. */
    public MaterialChoice materials() {
        return materials;
    }

    /** Which keys of the shot are chosen. */
    public KeyChoice keyChoice() {
        return keyChoice;
    }

    /** What the last updates of the picture did. */
    public UpdateLog updates() {
        return updates;
    }

    /** Reads and writes files beside the window's thread. */
    public FileThread files() {
        return files;
    }

    /** The file that is read or written, which may be given up. */
    public FileWork fileWork() {
        return fileWork;
    }

    /** Brings files from elsewhere beside the scene. */
    public FileBringer bringer() {
        return bringer;
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

    /** Stops the threads; nothing is saved. */
    @Override
    public void close() {
        workbench.close();
    }
}
