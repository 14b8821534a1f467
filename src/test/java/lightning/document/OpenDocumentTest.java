package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import lightning.base.file.ChangedFileException;
import lightning.base.file.FileState;
import lightning.base.file.ReadOnlyFileException;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class OpenDocumentTest {
    @TempDir
    private Path folder;

    private Path file;
    private OpenDocument document;

    @BeforeEach
    void open() throws Exception {
        file = Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT);
        document = OpenDocument.open(file);
    }

    private void setIntensity(String light, double intensity) {
        assertThat(document.apply(DeskScene.parameter("intensity").set(document.scene(), light, intensity))).isEmpty();
    }

    private Scene onDisk(Path place) throws IOException, JenException {
        return JenReader.read(place).scene();
    }

    @Test
    void openedDocument_isCleanAndNamedAfterFile() {
        assertThat(document.isDirty()).isFalse();
        assertThat(document.name()).isEqualTo("desk.jen");
        assertThat(document.selectedLight()).isEmpty();
    }

    @Test
    void edit_makesDirtyAndUndoCleans() {
        setIntensity("key", 2);
        assertThat(document.isDirty()).isTrue();
        document.history().undo();
        assertThat(document.isDirty()).isFalse();
    }

    @Test
    void refusedEdit_returnsReasonAndChangesNothing() {
        assertThat(document.apply(DeskScene.parameter("angle").set(document.scene(), "key", 200))).isPresent();
        assertThat(document.isDirty()).isFalse();
        assertThat(document.history().undoLabel()).isEmpty();
    }

    @Test
    void gesture_isOneStep() {
        Object drag = new Object();
        document.apply(DeskScene.parameter("intensity").set(document.scene(), "key", 2), drag);
        document.apply(DeskScene.parameter("intensity").set(document.scene(), "key", 3), drag);
        document.history().undo();
        assertThat(document.isDirty()).isFalse();
    }

    @Test
    void save_keepsCommentsAndUneditedText() throws Exception {
        setIntensity("key", 2);
        TestSaves.save(document);
        assertThat(document.isDirty()).isFalse();
        assertThat(Files.readString(file)).isEqualTo(DeskScene.TEXT.replace("spot { intensity 1 ", "spot { intensity 2 "));
    }

    @Test
    void undoAfterSavedDeletion_restoresLightWithKeys() throws Exception {
        String moving = DeskScene.TEXT + "\nshot {\n  frames 1 25\n  light key { intensity { 1 0.5  25 2.5 smooth } }\n}\n";
        document = OpenDocument.open(Files.writeString(file, moving));
        var before = document.content();
        document.apply(LightEdits.delete(document.scene(), "key"));
        TestSaves.save(document);
        assertThat(JenReader.read(file).shot().stream().flatMap(s -> s.tracks().stream())).isEmpty();
        document.history().undo();
        assertThat(document.content()).isEqualTo(before);
        TestSaves.save(document);
        assertThat(JenReader.read(file).animatedScene()).isEqualTo(before);
    }

    @Test
    void undoAfterSave_isDirtyAndSavesOldText() throws Exception {
        setIntensity("key", 2);
        TestSaves.save(document);
        document.history().undo();
        assertThat(document.isDirty()).isTrue();
        TestSaves.save(document);
        assertThat(Files.readString(file)).isEqualTo(DeskScene.TEXT);
    }

    @Test
    void saveAs_switchesFileAndKeepsOldFile() throws Exception {
        setIntensity("key", 2);
        Path other = folder.resolve("other.jen");
        TestSaves.saveAs(document, other);
        assertThat(document.file()).isEqualTo(other);
        assertThat(document.isDirty()).isFalse();
        assertThat(onDisk(other)).isEqualTo(document.scene());
        assertThat(Files.readString(file)).isEqualTo(DeskScene.TEXT);
    }

    @Test
    void saveAsWithoutTextures_isRefused() throws Exception {
        Path beside = Files.createDirectories(folder.resolve("a/b/c/d/textured"));
        Files.createDirectory(beside.resolve("textures"));
        Files.copy(Path.of("textures/wood.png"), beside.resolve("textures/wood.png"), StandardCopyOption.REPLACE_EXISTING);
        Path textured = Files.writeString(beside.resolve("t.jen"),
                DeskScene.TEXT.replace("material mirror {", "material mirror { texture \"wood.png\" "));
        OpenDocument open = OpenDocument.open(textured);
        Path away = folder.resolve("away.jen");
        assertThatIOException().isThrownBy(() -> TestSaves.saveAs(open, away))
                .withMessageStartingWith("the saved scene cannot be read: ").withMessageContaining("wood.png");
        assertThat(open.file()).isEqualTo(textured);
        assertThat(away).doesNotExist();
    }

    @Test
    void saveAsOfASceneWithMissingTextures_keepsTheirNames() throws Exception {
        Path textured = Files.writeString(folder.resolve("t.jen"),
                DeskScene.TEXT.replace("material mirror {", "material mirror { texture \"none.png\" "));
        OpenDocument open = OpenDocument.open(textured);
        Path away = folder.resolve("away.jen");
        TestSaves.saveAs(open, away);
        assertThat(away).hasContent(Files.readString(textured));
    }

    @Test
    void failedSave_keepsDirty() {
        setIntensity("key", 2);
        assertThatIOException().isThrownBy(() -> TestSaves.saveAs(document, folder.resolve("nowhere/desk.jen")));
        assertThat(document.isDirty()).isTrue();
        assertThat(document.file()).isEqualTo(file);
    }

    @Test
    void reload_canBeUndone() throws Exception {
        setIntensity("key", 2);
        Scene edited = document.scene();
        TestSaves.reload(document);
        assertThat(document.scene()).isEqualTo(DeskScene.scene());
        assertThat(document.isDirty()).isFalse();
        document.history().undo();
        assertThat(document.scene()).isEqualTo(edited);
    }

    @Test
    void reloadOfInvalidFile_keepsScene() throws Exception {
        setIntensity("key", 2);
        Scene edited = document.scene();
        Files.writeString(file, "jen 1\nligth");
        assertThatExceptionOfType(JenException.class).isThrownBy(() -> TestSaves.reload(document));
        assertThat(document.scene()).isEqualTo(edited);
        assertThat(document.isDirty()).isTrue();
    }

    /** Sets the disk state as a watch does. */
    private void checkDisk() throws IOException {
        document.setDiskStatus(new DiskStatus(document.file(), document.knownState(), FileState.of(document.file()), false));
    }

    @Test
    void externalChange_isReportedUntilReloadOrSave() throws Exception {
        checkDisk();
        assertThat(document.isChangedOnDisk()).isFalse();
        Files.writeString(file, DeskScene.TEXT + "# his\n");
        checkDisk();
        assertThat(document.isChangedOnDisk()).isTrue();
        TestSaves.reload(document);
        assertThat(document.isChangedOnDisk()).isFalse();
        setIntensity("key", 2);
        TestSaves.save(document);
        checkDisk();
        assertThat(document.isChangedOnDisk()).isFalse();
    }

    /** Keeps the neighbor selected after its edit, so that undo does not change the selection. */
    @Test
    void editedNeighbor_staysSelected() {
        List<String> names = document.scene().lights().stream().map(Light::name).toList();
        document.selectLight(names.getFirst());
        document.apply(LightEdits.delete(document.scene(), names.getFirst()));
        assertThat(document.selectedLight()).map(Light::name).contains(names.get(1));
        document.apply(LightEdits.delete(document.scene(), names.get(2)));
        document.history().undo();
        document.history().undo();
        assertThat(document.selectedLight()).map(Light::name).contains(names.get(1));
    }

    @Test
    void outdatedDiskStatus_isIgnored() throws Exception {
        DiskStatus old = new DiskStatus(file, document.knownState(), FileState.MISSING, false);
        setIntensity("key", 2);
        TestSaves.save(document);
        document.setDiskStatus(old);
        assertThat(document.isChangedOnDisk()).isFalse();
    }

    @Test
    void save_overwritesExternalChangeOnlyIfConfirmed() throws Exception {
        setIntensity("key", 2);
        Files.writeString(file, DeskScene.TEXT + "# his\n");
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> TestSaves.save(document));
        assertThat(file).hasContent(DeskScene.TEXT + "# his\n");
        assertThat(document.isDirty()).isTrue();
        TestSaves.save(document, OverwriteConfirmation.OVERWRITE_CHANGED);
        assertThat(onDisk(file)).isEqualTo(document.scene());
        setIntensity("key", 3);
        TestSaves.save(document);
        assertThat(onDisk(file)).isEqualTo(document.scene());
    }

    @Test
    void saveAsToOwnFile_isSave() throws Exception {
        setIntensity("key", 2);
        Files.writeString(file, DeskScene.TEXT + "# his\n");
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> TestSaves.saveAs(document, file));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void readOnlyFile_isReplacedOnlyIfConfirmed() throws Exception {
        setIntensity("key", 2);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("r--r--r--"));
        assertThatExceptionOfType(ReadOnlyFileException.class).isThrownBy(() -> TestSaves.save(document));
        assertThat(file).hasContent(DeskScene.TEXT);
        TestSaves.save(document, OverwriteConfirmation.REPLACE_READ_ONLY);
        assertThat(onDisk(file)).isEqualTo(document.scene());
    }

    @Test
    void deletedFile_makesDirtyAndIsRewritten() throws Exception {
        Files.delete(file);
        checkDisk();
        assertThat(document.isDirty()).isTrue();
        TestSaves.save(document);
        assertThat(document.isDirty()).isFalse();
        assertThat(file).hasContent(DeskScene.TEXT);
    }

    @Test
    void ignoredDiskChange_isDirtyAndStillNeedsConfirmation() throws Exception {
        Files.writeString(file, DeskScene.TEXT + "# his\n");
        checkDisk();
        assertThat(document.isDirty()).isFalse();
        document.ignoreDiskChange();
        assertThat(document.isDirty()).isTrue();
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> TestSaves.save(document));
        TestSaves.save(document, OverwriteConfirmation.OVERWRITE_CHANGED);
        assertThat(document.isDirty()).isFalse();
    }

    /** Stores an unsaved text as a crashed process whose file is in its present state. */
    private RecoveryFolder.RecoverableScene crash(String text) throws IOException {
        new RecoveryFolder(folder.resolve("kept"), "999999999999-1").store(file, FileState.of(file), text);
        return found();
    }

    private RecoveryFolder.RecoverableScene found() throws IOException {
        return new RecoveryFolder(folder.resolve("kept")).list().getFirst();
    }

    private OpenDocument recover(String text) throws IOException, JenException {
        return OpenDocument.recover(crash(text));
    }

    @Test
    void recoveryOfUnchangedFile_savesWithoutConfirmation() throws Exception {
        OpenDocument back = recover(DeskScene.TEXT.replace("intensity 0.3", "intensity 0.9"));
        TestSaves.save(back);
        assertThat(DeskScene.light(onDisk(file), "sun").intensity()).isEqualTo(0.9);
        assertThat(back.isDirty()).isFalse();
    }

    @Test
    void recoveryOfFileChangedSince_needsConfirmationToOverwrite() throws Exception {
        crash(DeskScene.TEXT.replace("intensity 0.3", "intensity 0.9"));
        String theirs = DeskScene.TEXT.replace("intensity 0.3", "intensity 0.7");
        Files.writeString(file, theirs);
        assertThat(found().disk().isChanged()).isTrue();
        OpenDocument back = OpenDocument.recover(found());
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> TestSaves.save(back));
        assertThat(file).hasContent(theirs);
        TestSaves.save(back, OverwriteConfirmation.OVERWRITE_CHANGED);
        assertThat(DeskScene.light(onDisk(file), "sun").intensity()).isEqualTo(0.9);
    }

    @Test
    void secondRecoveryOfOneFile_needsConfirmationToOverwriteTheFirst() throws Exception {
        new RecoveryFolder(folder.resolve("kept"), "999999999998-1").store(file, FileState.of(file), DeskScene.TEXT + "# older\n");
        TestSaves.save(recover(DeskScene.TEXT.replace("intensity 0.3", "intensity 0.9")));
        List<RecoveryFolder.RecoverableScene> all = new RecoveryFolder(folder.resolve("kept")).list();
        assertThat(all).hasSize(2).allSatisfy(scene -> assertThat(scene.disk().isChanged()).isTrue());
        OpenDocument older = OpenDocument.recover(all.stream().filter(scene -> scene.text().contains("older")).findFirst().orElseThrow());
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> TestSaves.save(older));
    }

    @Test
    void recoveryOfInvalidFile_needsConfirmationToOverwrite() throws Exception {
        Files.writeString(file, "jen 1\nligth");
        OpenDocument back = recover(DeskScene.TEXT);
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> TestSaves.save(back));
        assertThat(file).hasContent("jen 1\nligth");
    }

    @Test
    void selection_survivesRename() {
        document.selectLight("key");
        document.apply(LightEdits.rename(document.scene(), "key", "rim"));
        assertThat(document.selectedLight()).map(Light::name).contains("rim");
        document.history().undo();
        assertThat(document.selectedLight()).map(Light::name).contains("key");
        document.select(Selection.NONE);
        assertThat(document.selectedLight()).isEmpty();
    }

    @Test
    void recoveredEdits_areOneStep() throws Exception {
        setIntensity("key", 2);
        String kept = document.text(document.content());
        OpenDocument back = recover(kept);
        assertThat(back.scene()).isEqualTo(document.scene());
        assertThat(back.isDirty()).isTrue();
        back.history().undo();
        assertThat(back.scene()).isEqualTo(DeskScene.scene());
    }

    @Test
    void recoveredWithoutFile_isDirty() throws Exception {
        Files.delete(file);
        OpenDocument back = recover(DeskScene.TEXT);
        assertThat(back.scene()).isEqualTo(DeskScene.scene());
        assertThat(back.isDirty()).isTrue();
        TestSaves.save(back);
        assertThat(back.isDirty()).isFalse();
        assertThat(onDisk(file)).isEqualTo(DeskScene.scene());
    }
}
