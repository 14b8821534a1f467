package lightning.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import lightning.base.file.FileState;
import lightning.base.work.Await;
import lightning.document.DeskScene;
import lightning.document.EditOutcome;
import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.PictureArea;
import lightning.document.RecoveryFolder;
import lightning.document.loop.KeptPictures;
import lightning.document.loop.RecordingRenderListener;
import lightning.render.RenderOptions;
import lightning.render.measure.Verification;
import lightning.render.relight.paper.ReflectionMode;
import lightning.render.relight.plan.UpdatePlan;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests of the workbench, with the test's thread as the window's thread. */
class WorkbenchTest {
    private static final RenderOptions OPTIONS = RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1);

    @TempDir
    private Path folder;

    private final LinkedBlockingQueue<Runnable> window = new LinkedBlockingQueue<>();
    private final FileThread files = new FileThread(window::add);
    private final RecordingRenderListener listener = new RecordingRenderListener();
    private final List<Optional<Throwable>> failures = new ArrayList<>();
    private Workbench workbench;
    private int changes;

    @BeforeEach
    void open() throws Exception {
        Path file = Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT);
        workbench = new Workbench(OpenDocument.open(file), OPTIONS, new RecoveryFolder(folder.resolve("kept")), files,
                () -> changes++, () -> {}, listener, e -> {}, KeptPictures.none());
    }

    @AfterEach
    void close() {
        workbench.close();
        files.close();
    }

    private void runUntil(BooleanSupplier condition) throws InterruptedException {
        while (!condition.getAsBoolean()) {
            Runnable task = window.poll(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
            assertThat(task).as("task for the window").isNotNull();
            task.run();
        }
    }

    private void awaitIdle() throws InterruptedException {
        runUntil(() -> workbench.editorState().sceneInProgress().isEmpty() && !workbench.editorState().verifying());
    }

    @Test
    void lastEdit_isPendingEditOrLastUpdate() throws InterruptedException {
        Scene first = workbench.document().scene();
        workbench.go();
        awaitIdle();
        assertThat(workbench.lastEdit()).isEmpty();
        setIntensity(2);
        Scene second = workbench.document().scene();
        assertThat(workbench.lastEdit()).contains(new LastEdit(first, second, true));
        workbench.go();
        awaitIdle();
        assertThat(workbench.lastEdit()).contains(new LastEdit(first, second, false));
        workbench.updateReflections();
        awaitIdle();
        assertThat(workbench.lastEdit()).as("updating reflections is not an edit").contains(new LastEdit(first, second, false));
        workbench.edit(new EditOutcome.Applied(second.withPicture(second.picture().withSize(20, 10))));
        assertThat(workbench.lastEdit()).as("different image").isEmpty();
    }

    private void setIntensity(double intensity) {
        assertThat(workbench.edit(DeskScene.parameter("intensity").set(workbench.document().scene(), "key", intensity))).isEmpty();
    }

    private Scene shownScene() {
        return workbench.frame().orElseThrow().scene();
    }

    private void setArea(int width, int height) {
        workbench.setArea(Optional.of(new PictureArea(width, height)));
    }

    @Test
    void pictureOfAnArea_hasItsSizeAndTheSceneKeepsItsOwn() throws Exception {
        Scene scene = workbench.document().scene();
        workbench.go();
        awaitIdle();
        setArea(80, 1000);
        awaitIdle();
        assertThat(shownScene().picture().width()).isEqualTo(80);
        assertThat(shownScene().withPicture(scene.picture())).isEqualTo(scene).isEqualTo(workbench.document().scene());
        assertThat(Command.GO.isEnabled(workbench.editorState())).as("nothing is pending").isFalse();
        assertThat(workbench.editorState().dirty()).isFalse();
        setIntensity(2);
        workbench.go();
        awaitIdle();
        assertThat(shownScene().picture().width()).isEqualTo(80);
        workbench.setArea(Optional.empty());
        awaitIdle();
        assertThat(shownScene()).isEqualTo(workbench.document().scene());
    }

    @Test
    void newArea_rendersNoPendingEdit() throws Exception {
        workbench.go();
        awaitIdle();
        Scene before = shownScene();
        setIntensity(2);
        setArea(80, 1000);
        assertThat(workbench.editorState().sceneInProgress()).isEmpty();
        assertThat(shownScene()).isSameAs(before);
        assertThat(Command.GO.isEnabled(workbench.editorState())).isTrue();
    }

    @Test
    void go_rendersSceneAndIsThenDisabled() throws Exception {
        workbench.go();
        assertThat(Command.GO.isEnabled(workbench.editorState())).isFalse();
        awaitIdle();
        assertThat(shownScene()).isEqualTo(workbench.document().scene());
        assertThat(Command.GO.isEnabled(workbench.editorState())).isFalse();
    }

    @Test
    void finishedJob_isReportedWithPicture() throws Exception {
        workbench.go();
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        setIntensity(2);
        workbench.go();
        listener.expectNext(RecordingRenderListener.Event.IDLE);
        // Before the window's thread has run its tasks.
        awaitIdle();
        assertThat(shownScene()).isEqualTo(workbench.document().scene());
        for (Runnable task = window.poll(); task != null; task = window.poll()) {
            task.run();
            assertThat(shownScene()).isEqualTo(workbench.document().scene());
        }
    }

    @Test
    void edit_waitsForGo() throws Exception {
        workbench.go();
        awaitIdle();
        setIntensity(2);
        assertThat(workbench.editorState().sceneInProgress()).isEmpty();
        assertThat(workbench.editorState().hasPendingEdits()).isTrue();
        workbench.go();
        awaitIdle();
        assertThat(shownScene()).isEqualTo(workbench.document().scene());
    }

    @Test
    void live_rendersEveryEdit() throws Exception {
        workbench.go();
        awaitIdle();
        workbench.setLive(true);
        setIntensity(2);
        awaitIdle();
        assertThat(shownScene()).isEqualTo(workbench.document().scene());
        workbench.undo();
        awaitIdle();
        assertThat(shownScene()).isEqualTo(DeskScene.scene());
    }

    @Test
    void liveSwitchedOn_rendersPendingEdits() throws Exception {
        workbench.go();
        awaitIdle();
        setIntensity(2);
        workbench.setLive(true);
        awaitIdle();
        assertThat(workbench.editorState().hasPendingEdits()).isFalse();
    }

    @Test
    void undoAndRedoOfTheSelectedLight_areEdits() {
        setIntensity(2);
        assertThat(workbench.undoLight()).contains("nothing to undo for this light");
        workbench.selectLight("key");
        assertThat(workbench.undoLight()).isEmpty();
        assertThat(workbench.document().scene()).isEqualTo(DeskScene.scene());
        assertThat(workbench.redoLight()).isEmpty();
        assertThat(DeskScene.light(workbench.document().scene(), "key").intensity()).isEqualTo(2);
    }

    @Test
    void lightHistory_survivesGo() throws Exception {
        workbench.selectLight("key");
        setIntensity(2);
        workbench.go();
        awaitIdle();
        setIntensity(3);
        workbench.go();
        awaitIdle();
        assertThat(workbench.undoLight()).isEmpty();
        assertThat(DeskScene.light(workbench.document().scene(), "key").intensity()).isEqualTo(2);
        assertThat(workbench.undoLight()).isEmpty();
        assertThat(workbench.document().scene()).isEqualTo(DeskScene.scene());
        assertThat(Command.GO.isEnabled(workbench.editorState())).as("undone edit not rendered").isTrue();
        assertThat(workbench.redoLight()).isEmpty();
        assertThat(DeskScene.light(workbench.document().scene(), "key").intensity()).isEqualTo(2);
    }

    @Test
    void copiedSettings_arePastedToSelectedLight() {
        workbench.selectLight("fill");
        assertThat(workbench.pasteSettings()).contains("no settings are copied");
        workbench.selectLight("key");
        workbench.copySettings();
        workbench.selectLight("fill");
        assertThat(workbench.pasteSettings()).isEmpty();
        assertThat(DeskScene.light(workbench.document().scene(), "fill").type())
                .isEqualTo(DeskScene.light(workbench.document().scene(), "key").type());
    }

    @Test
    void updateReflections_makesTheMirrorsCurrent() throws Exception {
        workbench.go();
        awaitIdle();
        setIntensity(2);
        workbench.go();
        awaitIdle();
        assertThat(Command.UPDATE_REFLECTIONS.isEnabled(workbench.editorState())).isTrue();
        workbench.updateReflections();
        awaitIdle();
        assertThat(Command.UPDATE_REFLECTIONS.isEnabled(workbench.editorState())).isFalse();
    }

    @Test
    void verify_runsInBackgroundAndEnds() throws Exception {
        workbench.go();
        awaitIdle();
        workbench.verify();
        assertThat(Command.CANCEL.isEnabled(workbench.editorState())).isTrue();
        awaitIdle();
        assertThat(listener.next(Verification.class).currentDifference().isNone()).isTrue();
        assertThat(Command.CANCEL.isEnabled(workbench.editorState())).isFalse();
    }

    @Test
    void canceledGo_isStillPending() throws Exception {
        workbench.go();
        awaitIdle();
        setIntensity(2);
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        workbench.go();
        hold.awaitReached();
        workbench.cancel();
        hold.release();
        awaitIdle();
        assertThat(Command.GO.isEnabled(workbench.editorState())).isTrue();
    }

    @Test
    void accuracyWithCurrentReflections_rendersWithoutGo() throws Exception {
        workbench.go();
        awaitIdle();
        setIntensity(2);
        workbench.changeOptions(OPTIONS.withReflections(ReflectionMode.CURRENT));
        awaitIdle();
        assertThat(shownScene()).isEqualTo(workbench.document().scene());
        assertThat(workbench.frame().orElseThrow().mirrorsAreCurrent()).isTrue();
    }

    @Test
    void otherDocument_replacesOpenOneAndIsRendered() throws Exception {
        workbench.go();
        awaitIdle();
        setIntensity(2);
        Path other = Files.writeString(folder.resolve("other.jen"), DeskScene.TEXT.replace("light sun", "light moon"));
        workbench.open(OpenDocument.open(other));
        assertThat(workbench.document().name()).isEqualTo("other.jen");
        assertThat(workbench.frame()).as("image of the other document").isEmpty();
        awaitIdle();
        assertThat(shownScene().light("moon")).isPresent();
        assertThat(workbench.frame().orElseThrow().mirrorsAreCurrent()).as("reflections without the other document").isTrue();
        assertThat(workbench.frame().orElseThrow().update().plan()).isEqualTo(new UpdatePlan.FirstPass("no image yet"));
    }

    @Test
    void otherDocumentCanceledBeforeStart_isReportedAsCanceled() throws Exception {
        RecordingRenderListener.Hold hold = listener.holdNextTile();
        workbench.go();
        hold.awaitReached();
        workbench.open(OpenDocument.open(Files.writeString(folder.resolve("other.jen"), DeskScene.TEXT)));
        workbench.cancel();
        assertThat(workbench.renderState().canceled()).isTrue();
        hold.release();
        awaitIdle();
        assertThat(workbench.frame()).isEmpty();
        assertThat(workbench.renderState().canceled()).as("after the loop dropped the previous document").isTrue();
    }

    @Test
    void recoveredDocument_isStoredUntilSaved() throws Exception {
        var crashed = new RecoveryFolder(folder.resolve("kept"), "999999999999-1");
        Path file = Files.writeString(folder.resolve("lost.jen"), DeskScene.TEXT);
        crashed.store(file, FileState.of(file), DeskScene.TEXT.replace("intensity 0.3", "intensity 0.9"));
        RecoveryFolder own = new RecoveryFolder(folder.resolve("kept"));
        RecoveryFolder.RecoverableScene found = own.list().getFirst();
        workbench.recover(found, OpenDocument.recover(found), () -> {});
        assertThat(DeskScene.light(workbench.document().scene(), "sun").intensity()).isEqualTo(0.9);
        Await.until(() -> own.list().isEmpty());
        assertThat(fileCount()).isEqualTo(1);
        save(workbench.document().file());
        Await.until(() -> fileCount() == 0);
    }

    /** The recovered edit of the open file is an update of its picture, not another first pass. */
    @Test
    void recoveredEditOfOpenFile_updatesPicture() throws Exception {
        workbench.go();
        awaitIdle();
        var crashed = new RecoveryFolder(folder.resolve("kept"), "999999999999-1");
        crashed.store(workbench.document().file(), workbench.document().knownState(),
                DeskScene.TEXT.replace("intensity 0.3", "intensity 0.9"));
        RecoveryFolder.RecoverableScene found = new RecoveryFolder(folder.resolve("kept")).list().getFirst();
        OpenDocument recovered = OpenDocument.recover(found);
        workbench.recover(found, recovered, () -> {});
        assertThat(workbench.frame()).as("the picture stays").isPresent();
        awaitIdle();
        assertThat(DeskScene.light(shownScene(), "sun").intensity()).isEqualTo(0.9);
        assertThat(workbench.frame().orElseThrow().update().plan()).isInstanceOf(UpdatePlan.Relight.class);
        assertThat(recovered.history().undoLabel()).hasValueSatisfying(label -> assertThat(label).contains("sun").contains("intensity"));
    }

    private void save(Path file) throws InterruptedException {
        failures.clear();
        workbench.saveAs(file, Set.of(), failures::add);
        runUntil(() -> !failures.isEmpty());
        assertThat(failures).containsExactly(Optional.empty());
    }

    private long fileCount() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("kept"))) {
            return files.count();
        }
    }

    @Test
    void reload_rendersFileContent() throws Exception {
        setIntensity(2);
        workbench.reload(failures::add);
        runUntil(() -> failures.contains(Optional.empty()));
        awaitIdle();
        assertThat(shownScene()).isEqualTo(DeskScene.scene());
        assertThat(Command.RELOAD.isEnabled(workbench.editorState())).isFalse();
    }

    @Test
    void savedDocument_isCleanUnderNewName() throws Exception {
        setIntensity(2);
        save(folder.resolve("other.jen"));
        setIntensity(3);
        save(workbench.document().file());
        assertThat(Command.SAVE_SCENE.isEnabled(workbench.editorState())).isFalse();
        assertThat(OpenDocument.open(folder.resolve("other.jen")).scene()).isEqualTo(workbench.document().scene());
    }

    @Test
    void editDuringSave_isUnsavedButNotLost() throws Exception {
        setIntensity(2);
        workbench.saveAs(workbench.document().file(), Set.of(), failures::add);
        setIntensity(3);
        runUntil(() -> !failures.isEmpty());
        assertThat(workbench.editorState().dirty()).isTrue();
        assertThat(DeskScene.light(workbench.document().scene(), "key").intensity()).isEqualTo(3);
        assertThat(DeskScene.light(OpenDocument.open(workbench.document().file()).scene(), "key").intensity()).isEqualTo(2);
    }

    @Test
    void saveRequestedDuringSave_writesLatestScene() throws Exception {
        setIntensity(2);
        workbench.saveAs(workbench.document().file(), Set.of(), failures::add);
        setIntensity(3);
        workbench.saveAs(workbench.document().file(), Set.of(), failures::add);
        assertThat(workbench.isSaving()).isTrue();
        runUntil(() -> failures.size() == 2);
        assertThat(failures).as("own save is not an external change").containsOnly(Optional.empty());
        assertThat(workbench.isSaving()).isFalse();
        assertThat(workbench.editorState().dirty()).isFalse();
        assertThat(DeskScene.light(OpenDocument.open(workbench.document().file()).scene(), "key").intensity()).isEqualTo(3);
    }

    @Test
    void failedSave_isReportedAndKeepsEdits() throws Exception {
        setIntensity(2);
        workbench.saveAs(folder.resolve("nowhere/desk.jen"), Set.of(), failures::add);
        runUntil(() -> !failures.isEmpty());
        assertThat(failures.getFirst()).isPresent();
        assertThat(workbench.editorState().dirty()).isTrue();
        assertThat(workbench.document().name()).isEqualTo("desk.jen");
    }

    @Test
    void everyChange_isReported() throws Exception {
        int before = changes;
        setIntensity(2);
        workbench.selectLight("key");
        workbench.undo();
        workbench.redo();
        assertThat(changes).isEqualTo(before + 4);
        workbench.go();
        awaitIdle();
        assertThat(changes).isGreaterThan(before + 5);
    }

    @Test
    void refusedEdit_isNoChange() {
        int before = changes;
        assertThat(workbench.edit(DeskScene.parameter("angle").set(workbench.document().scene(), "key", 999))).isPresent();
        assertThat(changes).isEqualTo(before);
    }

    @Test
    void renderedEditWithoutLive_isToldOnce() throws Exception {
        workbench.go();
        awaitIdle();
        int before = changes;
        workbench.editAndRender(DeskScene.parameter("angle").set(workbench.document().scene(), "key", 20), null);
        assertThat(changes).isEqualTo(before + 1);
        awaitIdle();
        assertThat(shownScene()).isEqualTo(workbench.document().scene());
    }
}
