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
import lightning.editor.loop.Frame;
import lightning.editor.loop.Look;
import lightning.editor.loop.RenderFeed;
import lightning.editor.loop.RenderListener;
import lightning.editor.loop.RenderLoop;
import lightning.editor.loop.RenderState;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.render.relight.tile.Options;
import lightning.scene.Light;
import lightning.scene.Scene;
import lightning.scene.VisiblePart;
import lightning.scene.shot.AnimatedScene;

/**
 * Everything that an editor's window works on: the open document, its picture, and what renders and keeps it. All panes
 * share one, change the document through it, and hear of every change.
 *
 * <p>Belongs to the window's thread; what the render loop tells, and what comes of files, is brought there.
 */
public final class Workbench implements AutoCloseable {
    private final Runnable changed;
    private final RenderLoop loop;
    private final FileThread files;
    private final ArrayDeque<Runnable> saves = new ArrayDeque<>();
    private final Autosave autosave;
    private OpenDocument document;
    private final RenderFeed feed;
    private final Runnable progressed;
    /** The picture and how far it is, as heard last. */
    private RenderState rendering = RenderState.NONE;
    private long opened;
    private Optional<Scene> previous = Optional.empty();
    private Optional<Scene> inWork = Optional.empty();
    private Optional<Light> copied = Optional.empty();
    private boolean verifying;
    private boolean live;
    private boolean animating;
    private boolean way;

    /**
     * @param document what is open first; it is rendered by {@link #go()}
     * @param files      reads and writes the document; its window's thread is the one that the workbench belongs to
     * @param changed    called there after every change of what the workbench tells
     * @param progressed called there where nothing but {@link #rendering} is another
     * @param canvas     hears the render loop on its own threads, before the workbench does
     * @param trouble    hears, on the autosave thread, why edits could not be kept
     */
    public Workbench(OpenDocument document, Options options, Recovery recovery, FileThread files, Runnable changed,
            Runnable progressed, RenderListener canvas, Consumer<Throwable> trouble) {
        this.document = document;
        this.changed = changed;
        this.progressed = progressed;
        this.files = files;
        autosave = new Autosave(recovery, Autosave.DEFAULT_DELAY, trouble);
        feed = new RenderFeed(files.window(), canvas, this::hear);
        loop = new RenderLoop(options, feed);
    }

    /** Before the document is rendered: what is being looked at of it is not traced again. */
    public void begin(Future<Optional<CoarsePicture>> seen) {
        loop.begin(seen);
    }

    public OpenDocument document() {
        return document;
    }

    /** The picture, and how far the next one is. */
    public RenderState rendering() {
        return rendering;
    }

    /** The picture rendered last; its film may be written over by now. */
    public Optional<Frame> frame() {
        return Optional.ofNullable(rendering.frame());
    }

    /** What is kept of the picture: see {@link RenderLoop#known}. On any thread. */
    public Optional<PixelCache> known() {
        return loop.known();
    }

    private void hear() {
        Frame before = rendering.frame();
        boolean worked = inWork.isPresent();
        boolean verified = verifying;
        refresh();
        boolean same = rendering.frame() == before && inWork.isPresent() == worked && verifying == verified;
        (same ? progressed : changed).run();
    }

    /** Looks at what the loop does, and then at what it has told: what it finished before the first is in the second. */
    private void refresh() {
        boolean busy = loop.isBusy();
        verifying = loop.isVerifying();
        inWork = busy ? inWork : Optional.empty();
        RenderState now = feed.state();
        if (now.frame() != null && now.frame() != rendering.frame()) {
            Optional<Scene> shown = frame().map(Frame::scene);
            previous = shown.filter(s -> !VisiblePart.same(s, now.frame().scene())).or(() -> previous);
        }
        rendering = now;
    }

    /** The edit made last; empty where there is none, or it made another picture of it. */
    public Optional<LastEdit> lastEdit() {
        return LastEdit.of(document.scene(), frame().map(Frame::scene), previous);
    }

    /** What decides which commands are enabled. */
    public Situation situation() {
        return Situation.of(document, frame()).withInWork(inWork).withVerifying(verifying).withCopied(copied)
                .withAnimating(animating).withWay(way);
    }

    /** Puts another document in place of the open one and renders it. The open one's unsaved edits are lost. */
    public void open(OpenDocument other) {
        opened++;
        feed.open(opened);
        loop.open(other.scene(), opened);
        inWork = Optional.of(other.scene());
        autosave.forget();
        document = other;
        rendering = RenderState.NONE;
        previous = Optional.empty();
        animating = false;
        way = false;
        autosave.changed(document);
        changed.run();
    }

