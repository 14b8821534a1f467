package lightning.editor.document;

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
import lightning.scene.Light;
import lightning.scene.Scene;
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
        file = Files.writeString(folder.resolve("desk.jen"), Desk.TEXT);
        document = OpenDocument.open(file);
    }

    private void dial(String light, double intensity) {
        assertThat(document.apply(Desk.dial("intensity").set(document.scene(), light, intensity))).isEmpty();
    }

    private Scene onDisk(Path place) throws IOException, JenException {
        return JenReader.read(place).scene();
    }

    @Test
    void openedDocument_isCleanAndNamedByItsFile() {
        assertThat(document.isDirty()).isFalse();
        assertThat(document.name()).isEqualTo("desk.jen");
        assertThat(document.selectedLight()).isEmpty();
    }

    @Test
    void edit_makesItDirtyAndUndoCleanAgain() {
        dial("key", 2);
        assertThat(document.isDirty()).isTrue();
        document.history().undo();
        assertThat(document.isDirty()).isFalse();
    }

    @Test
    void refusedEdit_givesTheReasonAndChangesNothing() {
        assertThat(document.apply(Desk.dial("angle").set(document.scene(), "key", 200))).isPresent();
        assertThat(document.isDirty()).isFalse();
        assertThat(document.history().undoLabel()).isEmpty();
    }

    @Test
    void gesture_isOneStep() {
        Object drag = new Object();
        document.apply(Desk.dial("intensity").set(document.scene(), "key", 2), drag);
        document.apply(Desk.dial("intensity").set(document.scene(), "key", 3), drag);
        document.history().undo();
        assertThat(document.isDirty()).isFalse();
    }

    @Test
    void save_keepsCommentsAndChangesOnlyWhatWasEdited() throws Exception {
        dial("key", 2);
        Saves.save(document);
        assertThat(document.isDirty()).isFalse();
        assertThat(Files.readString(file)).isEqualTo(Desk.TEXT.replace("spot { intensity 1 ", "spot { intensity 2 "));
    }

    @Test
    void undoAfterSavingADeletion_bringsTheLightBackWithItsKeys() throws Exception {
        String moving = Desk.TEXT + "\nshot {\n  frames 1 25\n  light key { intensity { 1 0.5  25 2.5 smooth } }\n}\n";
        document = OpenDocument.open(Files.writeString(file, moving));
        var before = document.content();
        document.apply(LightEdits.delete(document.scene(), "key"));
        Saves.save(document);
        assertThat(JenReader.read(file).shot().stream().flatMap(s -> s.tracks().stream())).isEmpty();
        document.history().undo();
        assertThat(document.content()).isEqualTo(before);
        Saves.save(document);
        assertThat(JenReader.read(file).content()).isEqualTo(before);
    }

    @Test
    void undoAfterSaving_isDirtyAndSavesTheOldTextAgain() throws Exception {
        dial("key", 2);
        Saves.save(document);
        document.history().undo();
        assertThat(document.isDirty()).isTrue();
        Saves.save(document);
        assertThat(Files.readString(file)).isEqualTo(Desk.TEXT);
    }

    @Test
    void saveAs_movesTheDocumentAndLeavesTheOldFile() throws Exception {
        dial("key", 2);
        Path other = folder.resolve("other.jen");
        Saves.saveAs(document, other);
        assertThat(document.file()).isEqualTo(other);
        assertThat(document.isDirty()).isFalse();
        assertThat(onDisk(other)).isEqualTo(document.scene());
        assertThat(Files.readString(file)).isEqualTo(Desk.TEXT);
    }

    @Test
    void saveAsAwayFromTheTextures_isRefusedAndChangesNothing() throws Exception {
        Path beside = Files.createDirectories(folder.resolve("a/b/c/d/textured"));
        Files.createDirectory(beside.resolve("textures"));
        Files.copy(Path.of("textures/wood.png"), beside.resolve("textures/wood.png"), StandardCopyOption.REPLACE_EXISTING);
        Path textured = Files.writeString(beside.resolve("t.jen"),
                Desk.TEXT.replace("material mirror {", "material mirror { texture \"wood.png\" "));
        OpenDocument open = OpenDocument.open(textured);
        Path away = folder.resolve("away.jen");
        assertThatIOException().isThrownBy(() -> Saves.saveAs(open, away))
                .withMessageStartingWith("the scene cannot be read from there: ").withMessageContaining("wood.png");
        assertThat(open.file()).isEqualTo(textured);
        assertThat(away).doesNotExist();
    }

    @Test
    void failedSave_leavesItDirty() {
        dial("key", 2);
        assertThatIOException().isThrownBy(() -> Saves.saveAs(document, folder.resolve("nowhere/desk.jen")));
        assertThat(document.isDirty()).isTrue();
        assertThat(document.file()).isEqualTo(file);
    }

    @Test
    void reload_startsOverAndCanBeUndone() throws Exception {
        dial("key", 2);
        Scene edited = document.scene();
        Saves.reload(document);
        assertThat(document.scene()).isEqualTo(Desk.scene());
        assertThat(document.isDirty()).isFalse();
        document.history().undo();
        assertThat(document.scene()).isEqualTo(edited);
    }

    @Test
    void reloadOfAWrongFile_keepsTheOpenScene() throws Exception {
        dial("key", 2);
        Scene edited = document.scene();
        Files.writeString(file, "jen 1\nligth");
        assertThatExceptionOfType(JenException.class).isThrownBy(() -> Saves.reload(document));
        assertThat(document.scene()).isEqualTo(edited);
        assertThat(document.isDirty()).isTrue();
    }

    /** What a watch would tell. */
    private void look() throws IOException {
        document.hear(new DiskNews(document.file(), document.known(), FileState.of(document.file()), false));
    }

    @Test
    void fileWrittenByOthers_isChangedUntilItIsReadOrWritten() throws Exception {
        look();
        assertThat(document.isChangedOnDisk()).isFalse();
        Files.writeString(file, Desk.TEXT + "# his\n");
        look();
        assertThat(document.isChangedOnDisk()).isTrue();
        Saves.reload(document);
        assertThat(document.isChangedOnDisk()).isFalse();
        dial("key", 2);
        Saves.save(document);
        look();
        assertThat(document.isChangedOnDisk()).isFalse();
    }

    /** So that undo of that edit does not jump away from what was edited. */
    @Test
    void neighbourThatIsEdited_staysSelected() {
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
    void newsOfBeforeTheLastSave_isNotTaken() throws Exception {
        DiskNews old = new DiskNews(file, document.known(), FileState.NONE, false);
        dial("key", 2);
        Saves.save(document);
        document.hear(old);
        assertThat(document.isChangedOnDisk()).isFalse();
    }

    @Test
    void save_doesNotOverwriteWhatOthersWroteUnlessItMay() throws Exception {
        dial("key", 2);
        Files.writeString(file, Desk.TEXT + "# his\n");
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> Saves.save(document));
        assertThat(file).hasContent(Desk.TEXT + "# his\n");
        assertThat(document.isDirty()).isTrue();
        Saves.save(document, Consent.OVERWRITE_CHANGED);
        assertThat(onDisk(file)).isEqualTo(document.scene());
        dial("key", 3);
        Saves.save(document);
        assertThat(onDisk(file)).isEqualTo(document.scene());
    }

    @Test
    void saveAsToItsOwnFile_isASave() throws Exception {
        dial("key", 2);
        Files.writeString(file, Desk.TEXT + "# his\n");
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> Saves.saveAs(document, file));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void readOnlyFile_isReplacedOnlyIfItMay() throws Exception {
        dial("key", 2);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("r--r--r--"));
        assertThatExceptionOfType(ReadOnlyFileException.class).isThrownBy(() -> Saves.save(document));
        assertThat(file).hasContent(Desk.TEXT);
        Saves.save(document, Consent.REPLACE_READ_ONLY);
        assertThat(onDisk(file)).isEqualTo(document.scene());
    }

    @Test
    void fileThatIsGone_leavesTheDocumentUnsavedAndIsWrittenAgain() throws Exception {
        Files.delete(file);
        look();
        assertThat(document.isDirty()).isTrue();
        Saves.save(document);
        assertThat(document.isDirty()).isFalse();
        assertThat(file).hasContent(Desk.TEXT);
    }

    @Test
    void keptAgainstAnothersText_isUnsavedAndStillAsksBeforeItOverwrites() throws Exception {
        Files.writeString(file, Desk.TEXT + "# his\n");
        look();
        assertThat(document.isDirty()).isFalse();
        document.keepAgainstNews();
        assertThat(document.isDirty()).isTrue();
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> Saves.save(document));
        Saves.save(document, Consent.OVERWRITE_CHANGED);
        assertThat(document.isDirty()).isFalse();
    }

    @Test
    void recoveredInPlaceOfAWrongFile_doesNotOverwriteItUnasked() throws Exception {
        Files.writeString(file, "jen 1\nligth");
        OpenDocument back = OpenDocument.recover(new Recovery.Found(folder.resolve("x"), file, Desk.TEXT));
        assertThatExceptionOfType(ChangedFileException.class).isThrownBy(() -> Saves.save(back));
        assertThat(file).hasContent("jen 1\nligth");
    }

    @Test
    void selection_isTheLightWhateverItsNameIs() {
        document.selectLight("key");
        document.apply(LightEdits.rename(document.scene(), "key", "rim"));
        assertThat(document.selectedLight()).map(Light::name).contains("rim");
        document.history().undo();
        assertThat(document.selectedLight()).map(Light::name).contains("key");
        document.select(Selection.NONE);
        assertThat(document.selectedLight()).isEmpty();
    }

    @Test
    void recovered_theEditsAreOneStepOverTheFile() throws Exception {
        dial("key", 2);
        String kept = document.text(document.content());
        OpenDocument back = OpenDocument.recover(new Recovery.Found(folder.resolve("x"), file, kept));
        assertThat(back.scene()).isEqualTo(document.scene());
        assertThat(back.isDirty()).isTrue();
        back.history().undo();
        assertThat(back.scene()).isEqualTo(Desk.scene());
    }

    @Test
    void recoveredWithoutItsFile_isStillUnsaved() throws Exception {
        Files.delete(file);
        OpenDocument back = OpenDocument.recover(new Recovery.Found(folder.resolve("x"), file, Desk.TEXT));
        assertThat(back.scene()).isEqualTo(Desk.scene());
        assertThat(back.isDirty()).isTrue();
        Saves.save(back);
        assertThat(back.isDirty()).isFalse();
        assertThat(onDisk(file)).isEqualTo(Desk.scene());
    }
}
