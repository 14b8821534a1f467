package lightning.edit;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.LongFunction;
import lightning.edit.loop.Frame;
import lightning.edit.loop.Look;
import lightning.edit.loop.RenderListener;
import lightning.edit.loop.RenderLoop;
import lightning.image.ViewTransform;
import lightning.jen.JenException;
import lightning.relight.tile.Options;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.VisiblePart;

/**
 * Everything that an editor's window works on: the open document, its picture, and what renders and keeps it. All panes
 * share one, change the document through it, and hear of every change.
 *
 * <p>Belongs to one thread, that of {@code window}; what the render loop tells is brought there.
 */
public final class Workbench implements AutoCloseable {
    private final Executor window;
    private final Runnable changed;
    private final RenderLoop loop;
    private final Recovery recovery;
    private final Autosave autosave;
    private OpenDocument document;
    private Optional<Frame> frame = Optional.empty();
    private Optional<Scene> previous = Optional.empty();
    private Optional<Scene> inWork = Optional.empty();
    private Optional<Light> copied = Optional.empty();
    private boolean verifying;
    private boolean live;
    private boolean animating;

    /**
     * @param document what is open first; it is rendered by {@link #go()}
     * @param window   runs tasks, in their order, on the thread that the workbench belongs to
     * @param changed  called there after every change of what the workbench tells
     * @param canvas   hears the render loop on its own threads, before the workbench does
     * @param trouble  hears, on the autosave thread, why edits could not be kept
     */
    public Workbench(OpenDocument document, Options options, Recovery recovery, Executor window, Runnable changed,
            RenderListener canvas, Consumer<Throwable> trouble) {
        this.document = document;
        this.window = window;
        this.changed = changed;
        this.recovery = recovery;
        autosave = new Autosave(recovery, Autosave.DEFAULT_DELAY, trouble);
        loop = new RenderLoop(options, new WorkbenchEar(canvas, this::tell, this::take, this::nothingShown, this::refresh));
    }

    public OpenDocument document() {
        return document;
    }

    /** The document's scene as it is now. */
    public Scene scene() {
        return document.scene();
    }

    /** The picture rendered last; its film may be written over by now. */
    public Optional<Frame> frame() {
        return frame;
    }

    /** What the loop tells on its threads is heard on the window's. */
    private void tell(Runnable what) {
        window.execute(() -> {
            what.run();
            changed.run();
        });
    }

    private void take(Frame finished) {
        Optional<Scene> shown = frame.map(Frame::scene);
        previous = shown.filter(s -> !VisiblePart.same(s, finished.scene())).or(() -> previous);
        frame = Optional.of(finished);
    }

    private void nothingShown() {
        frame = Optional.empty();
        previous = Optional.empty();
    }

    /** The edit made last; empty where there is none, or it made another picture of it. */
    public Optional<LastEdit> lastEdit() {
        return LastEdit.of(scene(), frame.map(Frame::scene), previous);
    }

    /** What decides which commands are enabled. */
    public Situation situation() {
        return Situation.of(document, frame).withInWork(inWork).withVerifying(verifying).withCopied(copied)
                .withAnimating(animating);
    }

    /** Puts another document in place of the open one and renders it. The open one's unsaved edits are lost. */
    public void open(OpenDocument other) {
        loop.open(other.scene());
        inWork = Optional.of(other.scene());
        autosave.forget();
        document = other;
        nothingShown();
        animating = false;
        autosave.changed(document);
        changed.run();
    }

    /** Opens what a crash left unsaved: see {@link OpenDocument#recover}. Until it is saved it can be recovered again. */
    public void recover(Recovery.Found found) throws IOException, JenException {
        OpenDocument recovered = OpenDocument.recover(found);
        open(recovered);
        recovery.adopt(found);
    }

    /** Makes an edit unless it was refused; returns the reason if it was. Live, the edit is rendered at once. */
    public Optional<String> edit(Change change) {
        return edit(change, null);
    }

    /** The same as part of a gesture: see {@link History#edit(Scene, Object)}. */
    public Optional<String> edit(Change change, Object gesture) {
        Optional<String> refusal = document.apply(change, gesture);
        if (refusal.isEmpty()) {
            edited();
        }
        return refusal;
    }

    public void undo() {
        document.history().undo();
        edited();
    }

    public void redo() {
        document.history().redo();
        edited();
    }

    /** Takes back the last edit of the selected light alone; returns the reason if it could not. */
    public Optional<String> undoLight() {
        return ofSelected(document.history()::undoLight);
    }

