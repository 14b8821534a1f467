package lightning.editor.document;

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
import lightning.base.math.Vec3;
import lightning.base.work.Wait;
import lightning.bench.accuracy.Verification;
import lightning.editor.loop.LoopEar;
import lightning.render.relight.plan.Reflections;
import lightning.render.relight.plan.UpdatePlan;
import lightning.render.relight.tile.Options;
import lightning.scene.Light;
import lightning.scene.Scene;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The test's thread is the window's: it runs what the loop sends there. */
class WorkbenchTest {
    private static final Options OPTIONS = Options.DEFAULT.withReflections(Reflections.STALE).withThreads(1);

    @TempDir
    private Path folder;

    private final LinkedBlockingQueue<Runnable> window = new LinkedBlockingQueue<>();
    private final FileThread files = new FileThread(window::add);
    private final LoopEar ear = new LoopEar();
    private final List<Optional<Throwable>> failures = new ArrayList<>();
    private Workbench bench;
    private int changes;

    @BeforeEach
    void open() throws Exception {
        Path file = Files.writeString(folder.resolve("desk.jen"), Desk.TEXT);
        bench = new Workbench(OpenDocument.open(file), OPTIONS, new Recovery(folder.resolve("kept")), files,
                () -> changes++, () -> {}, ear, e -> {});
    }

    @AfterEach
    void close() {
        bench.close();
        files.close();
    }

    private void runUntil(BooleanSupplier condition) throws InterruptedException {
        while (!condition.getAsBoolean()) {
            Runnable task = window.poll(Wait.MOST_SECONDS, TimeUnit.SECONDS);
            assertThat(task).as("a task for the window").isNotNull();
            task.run();
        }
    }

    private void settle() throws InterruptedException {
        runUntil(() -> bench.situation().inWork().isEmpty() && !bench.situation().verifying());
    }

    @Test
    void lastEdit_isWhatIsPendingOrElseWhatTheLastUpdateShowed() throws InterruptedException {
        Scene first = bench.document().scene();
        bench.go();
        settle();
        assertThat(bench.lastEdit()).isEmpty();
        dial(2);
        Scene second = bench.document().scene();
        assertThat(bench.lastEdit()).contains(new LastEdit(first, second, true));
        bench.go();
        settle();
        assertThat(bench.lastEdit()).contains(new LastEdit(first, second, false));
        bench.updateReflections();
        settle();
        assertThat(bench.lastEdit()).as("mirrors are no edit").contains(new LastEdit(first, second, false));
        bench.edit(new Change.To(second.withPicture(second.picture().withSize(20, 10))));
        assertThat(bench.lastEdit()).as("another picture").isEmpty();
    }

    private void dial(double intensity) {
        assertThat(bench.edit(Desk.dial("intensity").set(bench.document().scene(), "key", intensity))).isEmpty();
    }

    private Scene shown() {
        return bench.frame().orElseThrow().scene();
    }

    @Test
    void go_rendersTheSceneAndHasThenNothingToDo() throws Exception {
        bench.go();
        assertThat(Command.GO.isEnabled(bench.situation())).isFalse();
        settle();
        assertThat(shown()).isEqualTo(bench.document().scene());
        assertThat(Command.GO.isEnabled(bench.situation())).isFalse();
    }

    @Test
    void workThatEnded_isTakenWithItsPicture() throws Exception {
        bench.go();
        ear.nextIs(LoopEar.Event.IDLE);
        dial(2);
        bench.go();
        ear.nextIs(LoopEar.Event.IDLE);
        // The window had no time to listen yet.
        settle();
        assertThat(shown()).isEqualTo(bench.document().scene());
        for (Runnable task = window.poll(); task != null; task = window.poll()) {
            task.run();
            assertThat(shown()).isEqualTo(bench.document().scene());
        }
    }

    @Test
    void edit_waitsForGo() throws Exception {
        bench.go();
        settle();
        dial(2);
        assertThat(bench.situation().inWork()).isEmpty();
        assertThat(bench.situation().isPending()).isTrue();
        bench.go();
        settle();
        assertThat(shown()).isEqualTo(bench.document().scene());
    }

    @Test
    void live_rendersEveryEdit() throws Exception {
        assertThat(bench.isLive()).isFalse();
        bench.go();
        settle();
        bench.setLive(true);
        dial(2);
        settle();
        assertThat(shown()).isEqualTo(bench.document().scene());
        bench.undo();
        settle();
        assertThat(shown()).isEqualTo(Desk.scene());
    }

    @Test
    void liveSwitchedOn_rendersWhatIsPending() throws Exception {
        bench.go();
        settle();
        dial(2);
        bench.setLive(true);
        settle();
        assertThat(bench.situation().isPending()).isFalse();
    }

