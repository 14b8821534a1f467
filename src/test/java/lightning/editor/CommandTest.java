package lightning.editor;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.file.FileState;
import lightning.base.math.Vec3;
import lightning.base.work.Progress;
import lightning.document.AttributeNumber;
import lightning.document.DeskScene;
import lightning.document.DiskStatus;
import lightning.document.EditOutcome;
import lightning.document.LightEdits;
import lightning.document.OpenDocument;
import lightning.document.Selection;
import lightning.document.TestSaves;
import lightning.document.loop.DisplayMode;
import lightning.document.loop.Frame;
import lightning.document.loop.RenderState;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.relight.paper.ReflectionMode;
import lightning.sample.TransparentScenes;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that commands are enabled exactly when applicable, in a session with real images. */
class CommandTest {
    @TempDir
    private Path folder;

    private final Renderer renderer = new Renderer(RenderOptions.DEFAULT.withReflections(ReflectionMode.STALE).withThreads(1));
    private OpenDocument document;
    private Optional<Frame> frame = Optional.empty();

    @BeforeEach
    void open() throws Exception {
        document = OpenDocument.open(Files.writeString(folder.resolve("desk.jen"), DeskScene.TEXT));
    }

    @AfterEach
    void close() {
        renderer.close();
    }

    private void go() {
        var update = renderer.render(document.scene(), Progress.NONE);
        frame = Optional
                .of(new Frame(renderer.film(), renderer.film(), DisplayMode.FULL_PICTURE, renderer.scene(),
                        renderer.cache().mirrored().scene(), update,
                        renderer.cache().geometry(), null, Frame.Step.ALL_LIGHT, renderer.state().isFinished()));
    }

    private void updateReflections() {
        var update = renderer.updateReflections(Progress.NONE);
        frame = Optional
                .of(new Frame(renderer.film(), renderer.film(), DisplayMode.FULL_PICTURE, renderer.scene(),
                        renderer.cache().mirrored().scene(), update,
                        renderer.cache().geometry(), null, Frame.Step.ALL_LIGHT, renderer.state().isFinished()));
    }

    private EditorState editorState() {
        return EditorState.of(document).withImage(frame.map(RenderState.NONE::withFrame).orElse(RenderState.NONE));
    }

    private void setIntensity(double intensity) {
        document.apply(DeskScene.parameter("intensity").set(document.scene(), "key", intensity));
    }

    private void assertDisabled(Command command, String reason) {
        assertThat(command.disabledReason(editorState())).contains(reason);
        assertThat(command.isEnabled(editorState())).isFalse();
    }

    private void assertEnabled(Command command) {
        assertThat(command.disabledReason(editorState())).isEmpty();
        assertThat(command.isEnabled(editorState())).isTrue();
    }

    @Test
    void go_isEnabledUntilPictureShowsScene() {
        assertEnabled(Command.GO);
        go();
        assertDisabled(Command.GO, "nothing to render");
        setIntensity(2);
        assertEnabled(Command.GO);
    }

    @Test
    void undoAfterGo_leavesGoEnabled() {
        go();
        setIntensity(2);
        go();
        document.history().undo();
        assertEnabled(Command.GO);
    }

    @Test
    void undoBeforeGo_leavesNothingToRender() {
        go();
        setIntensity(2);
        document.history().undo();
        assertDisabled(Command.GO, "nothing to render");
    }

    @Test
    void invisibleEdits_leaveNothingToRender() {
        go();
        document.apply(LightEdits.edit(document.scene(), "sun", l -> l.withPosition(new Vec3(9, 9, 9))));
        document.apply(LightEdits.rename(document.scene(), "key", "rim"));
        assertDisabled(Command.GO, "nothing to render");
        assertThat(document.isDirty()).isTrue();
    }

    @Test
    void go_isDisabledWhileSceneIsRendering() {
        go();
        setIntensity(2);
        assertThat(Command.GO.disabledReason(editorState().withSceneInProgress(Optional.of(document.scene()))))
                .contains("rendering is in progress");
        Scene older = document.scene();
        setIntensity(3);
        assertThat(Command.GO.disabledReason(editorState().withSceneInProgress(Optional.of(older)))).isEmpty();
    }

    @Test
    void go_rendersMissingSamples() {
        go();
        frame = frame.map(
                f -> new Frame(f.film(), f.displayed(), f.displayMode(), f.scene(), f.mirroredScene(), f.update(), f.geometry(),
                        f.indirect(), f.step(), false));
        assertEnabled(Command.GO);
        assertThat(editorState().pendingMessage()).contains("the image is not anti-aliased yet");
        assertThat(Command.GO.disabledReason(editorState().withSceneInProgress(Optional.of(document.scene()))))
                .contains("rendering is in progress");
    }

    @Test
    void updateReflections_isEnabledWhileMirrorsAreStale() {
        assertDisabled(Command.UPDATE_REFLECTIONS, "nothing is rendered yet");
        go();
        assertDisabled(Command.UPDATE_REFLECTIONS, "reflections are up to date");
        setIntensity(2);
        assertDisabled(Command.UPDATE_REFLECTIONS, "reflections are up to date");
        go();
        assertEnabled(Command.UPDATE_REFLECTIONS);
        updateReflections();
        assertDisabled(Command.UPDATE_REFLECTIONS, "reflections are up to date");
    }

    @Test
    void updateReflectionsWithoutMirrors_isDisabled() {
        document.apply(AttributeNumber.DEPTH.set(document.scene(), "", 0));
        go();
        setIntensity(2);
        go();
        assertDisabled(Command.UPDATE_REFLECTIONS, "no visible object is reflective or transparent");
    }