    /** Opens what a crash left unsaved: see {@link OpenDocument#recover}. Until it is saved it can be recovered again. */
    public void recover(Recovery.Found found, OpenDocument recovered) {
        open(recovered);
        autosave.adopt(found);
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

    /** The same as a step of its own, and selects something then: who shows the document hears of both at once. */
    public Optional<String> editAndSelect(Change change, Selection then) {
        Optional<String> refusal = document.apply(change, null);
        if (refusal.isEmpty()) {
            document.select(then);
            edited();
        }
        return refusal;
    }

    /** Makes an edit of the scene with its shot: see {@link OpenDocument#applyToAll}. */
    public Optional<String> editAll(Supplier<AnimatedScene> edit, Object gesture) {
        Scene before = document.scene();
        Optional<String> refusal = document.applyToAll(edit, gesture);
        if (refusal.isEmpty()) {
            boolean same = document.scene().equals(before);
            autosave.changed(document);
            if (!same) {
                renderIfLive();
            }
            changed.run();
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
        edited();
    }

    public void redo() {
        document.history().redo();
        edited();
    }

    /** Undoes or does again until so many of the document's steps are done: see {@link History#goTo}. */
    public void goTo(int position) {
        document.history().goTo(position);
        edited();
    }

    /** The same of the selected light alone; returns the reason if it could not: see {@link History#goToOfLight}. */
    public Optional<String> goToOfLight(int position) {
        return ofSelected(id -> document.history().goToOfLight(id, position));
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
                : edit(LightEdits.paste(document.scene(), selected.get().name(), copied.get()));
    }

    /**
     * Saves to a file, that of the document or another, after all saves asked for before: see {@link SceneWriting#write}.
     *
     * @param ended hears why the scene could not be written; nothing where it was
     */
    public void saveAs(Path file, Set<Consent> allowed, Consumer<Optional<Throwable>> ended) {
        OpenDocument saved = document;
        saves.add(() -> write(saved, file, allowed, ended));
        if (saves.size() == 1) {
            saves.element().run();
        }
    }

    private void write(OpenDocument saved, Path file, Set<Consent> allowed, Consumer<Optional<Throwable>> ended) {
        files.inTurn(saved.writing(file, allowed)::write, now -> {
            saved.written(now);
            kept();
            saveNext();
            ended.accept(Optional.empty());
        }, why -> {
            saveNext();
            ended.accept(Optional.of(why));
        });
    }

    private void saveNext() {
        saves.remove();
        if (!saves.isEmpty()) {
            saves.element().run();
        }
    }

    /** Whether a save is not written yet. */
    public boolean isSaving() {
        return !saves.isEmpty();
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

    /**
     * Starts over with the file as it is on disk and renders it.
     *
     * @param ended hears why the file could not be read; nothing where it was. Not told where another document is open by then
     */
    public void reload(Consumer<Optional<Throwable>> ended) {
        OpenDocument old = document;
        files.inTurn(() -> SavedScene.read(old.file()), now -> {
            if (old == document) {
                old.reloaded(now);
                kept();
                go();
                ended.accept(Optional.empty());
            }
        }, why -> ended.accept(Optional.of(why)));
    }

    private void kept() {
        autosave.changed(document);
        changed.run();
    }

    /** Renders the document's scene. */
    public void go() {
        show(document.scene());
    }

    /** Renders a scene that is not the document's, as an animation's frame. */
    public void show(Scene scene) {
        inWork = Optional.of(scene);
        loop.render(scene);
        changed.run();
    }

    public void updateReflections() {
        inWork = Optional.of(inWork.orElseGet(() -> frame().map(Frame::scene).orElse(document.scene())));
        loop.updateReflections();
        changed.run();
    }

    public void verify() {
        verifying = frame().isPresent();
        loop.verify();
        changed.run();
    }

    /** Stops what runs and forgets what waits. */
    public void cancel() {
        if (loop.cancel()) {
            feed.cancelledUnbegun();
        }
        refresh();
        changed.run();
    }

    /** Another accuracy: what is known of the picture serves on. */
    public void reopen(Options options) {
        inWork = Optional.of(document.scene());
        loop.reopen(options, document.scene());
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
        way &= v;
        changed.run();
    }

    /** Whether the open animation has a way. */
    public void setWay(boolean v) {
        way = v;
        changed.run();
    }

    private void edited() {
        document.settleFrame();
        autosave.changed(document);
        renderIfLive();
        changed.run();
    }

    private void renderIfLive() {
        if (live && Command.GO.isEnabled(situation())) {
            inWork = Optional.of(document.scene());
            loop.render(document.scene());
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
