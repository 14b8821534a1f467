package lightning.editor;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import lightning.document.Autosave;
import lightning.document.DiskStatus;
import lightning.document.EditHistory;
import lightning.document.EditOutcome;
import lightning.document.FileThread;
import lightning.document.LightEdits;
import lightning.document.LooksFolder;
import lightning.document.OpenDocument;
import lightning.document.OverwriteConfirmation;
import lightning.document.PictureArea;
import lightning.document.RecoveryFolder;
import lightning.document.SaveRequest;
import lightning.document.SavedScene;
import lightning.document.Selection;
import lightning.document.loop.CoarsePicture;
import lightning.document.loop.DisplayMode;
import lightning.document.loop.Frame;
import lightning.document.loop.KeptPictures;
import lightning.document.loop.RenderFeed;
import lightning.document.loop.RenderListener;
import lightning.document.loop.RenderLoop;
import lightning.document.loop.RenderState;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.shot.AnimatedScene;
import org.jspecify.annotations.Nullable;

/**
 * Model of an editor window: the open document, its image, its renderer and its autosave. All panes share one, edit the document through
 * it, and listen to its changes.
 *
 * <p>Confined to the window's thread, to which it forwards events of the render loop and results of file access.
 */
public final class Workbench implements AutoCloseable {
    private final Runnable changeListener;
    private volatile RenderOptions renderOptions;
    /** Replaced as a whole by every change. */
    private EditorState state;
    private final RenderLoop loop;
    private final FileThread files;
    private final ArrayDeque<Runnable> pendingSaves = new ArrayDeque<>();
    private final Autosave autosave;
    private final RecoveryFolder recovery;
    private final RenderFeed feed;
    private final Runnable progressListener;
    private long openCount;

    /**
     * @param document         initial document; rendered by {@link #go()}
     * @param files            reads and writes the document; its window's thread owns the workbench
     * @param changeListener   called on that thread after every change of the workbench's state
     * @param progressListener called there if only {@link #renderState} changed
     * @param canvas           receives events of the render loop on its own threads, before the workbench
     * @param failureListener  receives, on the autosave thread, failures to save
     * @param kept             pictures of earlier processes
     */
    public Workbench(OpenDocument document, RenderOptions options, RecoveryFolder recovery, FileThread files, Runnable changeListener,
            Runnable progressListener, RenderListener canvas, Consumer<Throwable> failureListener, KeptPictures kept) {
        state = EditorState.of(document);
        this.changeListener = changeListener;
        this.progressListener = progressListener;
        this.files = files;
        this.recovery = recovery;
        autosave = new Autosave(recovery, Autosave.DEFAULT_DELAY, failureListener);
        feed = new RenderFeed(files.windowExecutor(), canvas, this::renderStateChanged);
        renderOptions = options;
        loop = new RenderLoop(options, feed, kept);
    }

    /** Sets a running startup preview before the document is rendered, as {@link RenderLoop#setStartupPreview}. */
    public void setStartupPreview(Future<Optional<CoarsePicture>> preview, Future<?> menusShown) {
        loop.setStartupPreview(preview, menusShown);
    }

    /** Returns the options of the next render. Callable on any thread. */
    public RenderOptions options() {
        return renderOptions;
    }

    public OpenDocument document() {
        return state.document();
    }

    /** Returns the folder of unsaved edits. */
    public RecoveryFolder recovery() {
        return recovery;
    }

    /** Returns the image and the progress of the next one. */
    public RenderState renderState() {
        return state.render();
    }

    /** Returns the last rendered image; its film may have been overwritten. */
    public Optional<Frame> frame() {
        return state.frame();
    }

    /** Returns the cache of the image: see {@link RenderLoop#cache}. Callable on any thread. */
    public Optional<PixelCache> cache() {
        return loop.cache();
    }

    /** Replaces the state and notifies the window. */
    private void show(EditorState next) {
        state = next;
        changeListener.run();
    }