    @ParameterizedTest
    @ValueSource(strings = {TransparentScenes.BALL, TransparentScenes.PANE})
    void updateReflections_isEnabledWhileClearShapesAreStale(String text) throws Exception {
        document = OpenDocument.open(Files.writeString(folder.resolve("clear.jen"), text));
        go();
        document.apply(DeskScene.parameter("intensity").set(document.scene(), "lamp", 2));
        go();
        assertEnabled(Command.UPDATE_REFLECTIONS);
        assertThat(editorState().staleMirrorsMessage()).isPresent();
        updateReflections();
        assertDisabled(Command.UPDATE_REFLECTIONS, "reflections are up to date");
        assertThat(editorState().staleMirrorsMessage()).isEmpty();
    }

    @Test
    void undoAndRedo_areEnabledIfStepsExist() {
        assertDisabled(Command.UNDO, "nothing to undo");
        assertDisabled(Command.REDO, "nothing to redo");
        setIntensity(2);
        assertEnabled(Command.UNDO);
        go();
        assertEnabled(Command.UNDO);
        document.history().undo();
        assertDisabled(Command.UNDO, "nothing to undo");
        assertEnabled(Command.REDO);
    }

    @Test
    void undoLight_appliesToSelectedLight() {
        setIntensity(2);
        assertDisabled(Command.UNDO_LIGHT, "no light is selected");
        document.selectLight("fill");
        assertDisabled(Command.UNDO_LIGHT, "nothing to undo for this light");
        document.selectLight("key");
        assertEnabled(Command.UNDO_LIGHT);
        assertDisabled(Command.REDO_LIGHT, "nothing to redo for this light");
        document.history().undoLight(document.history().id("key"));
        assertEnabled(Command.REDO_LIGHT);
        assertDisabled(Command.UNDO_LIGHT, "nothing to undo for this light");
    }

    @Test
    void reloadAndSave_areEnabledWithUnsavedEdits() throws Exception {
        assertDisabled(Command.RELOAD, "no unsaved changes");
        assertDisabled(Command.SAVE_SCENE, "nothing to save");
        setIntensity(2);
        assertEnabled(Command.RELOAD);
        assertEnabled(Command.SAVE_SCENE);
        TestSaves.save(document);
        assertDisabled(Command.RELOAD, "no unsaved changes");
        assertDisabled(Command.SAVE_SCENE, "nothing to save");
    }

    @Test
    void externallyChangedFile_canBeReloaded() throws Exception {
        Files.writeString(document.file(), DeskScene.TEXT + "# theirs\n");
        document.setDiskStatus(new DiskStatus(document.file(), document.knownState(), FileState.of(document.file()), false));
        assertEnabled(Command.RELOAD);
    }

    @Test
    void loadAndSaveAs_areAlwaysEnabled() {
        assertEnabled(Command.LOAD_FILE);
        assertEnabled(Command.SAVE_SCENE_AS);
    }

    @Test
    void saveImage_needsPictureAndReportsPendingEdits() {
        assertDisabled(Command.SAVE_IMAGE, "nothing is rendered yet");
        go();
        assertEnabled(Command.SAVE_IMAGE);
        assertThat(editorState().pendingMessage()).isEmpty();
        setIntensity(2);
        assertEnabled(Command.SAVE_IMAGE);
        assertThat(editorState().pendingMessage()).contains("the image is out of date");
    }

    @Test
    void verify_needsAPicture() {
        assertDisabled(Command.VERIFY, "nothing is rendered yet");
        go();
        assertEnabled(Command.VERIFY);
    }

    @Test
    void cancel_needsRunningJob() {
        assertDisabled(Command.CANCEL, "nothing is running");
        assertThat(Command.CANCEL.isEnabled(editorState().withVerifying(true))).isTrue();
        assertThat(Command.CANCEL.isEnabled(editorState().withSceneInProgress(Optional.of(document.scene())))).isTrue();
    }

    @Test
    void lightCommands_needSelectedLight() {
        for (Command command : List.of(Command.DELETE_LIGHT, Command.DUPLICATE_LIGHT, Command.RENAME_LIGHT, Command.CHANGE_TYPE,
                Command.SWITCH_ON, Command.SOLO, Command.COPY_SETTINGS, Command.LOOK_THROUGH_LIGHT, Command.AIM)) {
            document.select(Selection.NONE);
            assertDisabled(command, "no light is selected");
            document.selectLight("key");
            assertEnabled(command);
        }
    }

    @Test
    void addLight_isEnabledUntilSceneIsFull() {
        go();
        setIntensity(2);
        assertEnabled(Command.ADD_LIGHT);
        List<Light> many = new ArrayList<>();
        for (int i = 0; i < SceneLimits.MAX_LIGHTS; i++) {
            many.add(Light.of("l" + i, LightType.POINT));
        }
        document.apply(new EditOutcome.Applied(document.scene().withLights(many)));
        document.selectLight("l0");
        assertDisabled(Command.ADD_LIGHT, "a scene can have at most 1000 lights");
        assertDisabled(Command.DUPLICATE_LIGHT, "a scene can have at most 1000 lights");
    }

    @Test
    void pasteSettings_needsCopiedSettings() {
        document.selectLight("key");
        assertDisabled(Command.PASTE_SETTINGS, "no settings are copied");
        assertThat(Command.PASTE_SETTINGS.isEnabled(editorState().withCopiedLight(document.selectedLight()))).isTrue();
    }

    @Test
    void aim_needsLightWithDirection() {
        document.selectLight("fill");
        assertDisabled(Command.AIM, "a point light has no direction");
    }

    @Test
    void makeAnimation_needsSelectedLight() {
        assertDisabled(Command.MAKE_ANIMATION, "no light is selected");
        document.selectLight("key");
        assertEnabled(Command.MAKE_ANIMATION);
    }
}
