package lightning.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIOException;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Set;
import lightning.editor.Command;
import lightning.editor.EditorState;
import lightning.format.jen.JenReader;
import lightning.scene.AntialiasMode;
import lightning.scene.Scene;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Documents without a file of their own: new scenes and copies. */
class UntitledDocumentTest {
    @TempDir
    private Path folder;

    private static EditorState state(OpenDocument document) {
        return EditorState.of(document);
    }

    /** Arbor has cutouts, stage gobos, product meshes, window an environment. */
    @ParameterizedTest
    @ValueSource(strings = {"arbor", "stage", "product", "window"})
    void copy_saved_opensAsTheSameScene(String name) throws Exception {
        OpenDocument copy = OpenDocument.openCopy(Path.of("scenes", name + ".jen"));
        assertThat(copy.isDirty()).isFalse();
        Path target = folder.resolve("mine.jen");
        SavedScene saved = copy.prepareSave(target, Set.of()).write();
        copy.onSaved(saved);
        assertThat(copy.isUntitled()).isFalse();
        assertThat(copy.file()).isEqualTo(target);
        assertThat(JenReader.read(target).scene()).isEqualTo(copy.scene());
    }

    @Test
    void copy_isNotSavedOverItsSource() throws Exception {
        Path file = Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT);
        OpenDocument copy = OpenDocument.openCopy(file);
        assertThat(copy.apply(DeskScene.parameter("intensity").set(copy.scene(), "key", 0.25))).isEmpty();
        assertThat(copy.isDirty()).isTrue();
        SaveRequest save = copy.prepareSave(file, EnumSet.allOf(OverwriteConfirmation.class));
        assertThatIOException().isThrownBy(save::write).withMessageContaining("choose another file");
        assertThat(file).hasContent(DeskScene.TEXT);
    }

    @Test
    void copiedFiles_replaceNoOther() throws Exception {
        Path other = Files.writeString(Files.createDirectories(folder.resolve("textures")).resolve("wood.png"), "mine");
        OpenDocument copy = OpenDocument.openCopy(Path.of("scenes/stage.jen"));
        assertThatIOException().isThrownBy(copy.prepareSave(folder.resolve("mine.jen"), Set.of())::write).withMessageContaining("wood.png");
        assertThat(other).hasContent("mine");
        assertThat(folder.resolve("mine.jen")).doesNotExist();
    }

    @Test
    void shippedScene_opensAsCopyAndIsNeverATarget() throws Exception {
        Path scenes = Files.createDirectories(folder.resolve("program/scenes"));
        Path shipped = Files.writeString(scenes.resolve("desk.jen"), DeskScene.TEXT);
        Path own = Files.writeString(folder.resolve("own.jen"), DeskScene.TEXT);
        String before = System.getProperty("lightning.home");
        System.setProperty("lightning.home", folder.resolve("program").toString());
        try {
            assertThat(OpenDocument.open(shipped).isUntitled()).isTrue();
            OpenDocument document = OpenDocument.open(own);
            assertThat(document.isUntitled()).isFalse();
            SaveRequest save = document.prepareSave(scenes.resolve("new.jen"), Set.of());
            assertThatIOException().isThrownBy(save::write).withMessageContaining("comes with Lightning");
        } finally {
            if (before == null) {
                System.clearProperty("lightning.home");
            } else {
                System.setProperty("lightning.home", before);
            }
        }
    }

    @Test
    void untitled_canBeSavedWithoutEdits() throws Exception {
        assertThat(Command.SAVE_SCENE.disabledReason(state(NewScene.create(PictureArea.DEFAULT)))).isEmpty();
        Path file = Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT);
        assertThat(Command.SAVE_SCENE.disabledReason(state(OpenDocument.open(file)))).isPresent();
    }

    @Test
    void newScene_isStudioWithSoftLights() {
        Scene scene = NewScene.create(new PictureArea(500, 400)).scene();
        assertThat(scene.picture().width()).isEqualTo(500);
        assertThat(scene.picture().height()).isEqualTo(281);
        assertThat(scene.picture().sampling().antialias()).isEqualTo(AntialiasMode.EDGES);
        assertThat(scene.lights()).extracting(light -> light.name() + " " + light.type()).containsExactly("key " + LightType.RECT,
                "fill " + LightType.RECT, "rim " + LightType.RECT, "sky " + LightType.DIRECTIONAL);
        assertThat(scene.lights().getLast().area().spread()).isPositive();
    }

    @Test
    void fittedCopy_isNotDirtyAndKeepsAspect() throws Exception {
        OpenDocument copy = OpenDocument.openCopy(Path.of("scenes/stage.jen")).fittedTo(new PictureArea(1001, 2000));
        assertThat(copy.isDirty()).isFalse();
        assertThat(copy.isUntitled()).isTrue();
        assertThat(copy.scene().picture().width()).isEqualTo(1001);
        assertThat(copy.scene().picture().height()).isEqualTo(563);
        assertThat(copy.title()).isEqualTo("Copy of stage.jen");
    }

    @Test
    void areaOfHiddenPane_isTheDefault() {
        assertThat(PictureArea.of(0, 400)).isEqualTo(PictureArea.DEFAULT);
    }
}