    @Test
    void undoAndRedoOfTheSelectedLight_areEdits() {
        dial(2);
        assertThat(bench.undoLight()).contains("there is nothing to undo of this light");
        bench.selectLight("key");
        assertThat(bench.undoLight()).isEmpty();
        assertThat(bench.document().scene()).isEqualTo(Desk.scene());
        assertThat(bench.redoLight()).isEmpty();
        assertThat(Desk.light(bench.document().scene(), "key").intensity()).isEqualTo(2);
    }

    @Test
    void historyOfALight_survivesGo() throws Exception {
        bench.selectLight("key");
        dial(2);
        bench.go();
        settle();
        dial(3);
        bench.go();
        settle();
        assertThat(bench.undoLight()).isEmpty();
        assertThat(Desk.light(bench.document().scene(), "key").intensity()).isEqualTo(2);
        assertThat(bench.undoLight()).isEmpty();
        assertThat(bench.document().scene()).isEqualTo(Desk.scene());
        assertThat(Command.GO.isEnabled(bench.situation())).as("what was undone is not rendered").isTrue();
        assertThat(bench.redoLight()).isEmpty();
        assertThat(Desk.light(bench.document().scene(), "key").intensity()).isEqualTo(2);
    }

    @Test
    void copiedSettings_arePastedOnTheSelectedLight() {
        bench.selectLight("fill");
        assertThat(bench.pasteSettings()).contains("no settings were copied");
        bench.selectLight("key");
        bench.copySettings();
        bench.selectLight("fill");
        assertThat(bench.pasteSettings()).isEmpty();
        assertThat(Desk.light(bench.document().scene(), "fill").type()).isEqualTo(Desk.light(bench.document().scene(), "key").type());
    }

    @Test
    void updateReflections_makesTheMirrorsCurrent() throws Exception {
        bench.go();
        settle();
        dial(2);
        bench.go();
        settle();
        assertThat(Command.UPDATE_REFLECTIONS.isEnabled(bench.situation())).isTrue();
        bench.updateReflections();
        settle();
        assertThat(Command.UPDATE_REFLECTIONS.isEnabled(bench.situation())).isFalse();
    }

    @Test
    void verify_runsBesideAndEnds() throws Exception {
        bench.go();
        settle();
        bench.verify();
        assertThat(Command.CANCEL.isEnabled(bench.situation())).isTrue();
        settle();
        assertThat(ear.next(Verification.class).current().isNone()).isTrue();
        assertThat(Command.CANCEL.isEnabled(bench.situation())).isFalse();
    }

    @Test
    void cancelledGo_isStillPending() throws Exception {
        bench.go();
        settle();
        dial(2);
        LoopEar.Hold hold = ear.holdNextTile();
        bench.go();
        hold.awaitReached();
        bench.cancel();
        hold.release();
        settle();
        assertThat(Command.GO.isEnabled(bench.situation())).isTrue();
    }

    @Test
    void currentReflections_areThereWithoutGo() throws Exception {
        bench.go();
        settle();
        dial(2);
        bench.reopen(OPTIONS.withReflections(Reflections.CURRENT));
        settle();
        assertThat(shown()).isEqualTo(bench.document().scene());
        assertThat(bench.frame().orElseThrow().mirrorsAreCurrent()).isTrue();
    }

    @Test
    void anotherDocument_takesThePlaceAndIsRendered() throws Exception {
        bench.go();
        settle();
        dial(2);
        Path other = Files.writeString(folder.resolve("other.jen"), Desk.TEXT.replace("light sun", "light moon"));
        bench.open(OpenDocument.open(other));
        assertThat(bench.document().name()).isEqualTo("other.jen");
        assertThat(bench.frame()).as("a picture of the other document").isEmpty();
        settle();
        assertThat(shown().light("moon")).isPresent();
        assertThat(bench.frame().orElseThrow().mirrorsAreCurrent()).as("its mirrors show nothing of the other document").isTrue();
        assertThat(bench.frame().orElseThrow().update().plan()).isEqualTo(new UpdatePlan.FirstPass("no picture yet"));
    }

    @Test
    void otherDocumentCancelledBeforeItIsBegun_isToldAsCancelled() throws Exception {
        LoopEar.Hold hold = ear.holdNextTile();
        bench.go();
        hold.awaitReached();
        bench.open(OpenDocument.open(Files.writeString(folder.resolve("other.jen"), Desk.TEXT)));
        bench.cancel();
        assertThat(bench.rendering().cancelled()).isTrue();
        hold.release();
        settle();
        assertThat(bench.frame()).isEmpty();
        assertThat(bench.rendering().cancelled()).as("once the loop has left the document before").isTrue();
    }