    /** Notifies the window of other content of the document. */
    private void showDocument() {
        show(state.showing(document()));
    }

    private void renderStateChanged() {
        EditorState before = state;
        state = refreshed();
        (state.withRender(before.render()).equals(before) && state.render().frame() == before.render().frame() ? progressListener
                : changeListener).run();
    }

    /** Reads the loop's activity before its reported results, so that a job that just finished is in the results. */
    private EditorState refreshed() {
        boolean isBusy = loop.isBusy();
        boolean isVerifying = loop.isVerifying();
        return state.withVerifying(isVerifying).withSceneInProgress(isBusy ? state.sceneInProgress() : Optional.empty())
                .withImage(feed.state());
    }

    /** Returns the last edit; empty if there is none, or if it changed the view or the image size. */
    public Optional<LastEdit> lastEdit() {
        return LastEdit.of(state.traced(), state.renderedScene(), state.previousScene());
    }

    /** Returns the state that the window shows. */
    public EditorState editorState() {
        return state;
    }

    /** Opens another document and renders it. Unsaved edits of the current one are lost. */
    public void open(OpenDocument other) {
        openCount++;
        feed.open(openCount);
        EditorState opened = state.showing(other);
        loop.open(opened.traced(), openCount);
        autosave.discard();
        autosave.documentChanged(other);
        show(opened.withSceneInProgress(Optional.of(opened.traced())).withRender(RenderState.NONE)
                .withPreviousScene(Optional.empty()));
    }

    /**
     * Opens the unsaved scene of a crashed process: see {@link OpenDocument#recover}. It stays recoverable until it is saved. If the same
     * file is open already, its picture is updated as by an edit.
     *
     * @param onLooks called when the looks of a scene without a file are recovered, too
     */
    public void recover(RecoveryFolder.RecoverableScene recoverable, OpenDocument recovered, Runnable onLooks) {
        if (recovered.file().equals(document().file()) && recovered.scene().hasSameView(document().scene())) {
            autosave.discard();
            autosave.documentChanged(recovered);
            show(rendered(state.showing(recovered)));
        } else {
            open(recovered);
        }
        autosave.adopt(recoverable, () -> files.windowExecutor().execute(onLooks));
    }

    /** Returns the folder for the looks of the open document if it has no file of its own; empty if it has one. */
    public Optional<Path> untitledLooks() {
        return document().isUntitled() ? Optional.of(recovery.looksFolder(document().file())) : Optional.empty();
    }

    /** Keeps the looks of a document without a file recoverable, and asks to save it before it is closed. */
    public void looksChanged() {
        document().setUnsavedLooks();
        contentChanged();
    }

    /** Applies an edit unless it was refused; returns the reason if it was. Renders it immediately in live mode. */
    public Optional<String> edit(EditOutcome change) {
        return edit(change, null);
    }

    /** Applies an edit as part of a gesture: see {@link EditHistory#edit(Scene, Object)}. */
    public Optional<String> edit(EditOutcome change, @Nullable Object gesture) {
        return edit(change, gesture, state.live());
    }

    /** Applies an edit as above, and renders it also if live mode is off, unless there is no picture yet. */
    public Optional<String> editAndRender(EditOutcome change, @Nullable Object gesture) {
        return edit(change, gesture, state.live() || frame().isPresent());
    }

    private Optional<String> edit(EditOutcome change, @Nullable Object gesture, boolean renders) {
        Optional<String> refusal = document().apply(change, gesture);
        if (refusal.isEmpty()) {
            afterEdit(renders);
        }
        return refusal;
    }

    /** Applies an edit as a separate step and changes the selection, in one notification. */
    public Optional<String> editAndSelect(EditOutcome change, Selection selection) {
        Optional<String> refusal = document().apply(change, null);
        if (refusal.isEmpty()) {
            document().select(selection);
            afterEdit();
        }
        return refusal;
    }

