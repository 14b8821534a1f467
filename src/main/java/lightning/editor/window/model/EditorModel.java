package lightning.editor.window.model;

import java.util.Optional;
import java.util.function.Consumer;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ObjectProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.beans.property.SimpleObjectProperty;
import lightning.base.text.Messages;
import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.PictureArea;
import lightning.document.RecoveryFolder;
import lightning.document.loop.KeptPictures;
import lightning.document.manipulation.PreviewCamera;
import lightning.editor.Command;
import lightning.editor.Workbench;
import lightning.render.image.ViewTransform;

/**
 * Model of an editor window: creates and connects the objects that the panes share, and opens documents in them.
 *
 * <p>All objects belong to the window's thread. No method blocks.
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
    private final BooleanProperty keepsPictures;
    private final Workbench workbench;
    private final SceneEditor editor;
    private final TracedPicture picture;
    private final CommandRegistry commands;
    private final ViewActions viewActions;
    private final PictureDisplay pictureDisplay;
    private final MaterialSelection materials;
    private final FileImporter fileImporter;
    private final UpdateLog updates;
    private Consumer<String> browser = _ -> {};

    /**
     * Opens a document and starts tracing it.
     *
     * @param recovery  stores unsaved edits in case of a crash
     * @param files  reads and writes files off the window's thread
     */
    public EditorModel(OpenDocument document, RecoveryFolder recovery, FileThread files) {
        this(document, Optional.empty(), StartupPreview.none(ViewTransform.DEFAULT), recovery, files, KeptPictures.none());
    }

    /**
     * Opens a document that a startup preview already shows.
     *
     * @param area     area for which the first picture is traced; empty for the scene's own size
     * @param preview  preview of the document's scene
     * @param kept     pictures of earlier processes
     */
    public EditorModel(OpenDocument document, Optional<PictureArea> area, StartupPreview preview, RecoveryFolder recovery, FileThread files,
            KeptPictures kept) {
        this.files = files;
        workbench =
                new Workbench(document, accuracyMode.get().options(), recovery, files, this::refresh, this::progressed, preview.raster(),
                        failure -> files.windowExecutor().execute(() -> reportAutosaveFailure(failure)), kept);
        editor = new SceneEditor(workbench, previewSettings.cameraProperty(), fileActivity, keySelection);
        picture = new TracedPicture(workbench, preview.raster());
        editor.sceneProperty().subscribe(scene -> {
            if (scene != null) {
                picture.followScene(scene);
            }
        });
        viewActions = new ViewActions(editor, picture);
        updates = new UpdateLog(picture.renderStateProperty());
        commands = new CommandRegistry(editor.editorStateProperty(), editor.message());
        pictureDisplay = new PictureDisplay(editor, workbench, commands);
        materials = new MaterialSelection(editor);
        fileImporter = new FileImporter(editor, files);
        keepsPictures = new SimpleBooleanProperty(kept.isEnabled());
        keepsPictures.addListener((_, _, keeps) -> files.runConcurrently(() -> {
            kept.setEnabled(keeps);
            return keeps;
        }, _ -> {}, failure -> editor.message().show(ErrorMessage.of(failure))));
        accuracyMode.addListener((_, _, mode) -> workbench.changeOptions(mode.options()));
        addCommands();
        documentOpened();
        workbench.setStartupPreview(preview.coarse(), preview.menusShown());
        workbench.setArea(area);
        workbench.go();
    }

    /** Sets what opens an address in the system's browser. Until then nothing does. */
    public void setBrowser(Consumer<String> opener) {
        browser = opener;
    }

    /** Opens an address in the system's browser. */
    public void browse(String address) {
        browser.accept(address);
    }

    private void reportAutosaveFailure(Throwable failure) {
        if (workbench.document().isDirty()) {
            editor.message().show(Messages.tr("Autosave failed: {0}", ErrorMessage.of(failure)));
        }
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
        commands.setToggle(Command.KEEP_PICTURES, keepsPictures);
        commands.setToggle(Command.HIDE_PANELS, layout.panelsHiddenProperty());
        layout.register(commands);
        commands.setToggle(Command.TIMELINE, layout.timelineShownProperty());
        commands.setToggle(Command.FILM_STRIP, layout.filmStripShownProperty(), () -> {
            var shown = layout.filmStripShownProperty();
            shown.set(!shown.get());
            layout.timelineShownProperty().set(layout.timelineShownProperty().get() || shown.get());
        });
        commands.setToggle(Command.HIDE_GIZMOS, previewSettings.gizmosHiddenProperty());
        commands.setToggle(Command.PREVIEW_SHADOWS, previewSettings.shadowsProperty());
        commands.setToggle(Command.GLOWING_TEXTURES, previewSettings.glowingTexturesProperty());
    }

    /** Replaces the open document and traces the new one. Discards unsaved edits; the caller confirms first. */
    public void open(OpenDocument other) {
        startFile(other);
        workbench.open(other);
        picture.repaint();
        documentOpened();
        updates.clear();
    }

    /** Replaces the open document with edits recovered after a crash, and traces them. */
    public void recover(RecoveryFolder.RecoverableScene recoverable, OpenDocument recovered) {
        startFile(recovered);
        workbench.recover(recoverable, recovered, editor::reloadLooks);
        picture.repaint();
        documentOpened();
        updates.clear();
    }

    /** Resets what applies to the open file only, unless it is opened again. */
    private void startFile(OpenDocument other) {
        if (!other.file().equals(workbench.document().file())) {
            accuracyMode.set(accuracyMode.get().forOtherFile());
        }
    }

    private void documentOpened() {
        OpenDocument document = workbench.document();
        previewSettings.cameraProperty().set(PreviewCamera.of(document.scene()));
        layout.timelineShownProperty().set(document.shotFrame().isPresent());
        document.scene().lights().stream().findFirst().ifPresentOrElse(light -> workbench.selectLight(light.name()), this::refresh);
    }

    /** Cancels the running render and the pending file read. */
    private void cancel() {
        if (fileActivity.cancel()) {
            // Clears the progress message.
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

    /** Returns the editor of the open document's scene and its selection. */
    public SceneEditor editor() {
        return editor;
    }

    /** Returns the traced picture and its render progress. */
    public TracedPicture picture() {
        return picture;
    }

    /** Returns the edits of the scene's view transform. */
    public ViewActions viewActions() {
        return viewActions;
    }

    /** Returns the display settings of the traced picture. */
    public PictureDisplay pictureDisplay() {
        return pictureDisplay;
    }

    /** Returns the pointer position and region requests in the traced picture. */
    public PicturePointer picturePointer() {
        return picturePointer;
    }

    /** Returns the settings and the camera of the preview. */
    public PreviewSettings previewSettings() {
        return previewSettings;
    }

    /** Returns the registry of commands, with their actions, keys and enablement. */
    public CommandRegistry commands() {
        return commands;
    }

    /** Returns the workbench that the commands act on. */
    public Workbench workbench() {
        return workbench;
    }

    public ObjectProperty<AccuracyMode> accuracyModeProperty() {
        return accuracyMode;
    }

    /** Returns the material being edited. */
    public MaterialSelection materials() {
        return materials;
    }

    /** Returns the selected keyframes of the shot. */
    public KeySelection keySelection() {
        return keySelection;
    }

    /** Returns the log of recent updates. */
    public UpdateLog updates() {
        return updates;
    }

    /** Returns the thread that reads and writes files. */
    public FileThread files() {
        return files;
    }

    /** Returns the file being read or written, which can be canceled. */
    public FileActivity fileActivity() {
        return fileActivity;
    }

    /** Returns the importer that copies files next to the scene. */
    public FileImporter fileImporter() {
        return fileImporter;
    }

    /** Returns the layout of the window. */
    public WindowLayout layout() {
        return layout;
    }

    /** Returns the machines used for rendering frames. */
    public RenderMachines renderMachines() {
        return renderMachines;
    }

    /** Interface language, effective after a restart. */
    public ObjectProperty<UiLanguage> languageProperty() {
        return language;
    }

    /** Stops the threads without saving. */
    @Override
    public void close() {
        workbench.close();
    }
}
