package lightning.editor.document;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import java.util.function.LongFunction;
import java.util.function.Supplier;
import lightning.editor.loop.CoarsePicture;
import lightning.editor.loop.DisplayMode;
import lightning.editor.loop.Frame;
import lightning.editor.loop.RenderFeed;
import lightning.editor.loop.RenderListener;
import lightning.editor.loop.RenderLoop;
import lightning.editor.loop.RenderState;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.RenderOptions;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.VisibleState;
import lightning.scene.shot.AnimatedScene;

/**
 * Everything that an editor's window works on: the open document, its picture, and what renders and keeps it. All panes
 * share one, change the document through it, and hear of every change.
 *
 * <p>Belongs to the window's thread; what the render loop tells, and what comes of files, is brought there.
 */
public final class Workbench implements AutoCloseable {
    private final Runnable changeListener;
    private final RenderLoop loop;
    private final FileThread files;
    private final ArrayDeque<Runnable> pendingSaves = new ArrayDeque<>();
    private final Autosave autosave;
    private OpenDocument document;
    private final RenderFeed feed;
    private final Runnable progressListener;
    /** The picture and how far it is, as heard last. */
    private RenderState renderState = RenderState.NONE;
    private long openCount;
    private Optional<Scene> previousScene = Optional.empty();
    private Optional<Scene> sceneInProgress = Optional.empty();
    private Optional<Light> copiedLight = Optional.empty();
    private boolean isVerifying;
    private boolean isLive;
    private boolean isAnimating;
    private boolean motionRecorded;

    /**
     * @param document what is open first; it is rendered by {@link #go()}
     * @param files      reads and writes the document; its window's thread is the one that the workbench belongs to
     * @param changeListener    called there after every change of what the workbench tells
     * @param progressListener called there where nothing but {@link #renderState} is another
     * @param canvas     hears the render loop on its own threads, before the workbench does
     * @param failureListener    hears, on the autosave thread, why edits could not be kept
     */
    public Workbench(OpenDocument document, RenderOptions options, RecoveryFolder recovery, FileThread files, Runnable changeListener,
            Runnable progressListener, RenderListener canvas, Consumer<Throwable> failureListener) {
        this.document = document;
        this.changeListener = changeListener;
        this.progressListener = progressListener;
        this.files = files;
        autosave = new Autosave(recovery, Autosave.DEFAULT_DELAY, failureListener);
        feed = new RenderFeed(files.windowExecutor(), canvas, this::renderStateChanged);
        loop = new RenderLoop(options, feed);
    }

    /** Before the document is rendered: what is being looked at of it is not traced again. */
    public void setStartupPreview(Future<Optional<CoarsePicture>> preview) {
        loop.setStartupPreview(preview);
    }

    public OpenDocument document() {
        return document;
    }

    /** The picture, and how far the next one is. */
    public RenderState renderState() {
        return renderState;
    }

    /** The picture rendered last; its film may be written over by now. */
    public Optional<Frame> frame() {
        return Optional.ofNullable(renderState.frame());
    }

    /** What is kept of the picture: see {@link RenderLoop#cache}. On any thread. */
    public Optional<PixelCache> cache() {
        return loop.cache();
    }

    private void renderStateChanged() {
        Frame before = renderState.frame();
        boolean wasRendering = sceneInProgress.isPresent();
        boolean wasVerifying = isVerifying;
        refresh();
        boolean isSame = renderState.frame() == before && sceneInProgress.isPresent() == wasRendering && isVerifying == wasVerifying;
        (isSame ? progressListener : changeListener).run();
    }

    /** Looks at what the loop does, and then at what it has told: what it finished before the first is in the second. */
    private void refresh() {
        boolean isBusy = loop.isBusy();
        isVerifying = loop.isVerifying();
        sceneInProgress = isBusy ? sceneInProgress : Optional.empty();
        RenderState newState = feed.state();
        if (newState.frame() != null && newState.frame() != renderState.frame()) {
            Optional<Scene> shownScene = frame().map(Frame::scene);
            previousScene = shownScene.filter(s -> !VisibleState.isSame(s, newState.frame().scene())).or(() -> previousScene);
        }
        renderState = newState;
    }

    /** The edit made last; empty where there is none, or it made another picture of it. */
    public Optional<LastEdit> lastEdit() {
        return LastEdit.of(document.scene(), frame().map(Frame::scene), previousScene);
    }