    /** Edits the scene with its shot: see {@link OpenDocument#applyToShot}. */
    public Optional<String> editShot(Supplier<AnimatedScene> edit, @Nullable Object gesture) {
        Scene before = document().scene();
        Optional<String> refusal = document().applyToShot(edit, gesture);
        if (refusal.isEmpty()) {
            boolean isSameScene = document().scene().equals(before);
            autosave.documentChanged(document());
            show(rendering(!isSameScene && state.live()));
        }
        return refusal;
    }

    /** Shows a frame of the shot, in the image too; returns the reason if it cannot be shown. */
    public Optional<String> showFrame(int frame) {
        document().showFrame(frame);
        go();
        return document().frameProblem();
    }

    public void undo() {
        document().history().undo();
        afterEdit();
    }

    public void redo() {
        document().history().redo();
        afterEdit();
    }

    /** Undoes or redoes until that many document steps are done: see {@link EditHistory#goTo}. */
    public void goTo(int position) {
        document().history().goTo(position);
        afterEdit();
    }

    /** Undoes or redoes steps of the selected light; returns the reason if refused: see {@link EditHistory#goToLightStep}. */
    public Optional<String> goToLightStep(int position) {
        return editSelectedLight(id -> document().history().goToLightStep(id, position));
    }

    /** Undoes the last edit of the selected light; returns the reason if refused. */
    public Optional<String> undoLight() {
        return editSelectedLight(document().history()::undoLight);
    }

    /** Redoes the edit undone last of the selected light; returns the reason if refused. */
    public Optional<String> redoLight() {
        return editSelectedLight(document().history()::redoLight);
    }

    private Optional<String> editSelectedLight(LongFunction<EditOutcome> step) {
        document().resolveSelection();
        long id = document().selectedLight().map(l -> document().history().id(l.name())).orElse(-1L);
        Optional<String> refusal = step.apply(id).refusal();
        afterEdit();
        return refusal;
    }

    public void select(Selection selection) {
        document().select(selection);
        showDocument();
    }

    /** Selects the light with that name; nothing if it does not exist. */
    public void selectLight(String name) {
        select(Selection.light(document().history(), name));
    }

    /** Copies the selected light's settings for {@link #pasteSettings}. */
    public void copySettings() {
        show(state.withCopiedLight(document().selectedLight()));
    }

    /** Applies the copied settings to the selected light; returns the reason if refused. */
    public Optional<String> pasteSettings() {
        Optional<Light> selected = document().selectedLight();
        return selected.isEmpty() || state.copiedLight().isEmpty() ? Command.PASTE_SETTINGS.disabledReason(editorState())
                : edit(LightEdits.pasteSettings(document().scene(), selected.get().name(), state.copiedLight().get()));
    }

    /**
     * Saves to the document's file or another, after all earlier saves: see {@link SaveRequest#write}.
     *
     * @param completion receives the failure; empty on success
     */
    public void saveAs(Path file, Set<OverwriteConfirmation> allowed, Consumer<Optional<Throwable>> completion) {
        OpenDocument savedDocument = document();
        pendingSaves.add(() -> write(savedDocument, file, allowed, completion));
        if (pendingSaves.size() == 1) {
            pendingSaves.element().run();
        }
    }

    private void write(OpenDocument savedDocument, Path file, Set<OverwriteConfirmation> allowed,
            Consumer<Optional<Throwable>> completion) {
        SaveRequest request = savedDocument.prepareSave(file, allowed);
        Path looks = recovery.looksFolder(savedDocument.file());
        files.runInOrder(() -> {
            SavedScene newSaved = request.write();
            if (request.untitled()) {
                LooksFolder.move(looks, file);
            }
            return newSaved;
        }, newSaved -> {
            savedDocument.onSaved(newSaved);
            if (savedDocument == document()) {
                loop.keepPicture();
            }
            contentChanged();
            saveNext();
            completion.accept(Optional.empty());
        }, failure -> {
            saveNext();
            completion.accept(Optional.of(failure));
        });
    }