    /** Does again what was undone last of the selected light; returns the reason if it could not. */
    public Optional<String> redoLight() {
        return ofSelected(document.history()::redoLight);
    }

    private Optional<String> ofSelected(LongFunction<Change> step) {
        document.settleSelection();
        long id = document.selectedLight().map(l -> document.history().id(l.name())).orElse(-1L);
        Optional<String> refusal = step.apply(id).refusal();
        edited();
        return refusal;
    }

    public void select(Selection selection) {
        document.select(selection);
        changed.run();
    }

    /** Selects the light of that name; nothing if there is none. */
    public void selectLight(String name) {
        select(Selection.light(document.history(), name));
    }

    /** Keeps the selected light's settings for {@link #pasteSettings}. */
    public void copySettings() {
        copied = document.selectedLight();
        changed.run();
    }

    /** Gives the selected light the settings copied last; returns the reason if it could not. */
    public Optional<String> pasteSettings() {
        Optional<Light> selected = document.selectedLight();
        return selected.isEmpty() || copied.isEmpty() ? Command.PASTE_SETTINGS.obstacle(situation())
                : edit(LightEdits.paste(scene(), selected.get().name(), copied.get()));
    }

    /** Saves to the document's file: see {@link OpenDocument#save(Set)}. */
    public void save(Set<Consent> allowed) throws IOException {
        document.save(allowed);
        kept();
    }

    /** Saves to another file: see {@link OpenDocument#saveAs(Path, Set)}. */
    public void saveAs(Path file, Set<Consent> allowed) throws IOException {
        document.saveAs(file, allowed);
        kept();
    }

    /** Takes what was seen of the document's file on disk. */
    public void hear(DiskNews news) {
        document.hear(news);
        changed.run();
    }

    /** Stays with the open scene although its file was changed: see {@link OpenDocument#keepAgainstNews}. */
    public void keepAgainstNews() {
        document.keepAgainstNews();
        kept();
    }

    /** Starts over with the file as it is on disk and renders it. */
    public void reload() throws IOException, JenException {
        document.reload();
        kept();
        go();
    }

    private void kept() {
        autosave.changed(document);
        changed.run();
    }

    /** Renders the document's scene. */
    public void go() {
        show(scene());
    }

    /** Renders a scene that is not the document's, as an animation's frame. */
    public void show(Scene scene) {
        inWork = Optional.of(scene);
        loop.render(scene);
        changed.run();
    }

    public void updateReflections() {
        inWork = Optional.of(inWork.orElseGet(() -> frame.map(Frame::scene).orElse(scene())));
        loop.updateReflections();
        changed.run();
    }

    public void verify() {
        verifying = frame.isPresent();
        loop.verify();
        changed.run();
    }

    /** Stops what runs and forgets what waits. */
    public void cancel() {
        loop.cancel();
        refresh();
        changed.run();
    }

    /** The loop tells of the end of what ran; what only waited may be gone without a word. */
    private void refresh() {
        inWork = loop.isBusy() ? inWork : Optional.empty();
        verifying = loop.isVerifying();
    }

    /** Another accuracy: what is known of the picture serves on. */
    public void reopen(Options options) {
        inWork = Optional.of(scene());
        loop.reopen(options, scene());
        changed.run();
    }

    /** Shows the picture in another way: see {@link RenderLoop#setLook}. */
    public void setLook(Look look) {
        loop.setLook(look);
    }

    /** See {@link RenderLoop#setView}. */
    public void setView(ViewTransform view) {
        loop.setView(view);
    }

    /** Whether every edit is rendered at once; off at first (paper §3.3). */
    public boolean isLive() {
        return live;
    }

    /** Switched on, renders what is pending. */
    public void setLive(boolean v) {
        live = v;
        renderIfLive();
        changed.run();
    }

    /** Whether an animation is open, which holds back the commands that change the document. */
    public void setAnimating(boolean v) {
        animating = v;
        changed.run();
    }

    private void edited() {
        autosave.changed(document);
        renderIfLive();
        changed.run();
    }

    private void renderIfLive() {
        if (live && Command.GO.isEnabled(situation())) {
            inWork = Optional.of(scene());
            loop.render(scene());
        }
    }

    /** Ends all threads. Edits that are not saved are lost: ask before. */
    @Override
    public void close() {
        loop.close();
        autosave.forget();
        autosave.close();
    }
}
