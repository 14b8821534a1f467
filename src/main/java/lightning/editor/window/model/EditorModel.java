package lightning.editor.window.model;

import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.base.text.Messages;
import lightning.editor.document.Command;
import lightning.editor.document.FileThread;
import lightning.editor.document.OpenDocument;
import lightning.editor.document.PreviewCamera;
import lightning.editor.document.RecoveryFolder;
import lightning.editor.document.Workbench;
import lightning.render.image.ViewTransform;

/**
 * Makes the objects that a window's panes work on, connects them, and opens documents in them. Panes take those that they need. All of them
 * belong to the window's thread, and none of their methods waits.
 */
public final class EditorModel implements AutoCloseable {
    private final FileThread files;
    private final FileActivity fileActivity = new FileActivity(this::refresh);
    private final KeySelection keySelection = new KeySelection(this::refresh);
    private final WindowLayout layout = new WindowLayout();
    private final RenderMachines renderMachines = new RenderMachines();
    private final PreviewSettings previewSettings = new PreviewSettings();
    private final PicturePointer picturePointer = new PicturePointer();
    private final ObjectProperty<AccuracyMode> accuracyMode = new SimpleObjectProperty<>(AccuracyMode.EXACT);
    private final ObjectProperty<UiLanguage> language = new SimpleObjectProperty<>(UiLanguage.SYSTEM);
    private final Workbench workbench;
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final CommandRegistry commands;
    private final PictureDisplay pictureDisplay;
    private final MaterialSelection materials;
    private final FileImporter fileImporter;
    private final UpdateLog updates;

    /**
     * Takes a document and starts to trace it.
     *
     * @param recovery keeps unsaved edits for the case of a crash
     * @param files    reads and writes beside the window's thread
     */
    public EditorModel(OpenDocument document, RecoveryFolder recovery, FileThread files) {
        this(document, StartupPreview.none(ViewTransform.DEFAULT), recovery, files);
    }

    /**
     * The same where the scene is looked at already.
     *
     * @param preview of the document's scene
     */
    public EditorModel(OpenDocument document, StartupPreview preview, RecoveryFolder recovery, FileThread files) {
        this.files = files;
        workbench =
                new Workbench(document, accuracyMode.get().options(), recovery, files, this::refresh, this::progressed, preview.raster(),
                        failure -> files.windowExecutor().execute(() -> reportAutosaveFailure(failure)));
        editor = new SceneEditor(workbench, previewSettings.cameraProperty(), fileActivity, keySelection);
        picture = new TracedPicture(workbench, preview.raster());
        updates = new UpdateLog(picture.renderStateProperty());
        commands = new CommandRegistry(editor.editorStateProperty(), editor.message());
        pictureDisplay = new PictureDisplay(editor, workbench, commands);
        materials = new MaterialSelection(editor);
        fileImporter = new FileImporter(editor, files);
        accuracyMode.addListener((_, _, mode) -> workbench.changeOptions(mode.options()));
        addCommands();
        documentOpened();
        workbench.setStartupPreview(preview.coarse());
        workbench.go();
    }

    private void reportAutosaveFailure(Throwable failure) {
        editor.message().show(Messages.tr("Autosave failed: {0}", ErrorMessage.of(failure)));
    }

    private void addCommands() {
        commands.setAction(Command.GO, editor::go);
        commands.setAction(Command.UPDATE_REFLECTIONS, workbench::updateReflections);
        commands.setAction(Command.VERIFY, workbench::verify);
        commands.setAction(Command.CANCEL, this::cancel);
        commands.setAction(Command.UNDO, workbench::undo);
        commands.setAction(Command.REDO, workbench::redo);
        LightActions.register(editor, workbench, commands);
        NodeActions.register(editor, commands);
        ShotActions.register(editor, keySelection, layout, commands);
        LightCameraToggle.register(commands, editor, previewSettings.cameraProperty());
        commands.setToggle(Command.LIVE, editor.liveProperty());
        commands.setToggle(Command.HIDE_PANELS, layout.panelsHiddenProperty());
        commands.setToggle(Command.TIMELINE, layout.timelineShownProperty());
        commands.setToggle(Command.FILM_STRIP, layout.filmStripShownProperty(), () -> {
            var shown = layout.filmStripShownProperty();
            shown.set(!shown.get());
            layout.timelineShownProperty().set(layout.timelineShownProperty().get() || shown.get());
        });
        commands.setToggle(Command.HIDE_GIZMOS, previewSettings.gizmosHiddenProperty());
        commands.setToggle(Command.GLOWING_TEXTURES, previewSettings.glowingTexturesProperty());
    }

    /** Takes another document in place of the open one, and traces it. Unsaved edits are lost: ask before. */
    public void open(OpenDocument other) {
        editor.dropAnimation();
        workbench.open(other);
        picture.repaint();
        documentOpened();
    }

    /** Takes what a crash left unsaved in place of the open document, and traces it. */
    public void recover(RecoveryFolder.RecoverableScene recoverable, OpenDocument recovered) {
        editor.dropAnimation();
        workbench.recover(recoverable, recovered);
        picture.repaint();
        documentOpened();
    }

    private void documentOpened() {
        OpenDocument document = workbench.document();
        previewSettings.cameraProperty().set(PreviewCamera.of(document.scene()));
        layout.timelineShownProperty().set(document.shotFrame().isPresent());
        document.scene().lights().stream().findFirst().ifPresent(l -> document.selectLight(l.name()));
        refresh();
    }

    /** Stops what runs, and waits no longer for what is read. */
    private void cancel() {
        if (fileActivity.cancel()) {
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
        picture.update();
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
    public PictureDisplay pictureDisplay() {
        return pictureDisplay;
    }

    /** Which part of the traced picture the artist points at. */
    public PicturePointer picturePointer() {
        return picturePointer;
    }

    /** How the preview looks, and from where. */
    public PreviewSettings previewSettings() {
        return previewSettings;
    }

    /** What the commands do, their keys, and which of them have something to do. */
    public CommandRegistry commands() {
        return commands;
    }

    /** What the commands act on. */
    public Workbench workbench() {
        return workbench;
    }

    public ObjectProperty<AccuracyMode> accuracyModeProperty() {
        return accuracyMode;
    }

    /** Which material is edited. */
    public MaterialSelection materials() {
        return materials;
    }

    /** Which keys of the shot are chosen. */
    public KeySelection keySelection() {
        return keySelection;
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
    public FileActivity fileActivity() {
        return fileActivity;
    }

    /** Brings files from elsewhere beside the scene. */
    public FileImporter fileImporter() {
        return fileImporter;
    }

    /** How the window's room is shared. */
    public WindowLayout layout() {
        return layout;
    }

    /** Which other machines hold frames, where the artist wants that. */
    public RenderMachines renderMachines() {
        return renderMachines;
    }

    /** What the editor speaks from its next start on; titles and labels that stand on the screen stay as they are. */
    public ObjectProperty<UiLanguage> languageProperty() {
        return language;
    }

    /** Stops the threads; nothing is saved. */
    @Override
    public void close() {
        workbench.close();
    }
}