    private void saveNext() {
        pendingSaves.remove();
        if (!pendingSaves.isEmpty()) {
            pendingSaves.element().run();
        }
    }

    /** Returns whether a save is pending. */
    public boolean isSaving() {
        return !pendingSaves.isEmpty();
    }

    /** Sets the observed state of the document's file on disk. */
    public void setDiskStatus(DiskStatus status) {
        document().setDiskStatus(status);
        showDocument();
    }

    /** Keeps the open scene although its file was changed: see {@link OpenDocument#ignoreDiskChange}. */
    public void ignoreDiskChange() {
        document().ignoreDiskChange();
        contentChanged();
    }

    /**
     * Reloads the file from disk and renders it.
     *
     * @param completion receives the failure; empty on success. Not called if another document was opened meanwhile
     */
    public void reload(Consumer<Optional<Throwable>> completion) {
        OpenDocument reloadedDocument = document();
        files.runInOrder(reloadedDocument.readSaved(), newSaved -> {
            if (reloadedDocument == document()) {
                reloadedDocument.onReloaded(newSaved);
                contentChanged();
                go();
                completion.accept(Optional.empty());
            }
        }, failure -> completion.accept(Optional.of(failure)));
    }

    private void contentChanged() {
        autosave.documentChanged(document());
        showDocument();
    }

    /** Renders the document's scene. */
    public void go() {
        show(rendered(state.showing(document())));
    }

    public void updateReflections() {
        loop.updateReflections();
        show(state.withSceneInProgress(Optional.of(
                state.sceneInProgress().or(state::renderedScene).orElseGet(() -> state.traced()))));
    }

    public void verify() {
        loop.verify();
        show(state.withVerifying(frame().isPresent()));
    }

    /** Cancels running and pending renders. */
    public void cancel() {
        if (loop.cancel()) {
            feed.waitingRenderCanceled();
        }
        show(refreshed());
    }

    /** Changes the options and keeps the cache. */
    public void changeOptions(RenderOptions options) {
        renderOptions = options;
        loop.changeOptions(options, state.traced());
        show(state.withSceneInProgress(Optional.of(state.traced())));
    }

    /**
     * Changes the area for which the picture is traced, and traces it again if it shows the scene or will. The scene keeps its size.
     *
     * @param area empty for the scene's own size
     */
    public void setArea(Optional<PictureArea> area) {
        if (!area.equals(state.area())) {
            boolean isFollowed = state.live() || state.sceneInProgress().isPresent() || !state.hasPendingEdits();
            state = state.withArea(area);
            show(rendering(isFollowed));
        }
    }

    /** Changes the display mode: see {@link RenderLoop#setDisplayMode}. */
    public void setDisplayMode(DisplayMode mode) {
        loop.setDisplayMode(mode);
    }

    /** Sets the view transform: see {@link RenderLoop#setView}. */
    public void setView(ViewTransform view) {
        loop.setView(view);
    }

    /** Switches live mode; switching it on renders pending edits. */
    public void setLive(boolean v) {
        state = state.withLive(v);
        show(rendering(v));
    }

    private void afterEdit() {
        afterEdit(state.live());
    }

    private void afterEdit(boolean renders) {
        document().clampFrame();
        autosave.documentChanged(document());
        show(rendering(renders));
    }

    /** Renders the document's scene if that is wanted and the image does not show it; returns the state after that. */
    private EditorState rendering(boolean isWanted) {
        EditorState now = state.showing(document());
        return isWanted && Command.GO.isEnabled(now) ? rendered(now) : now;
    }

    /** Renders the document's scene; returns the state after that. */
    private EditorState rendered(EditorState now) {
        loop.render(now.traced());
        return now.withSceneInProgress(Optional.of(now.traced()));
    }

    /** Stops all threads. Unsaved edits are lost: ask before. */
    @Override
    public void close() {
        loop.close();
        autosave.discard();
        autosave.close();
    }
}