    @Test
    void recoveredDocument_isKeptUntilItIsSaved() throws Exception {
        var crashed = new Recovery(folder.resolve("kept"), "999999999999-1");
        Path file = Files.writeString(folder.resolve("lost.jen"), Desk.TEXT);
        crashed.keep(file, Desk.TEXT.replace("intensity 0.3", "intensity 0.9"));
        Recovery own = new Recovery(folder.resolve("kept"));
        Recovery.Found found = own.found().getFirst();
        bench.recover(found, OpenDocument.recover(found));
        assertThat(Desk.light(bench.document().scene(), "sun").intensity()).isEqualTo(0.9);
        Wait.until(() -> own.found().isEmpty());
        assertThat(filesKept()).isEqualTo(1);
        save(bench.document().file());
        Wait.until(() -> filesKept() == 0);
    }

    private void save(Path file) throws InterruptedException {
        failures.clear();
        bench.saveAs(file, Set.of(), failures::add);
        runUntil(() -> !failures.isEmpty());
        assertThat(failures).containsExactly(Optional.empty());
    }

    private long filesKept() throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve("kept"))) {
            return files.count();
        }
    }

    @Test
    void reload_startsOverAndRenders() throws Exception {
        dial(2);
        bench.reload(failures::add);
        runUntil(() -> failures.contains(Optional.empty()));
        settle();
        assertThat(shown()).isEqualTo(Desk.scene());
        assertThat(Command.RELOAD.isEnabled(bench.situation())).isFalse();
    }

    @Test
    void savedDocument_isCleanUnderItsNewName() throws Exception {
        dial(2);
        save(folder.resolve("other.jen"));
        dial(3);
        save(bench.document().file());
        assertThat(Command.SAVE_SCENE.isEnabled(bench.situation())).isFalse();
        assertThat(OpenDocument.open(folder.resolve("other.jen")).scene()).isEqualTo(bench.document().scene());
    }

    @Test
    void editMadeWhileItIsSaved_isNotSavedButNotLost() throws Exception {
        dial(2);
        bench.saveAs(bench.document().file(), Set.of(), failures::add);
        dial(3);
        runUntil(() -> !failures.isEmpty());
        assertThat(bench.situation().dirty()).isTrue();
        assertThat(Desk.light(bench.document().scene(), "key").intensity()).isEqualTo(3);
        assertThat(Desk.light(OpenDocument.open(bench.document().file()).scene(), "key").intensity()).isEqualTo(2);
    }

    @Test
    void saveAskedForDuringASave_writesWhatIsThereThen() throws Exception {
        dial(2);
        bench.saveAs(bench.document().file(), Set.of(), failures::add);
        dial(3);
        bench.saveAs(bench.document().file(), Set.of(), failures::add);
        assertThat(bench.isSaving()).isTrue();
        runUntil(() -> failures.size() == 2);
        assertThat(failures).as("the first is no change by somebody else").containsOnly(Optional.empty());
        assertThat(bench.isSaving()).isFalse();
        assertThat(bench.situation().dirty()).isFalse();
        assertThat(Desk.light(OpenDocument.open(bench.document().file()).scene(), "key").intensity()).isEqualTo(3);
    }

    @Test
    void saveThatFails_isToldAndTheEditsStay() throws Exception {
        dial(2);
        bench.saveAs(folder.resolve("nowhere/desk.jen"), Set.of(), failures::add);
        runUntil(() -> !failures.isEmpty());
        assertThat(failures.getFirst()).isPresent();
        assertThat(bench.situation().dirty()).isTrue();
        assertThat(bench.document().name()).isEqualTo("desk.jen");
    }

    @Test
    void everyChange_isTold() throws Exception {
        int before = changes;
        dial(2);
        bench.selectLight("key");
        bench.undo();
        bench.redo();
        assertThat(changes).isEqualTo(before + 4);
        bench.go();
        settle();
        assertThat(changes).isGreaterThan(before + 5);
    }

    @Test
    void refusedEdit_isNoChange() {
        int before = changes;
        assertThat(bench.edit(Desk.dial("angle").set(bench.document().scene(), "key", 999))).isPresent();
        assertThat(changes).isEqualTo(before);
    }

    @Test
    void shownFrameOfAnAnimation_isNotTheDocuments() throws Exception {
        Light away = Desk.light(bench.document().scene(), "key").withPosition(new Vec3(0, 9, 0));
        bench.setAnimating(true);
        bench.show(bench.document().scene().withLight(away));
        settle();
        assertThat(shown().light("key")).contains(away);
        assertThat(bench.document().scene()).isEqualTo(Desk.scene());
        assertThat(Command.UNDO.obstacle(bench.situation())).contains("an animation is open; close it first");
    }
}