    /** What decides which commands are enabled. */
    public EditorState editorState() {
        return EditorState.of(document, frame()).withSceneInProgress(sceneInProgress).withVerifying(isVerifying)
                .withCopiedLight(copiedLight)
                .withAnimating(isAnimating).withMotionRecorded(motionRecorded);
    }

    /** Puts another document in place of the open one and renders it. The open one's unsaved edits are lost. */
    public void open(OpenDocument other) {
        openCount++;
        feed.open(openCount);
        loop.open(other.scene(), openCount);
        sceneInProgress = Optional.of(other.scene());
        autosave.discard();
        document = other;
        renderState = RenderState.NONE;
        previousScene = Optional.empty();
        isAnimating = false;
        motionRecorded = false;
        autosave.documentChanged(document);
        changeListener.run();
    }

    /** Opens what a crash left unsaved: see {@link OpenDocument#recover}. Until it is saved it can be recovered again. */
    public void recover(RecoveryFolder.RecoverableScene recoverable, OpenDocument recovered) {
        open(recovered);
        autosave.adopt(recoverable);
    }

    /** Makes an edit unless it was refused; returns the reason if it was. Live, the edit is rendered at once. */
    public Optional<String> edit(EditOutcome change) {
        return edit(change, null);
    }

    /** The same as part of a gesture: see {@link EditHistory#edit(Scene, Object)}. */
    public Optional<String> edit(EditOutcome change, Object gesture) {
        Optional<String> refusal = document.apply(change, gesture);
        if (refusal.isEmpty()) {
            afterEdit();
        }
        return refusal;
    }

    /** The same as a step of its own, and selects something then: who shows the document hears of both at once. */
    public Optional<String> editAndSelect(EditOutcome change, Selection selection) {
        Optional<String> refusal = document.apply(change, null);
        if (refusal.isEmpty()) {
            document.select(selection);
            afterEdit();
        }
        return refusal;
    }

    /** Makes an edit of the scene with its shot: see {@link OpenDocument#applyToShot}. */
    public Optional<String> editShot(Supplier<AnimatedScene> edit, Object gesture) {
        Scene before = document.scene();
        Optional<String> refusal = document.applyToShot(edit, gesture);
        if (refusal.isEmpty()) {
            boolean isSameScene = document.scene().equals(before);
            autosave.documentChanged(document);
            if (!isSameScene) {
                renderIfLive();
            }
            changeListener.run();
        }
        return refusal;
    }

    /** Shows a frame of the shot, in the picture too; returns why it cannot be shown. */
    public Optional<String> showFrame(int frame) {
        document.showFrame(frame);
        go();
        return document.frameProblem();
    }

    public void undo() {
        document.history().undo();
        afterEdit();
    }

    public void redo() {
        document.history().redo();
        afterEdit();
    }

    /** Undoes or does again until so many of the document's steps are done: see {@link EditHistory#goTo}. */
    public void goTo(int position) {
        document.history().goTo(position);
        afterEdit();
    }

    /** The same of the selected light alone; returns the reason if it could not: see {@link EditHistory#goToLightStep}. */
    public Optional<String> goToLightStep(int position) {
        return editSelectedLight(id -> document.history().goToLightStep(id, position));
    }

    /** Takes back the last edit of the selected light alone; returns the reason if it could not. */
    public Optional<String> undoLight() {
        return editSelectedLight(document.history()::undoLight);
    }

    /** Does again what was undone last of the selected light; returns the reason if it could not. */
    public Optional<String> redoLight() {
        return editSelectedLight(document.history()::redoLight);
    }

    private Optional<String> editSelectedLight(LongFunction<EditOutcome> step) {
        document.resolveSelection();
        long id = document.selectedLight().map(l -> document.history().id(l.name())).orElse(-1L);
        Optional<String> refusal = step.apply(id).refusal();
        afterEdit();
        return refusal;
    }

    public void select(Selection selection) {
        document.select(selection);
        changeListener.run();
    }

    /** Selects the light of that name; nothing if there is none. */
    public void selectLight(String name) {
        select(Selection.light(document.history(), name));
    }

    /** Keeps the selected light's settings for {@link #pasteSettings}. */
    public void copySettings() {
        copiedLight = document.selectedLight();
        changeListener.run();
    }

    /** Gives the selected light the settings copied last; returns the reason if it could not. */
    public Optional<String> pasteSettings() {
        Optional<Light> selected = document.selectedLight();
        return selected.isEmpty() || copiedLight.isEmpty() ? Command.PASTE_SETTINGS.disabledReason(editorState())
                : edit(LightEdits.pasteSettings(document.scene(), selected.get().name(), copiedLight.get()));
    }

    /**
     * Saves to a file, that of the document or another, after all saves asked for before: see {@link SaveRequest#write}.
     *
     * @param completion hears why the scene could not be written; nothing where it was
     */
    public void saveAs(Path file, Set<OverwriteConfirmation> allowed, Consumer<Optional<Throwable>> completion) {
        OpenDocument savedDocument = document;
        pendingSaves.add(() -> write(savedDocument, file, allowed, completion));
        if (pendingSaves.size() == 1) {
            pendingSaves.element().run();
        }
    }

    private void write(OpenDocument savedDocument, Path file, Set<OverwriteConfirmation> allowed,
            Consumer<Optional<Throwable>> completion) {
        files.runInOrder(savedDocument.prepareSave(file, allowed)::write, newSaved -> {
            savedDocument.onSaved(newSaved);
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

    /** Whether a save is not written yet. */
    public boolean isSaving() {
        return !pendingSaves.isEmpty();
    }

    /** Takes what was seen of the document's file on disk. */
    public void setDiskStatus(DiskStatus status) {
        document.setDiskStatus(status);
        changeListener.run();
    }

    /** Stays with the open scene although its file was changed: see {@link OpenDocument#ignoreDiskChange}. */
    public void ignoreDiskChange() {
        document.ignoreDiskChange();
        contentChanged();
    }

    /**
     * Starts over with the file as it is on disk and renders it.
     *
     * @param completion hears why the file could not be read; nothing where it was. Not told where another document is open by then
     */
    public void reload(Consumer<Optional<Throwable>> completion) {
        OpenDocument reloadedDocument = document;
        files.runInOrder(() -> SavedScene.read(reloadedDocument.file()), newSaved -> {
            if (reloadedDocument == document) {
                reloadedDocument.onReloaded(newSaved);
                contentChanged();
                go();
                completion.accept(Optional.empty());
            }
        }, failure -> completion.accept(Optional.of(failure)));
    }

    private void contentChanged() {
        autosave.documentChanged(document);
        changeListener.run();
    }

    /** Renders the document's scene. */
    public void go() {
        show(document.scene());
    }

    /** Renders a scene that is not the document's, as an animation's frame. */
    public void show(Scene scene) {
        sceneInProgress = Optional.of(scene);
        loop.render(scene);
        changeListener.run();
    }

    public void updateReflections() {
        sceneInProgress = Optional.of(sceneInProgress.orElseGet(() -> frame().map(Frame::scene).orElse(document.scene())));
        loop.updateReflections();
        changeListener.run();
    }

    public void verify() {
        isVerifying = frame().isPresent();
        loop.verify();
        changeListener.run();
    }

    /** Stops what runs and forgets what waits. */
    public void cancel() {
        if (loop.cancel()) {
            feed.waitingRenderCanceled();
        }
        refresh();
        changeListener.run();
    }

    /** Another accuracy: what is known of the picture serves on. */
    public void changeOptions(RenderOptions options) {
        sceneInProgress = Optional.of(document.scene());
        loop.changeOptions(options, document.scene());
        changeListener.run();
    }

    /** Shows the picture in another way: see {@link RenderLoop#setDisplayMode}. */
    public void setDisplayMode(DisplayMode mode) {
        loop.setDisplayMode(mode);
    }

    /** See {@link RenderLoop#setView}. */
    public void setView(ViewTransform view) {
        loop.setView(view);
    }

    /** Whether every edit is rendered at once; off at first (paper §3.3). */
    public boolean isLive() {
        return isLive;
    }

    /** Switched on, renders what is pending. */
    public void setLive(boolean v) {
        isLive = v;
        renderIfLive();
        changeListener.run();
    }

    /** Whether an animation is open, which holds back the commands that change the document. */
    public void setAnimating(boolean v) {
        isAnimating = v;
        motionRecorded &= v;
        changeListener.run();
    }

    /** Whether the open animation has a way. */
    public void setMotionRecorded(boolean v) {
        motionRecorded = v;
        changeListener.run();
    }

    private void afterEdit() {
        document.clampFrame();
        autosave.documentChanged(document);
        renderIfLive();
        changeListener.run();
    }

    private void renderIfLive() {
        if (isLive && Command.GO.isEnabled(editorState())) {
            sceneInProgress = Optional.of(document.scene());
            loop.render(document.scene());
        }
    }

    /** Ends all threads. Edits that are not saved are lost: ask before. */
    @Override
    public void close() {
        loop.close();
        autosave.discard();
        autosave.close();
    }
}
