package lightning.editor.window;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javafx.application.Platform;
import javafx.scene.control.Button;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.Menu;
import javafx.scene.control.MenuBar;
import javafx.scene.input.Clipboard;
import javafx.stage.Stage;
import javafx.stage.Window;
import javafx.stage.WindowEvent;
import lightning.base.file.FileState;
import lightning.document.DeskScene;
import lightning.document.FileThread;
import lightning.document.OpenDocument;
import lightning.document.PictureArea;
import lightning.document.RecoveryFolder;
import lightning.editor.Command;
import lightning.editor.window.model.AccuracyMode;
import lightning.editor.window.model.EditorModel;
import lightning.editor.window.model.Preferences;
import lightning.editor.window.model.StatusMessage;
import lightning.editor.window.model.WorkingSize;
import lightning.editor.window.widget.PictureView;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrReader;
import lightning.format.gltf.GltfFixtures;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.jen.Problem;
import lightning.render.image.DisplayCurve;
import lightning.render.image.ViewTransform;
import lightning.render.relight.SceneView;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.scene.AntialiasMode;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;

class FilesTest extends EditorFixture {

    private void dim() {
        robot.interact(() -> model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25)));
    }

    /** Starts a command without waiting for it, because it may wait for an answer. */
    private void startCommand(Command command) {
        Platform.runLater(() -> model().commands().run(command));
    }

    private boolean isMessageShown(String text) {
        return robot.lookup(text).tryQuery().isPresent();
    }

    @Test
    void saveScene_writesFileAndIsDisabledAfterwards() throws IOException, JenException {
        dim();
        assertThat(stage.getTitle()).startsWith("•");
        click("save-scene");
        waitFor("the scene is saved", () -> text("message").equals("Saved desk.jen"));
        assertThat(isEnabled(Command.SAVE_SCENE)).isFalse();
        assertThat(stage.getTitle()).startsWith("desk.jen");
        assertThat(JenReader.read(folder.resolve("desk.jen")).scene()).isEqualTo(model().editor().scene());
    }

    @Test
    void failedSave_offersAnotherFile() throws IOException {
        dim();
        Files.delete(folder.resolve("desk.jen"));
        Files.createDirectories(folder.resolve("desk.jen/full"));
        answer = folder.resolve("rescued.jen");
        startCommand(Command.SAVE_SCENE);
        waitFor("the failure is shown", () -> isMessageShown("The scene could not be saved"));
        robot.clickOn("Save As…");
        waitFor("the scene is saved", () -> text("message").equals("Saved rescued.jen"));
        assertThat(model().editor().document().isDirty()).isFalse();
    }

    private Path crash(String name, String process) throws IOException {
        Path recovery = EditorPaths.dataFolder().resolve("recovery");
        Path file = Files.writeString(folder.resolve(name), sceneText());
        Files.createDirectories(recovery);
        Files.writeString(recovery.resolve(process + ".kept.jen"), "# Lightning kept this of process " + process + " for " + file.toUri()
                + " over " + FileState.of(file).toText() + "\n" + sceneText().replace("intensity 0.4", "intensity 0.6"));
        return file;
    }

    @Test
    void unsavedScenes_areOfferedInOneList_andRecoveredOneAfterTheOther() throws Exception {
        Path first = crash("first.jen", "999999999999-1");
        Path second = crash("second.jen", "999999999998-1");
        Files.writeString(second, sceneText() + "# mine\n");
        startCommand(Command.RECOVER);
        waitFor("the scenes are offered", () -> robot.lookup("#recoverable").tryQuery().isPresent());
        ListView<RecoveryFolder.RecoverableScene> list = robot.lookup("#recoverable").query();
        assertThat(list.getItems()).extracting(RecoveryFolder.RecoverableScene::file).containsExactlyInAnyOrder(first, second);
        assertThat(robot.lookup("#recoverable .list-cell").queryAllAs(ListCell.class)).extracting(ListCell::getText)
                .anyMatch(text -> text.startsWith(first + ", edited 20") && text.endsWith("\nThe file did not change since."))
                .anyMatch(text -> text.startsWith(second + ", edited 20")
                        && text.contains("\nThe file was changed since this version was opened, at 20"));
        robot.interact(() -> list.getSelectionModel().select(list.getItems().stream().filter(s -> s.file().equals(second)).findFirst()
                .orElseThrow()));
        robot.clickOn("Recover");
        waitFor("the scene is recovered", () -> model().editor().document().file().equals(second));
        assertThat(light("sun").intensity()).isEqualTo(0.6);
        startCommand(Command.SAVE_SCENE);
        waitFor("the question is shown", () -> isMessageShown("second.jen was changed by another program"));
        robot.clickOn("Cancel");
        startCommand(Command.RECOVER);
        waitFor("the other scene is offered", () -> robot.lookup("#recoverable").tryQuery().isPresent());
        ListView<RecoveryFolder.RecoverableScene> rest = robot.lookup("#recoverable").query();
        assertThat(rest.getItems()).extracting(RecoveryFolder.RecoverableScene::file).containsExactly(first);
        robot.clickOn("Discard");
        waitFor("the dialog is closed", () -> robot.lookup("#recoverable").tryQuery().isEmpty());
        startCommand(Command.RECOVER);
        waitFor("nothing is left", () -> text("message").equals("There are no unsaved changes to recover"));
    }

    @Test
    void savedScene_showsSaved_alsoIfAutosaveFails() throws Exception {
        Path noFolder = Files.writeString(folder.resolve("blocked"), "a file");
        Path file = Files.writeString(folder.resolve("other.jen"), sceneText());
        var failing = new AtomicReference<EditorModel>();
        var thread = new FileThread(Platform::runLater);
        OpenDocument document = OpenDocument.open(file);
        robot.interact(() -> failing.set(new EditorModel(document, new RecoveryFolder(noFolder), thread)));
        StatusMessage message = failing.get().editor().message();
        robot.interact(() -> failing.get().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25)));
        waitFor("autosave failed", () -> message.textProperty().get().startsWith("Autosave failed: "));
        robot.interact(() -> failing.get().workbench().saveAs(file, Set.of(), _ -> message.show("Saved other.jen")));
        waitFor("the scene is saved", () -> !document.isDirty());
        robot.interact(failing.get()::close);
        waitFor("all messages are shown", () -> true);
        assertThat(message.textProperty().get()).isEqualTo("Saved other.jen");
        thread.close();
    }

    @Test
    void sceneWithMissingFiles_opens_andLocateFindsThemAll() throws Exception {
        String text = sceneText() + """
                mesh chair { material matt  file "chair.obj" }
                mesh table { file "furniture/table.obj"  at 1 0 0 }
                light lantern spot { profile "lantern.ies" }
                """;
        answer = Files.writeString(folder.resolve("room.jen"), text);
        startCommand(Command.LOAD_FILE);
        waitFor("the notes are listed", () -> robot.lookup("#notes").tryQuery().isPresent());
        assertThat(model().editor().document().name()).isEqualTo("room.jen");
        assertThat(robot.lookup("#notes").<ListView<String>>query().getItems()).hasSize(3).anyMatch(
                note -> note.startsWith("line ") && note.contains("mesh 'chair': there is no mesh file 'chair.obj'"));
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
        answer = Files.writeString(elsewhere.resolve("chair.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Files.copy(answer, elsewhere.resolve("table.obj"));
        robot.clickOn("Locate…");
        waitFor("the meshes are read", () -> model().editor().document().notes().size() == 1);
        assertThat(model().editor().document().isDirty()).isFalse();
        assertThat(folder.resolve("meshes/furniture/table.obj")).hasSameTextualContentAs(answer);
        assertThat(folder.resolve("room.jen")).hasContent(text);
        waitFor("the note on the profile is listed", () -> robot.lookup("#notes").tryQuery().isPresent());
        robot.clickOn("Skip");
        waitFor("the notes are closed", () -> robot.lookup("#notes").tryQuery().isEmpty());
    }

    @Test
    void openingAnotherScene_clearsTheMessage() throws IOException {
        Path other = Files.copy(folder.resolve("desk.jen"), folder.resolve("other.jen"));
        robot.interact(() -> model().editor().message().show("Recovered: Rename lamp"));
        Platform.runLater(() -> editor.files().load(other));
        waitFor("the other scene is open", () -> model().editor().document().name().equals("other.jen"));
        assertThat(text("message")).isEmpty();
    }

    @Test
    @OwnEditor
    void openDialog_startsInTheFolderOfTheLastScene() throws Exception {
        answer = null;
        startCommand(Command.LOAD_FILE);
        waitFor("the dialog opens", () -> folder.equals(openedFolder));
        Path shipped = Files.createDirectories(folder.resolve("program"));
        OpenDocument copy = OpenDocument.openCopy(Files.copy(folder.resolve("desk.jen"), shipped.resolve("stage.jen")));
        robot.interact(() -> model().open(copy));
        openedFolder = null;
        startCommand(Command.LOAD_FILE);
        waitFor("the dialog opens", () -> openedFolder != null);
        assertThat(openedFolder).isEqualTo(folder);
    }

    @Test
    void saveSceneAs_changesDocumentFile() {
        answer = folder.resolve("other");
        startCommand(Command.SAVE_SCENE_AS);
        waitFor("the scene is saved",
                () -> Files.exists(folder.resolve("other.jen")) && model().editor().document().name().equals("other.jen"));
    }

    @Test
    void saveImage_writesWhatTheCanvasShows() throws IOException {
        answer = folder.resolve("picture.pfm");
        click("save-image");
        waitFor("the file is written", () -> text("message").equals("Saved picture.pfm"));
        assertThat(ImageFile.read(answer).hasSameBits(model().picture().frame().film())).isTrue();
    }

    private void export(String title) {
        Menu menu = robot.lookup(".menu-bar").<MenuBar>query().getMenus().getFirst().getItems().stream()
                .filter(item -> "menu-export".equals(item.getId())).map(Menu.class::cast).findFirst().orElseThrow();
        Platform.runLater(() -> menu.getItems().stream().filter(item -> item.getText().equals(title)).findFirst().orElseThrow().fire());
    }

    @Test
    void exportedLayers_sumToPicture() throws IOException {
        answer = folder.resolve("desk.exr");
        export("Layers as OpenEXR, 32-bit Float…");
        waitFor("the file is written", () -> text("message").equals("Exported desk.exr"));
        assertThat(ImageFile.read(answer).hasSameBits(model().picture().frame().film())).isTrue();
        try (ExrReader reader = new ExrReader(answer)) {
            assertThat(reader.header().channels()).extracting(ExrChannel::name).contains("lamp_diffuse.R", "rounding.B", "shape.id");
        }
        assertThat(model().fileActivity().file()).isNull();
    }

    @Test
    void exportedMattes_nameTheObjects() throws IOException {
        answer = folder.resolve("desk.exr");
        export("Mattes as OpenEXR, Cryptomatte…");
        waitFor("the file is written", () -> text("message").equals("Exported desk.exr"));
        try (ExrReader reader = new ExrReader(answer)) {
            assertThat(reader.header().channels()).extracting(ExrChannel::name).contains("R", "CryptoObject00.R", "CryptoMaterial02.A");
            assertThat(reader.header().texts().values()).contains("CryptoObject", "CryptoMaterial", "CryptoAsset");
        }
    }

    @Test
    void exportWithoutExtension_addsExtension() throws IOException {
        answer = folder.resolve("deep");
        export("Image as PNG, 16-bit…");
        waitFor("the file is written", () -> text("message").equals("Exported deep.png"));
        assertThat(Files.readAllBytes(folder.resolve("deep.png"))[24]).isEqualTo((byte) 16);
    }

    @Test
    void unwritableExport_showsError() {
        answer = folder.resolve("nowhere").resolve("desk.hdr");
        export("Image as Radiance HDR…");
        waitFor("the error is shown", () -> isMessageShown("The image could not be exported"));
        robot.clickOn("Close");
        assertThat(model().fileActivity().file()).isNull();
    }

    @Test
    void saveImage_inFalseColor_savesPicture() throws IOException {
        robot.interact(() -> model().picture().viewProperty().set(model().picture().viewProperty().get().withCurve(DisplayCurve.FALSE)));
        answer = folder.resolve("picture.png");
        click("save-image");
        waitFor("the file is written", () -> text("message").equals("Saved picture.png"));
        assertThat(ViewTransform.DEFAULT.toPixels(ImageFile.read(answer)))
                .isEqualTo(ViewTransform.DEFAULT.toPixels(model().picture().frame().film()));
    }

    @Test
    void savedImage_hasTheSizeOfTheSceneNotThatOfThePane() throws IOException {
        robot.interact(() -> model().layout().workingSizeProperty().set(WorkingSize.PANE));
        Scene scene = model().editor().scene();
        waitFor("the picture is traced", () -> model().picture().frame().film().width() > scene.picture().width());
        answer = folder.resolve("picture.png");
        click("save-image");
        waitFor("the file is written", () -> text("message").equals("Exported picture.png"));
        assertThat(ViewTransform.DEFAULT.toPixels(ImageFile.read(answer)))
                .isEqualTo(SceneView.of(scene).toPixels(new ReferenceTracer(scene).trace()));
        assertThat(model().picture().frame().film().width()).isGreaterThan(scene.picture().width());
    }

    @Test
    void saveImageWithPendingEdits_mentionsThem() {
        dim();
        answer = folder.resolve("picture.png");
        startCommand(Command.SAVE_IMAGE);
        waitFor("the question is shown", () -> isMessageShown("The image is out of date."));
        robot.clickOn("Save Anyway");
        waitFor("the file is written", () -> Files.exists(answer));
        assertThat(isEnabled(Command.GO)).isTrue();
    }

    @Test
    void goFirst_rendersInsteadOfSaving() {
        dim();
        answer = folder.resolve("picture.png");
        startCommand(Command.SAVE_IMAGE);
        waitFor("the question is shown", () -> isMessageShown("Render First"));
        robot.clickOn("Render First");
        waitForPicture();
        assertThat(answer).doesNotExist();
    }

    @Test
    void brokenFile_showsProblemsAndKeepsScene() throws IOException {
        answer = Files.writeString(folder.resolve("broken.jen"), "jen 1\nlight key spot { intensity -3 }\nsphere { }\n");
        startCommand(Command.LOAD_FILE);
        waitFor("the error is shown", () -> robot.lookup("#problems").tryQuery().isPresent());
        List<Problem> problems = robot.lookup("#problems").<ListView<Problem>>query().getItems();
        assertThat(problems).extracting(Problem::line).contains(2, 3);
        assertThat(model().editor().document().name()).isEqualTo("desk.jen");
        robot.clickOn("Close");
    }

    @Test
    void sceneWithMissingImages_opensAndListsThem() throws IOException {
        answer = Files.writeString(folder.resolve("bare.jen"), "jen 1\nmaterial m {\n  texture \"none.png\" }\nsphere s { material m }\n");
        startCommand(Command.LOAD_FILE);
        waitFor("the scene is open", () -> model().editor().document().name().equals("bare.jen"));
        assertThat(closeNotes()).singleElement().asString().startsWith("line 3: material 'm': there is no texture 'none.png' in the folder")
                .endsWith("; left out");
    }

    @Test
    void missingFile_showsError() {
        answer = folder.resolve("nowhere.jen");
        startCommand(Command.LOAD_FILE);
        waitFor("the error is shown", () -> isMessageShown(answer + ": file not found"));
        robot.clickOn("Close");
    }

    @Test
    void loadedFile_replacesTracedScene() throws IOException {
        String text = Files.readString(folder.resolve("desk.jen")).replace("size 64 48", "size 40 30");
        answer = Files.writeString(folder.resolve("small.jen"), text);
        startCommand(Command.LOAD_FILE);
        waitFor("the scene is open", () -> model().editor().document().name().equals("small.jen"));
        waitForPicture();
        assertThat(model().picture().raster().pixels().width()).isEqualTo(40);
        assertThat(text("traced-sizes")).isEqualTo("40 × 30");
    }

    @Test
    void otherScene_startsWithEmptyPicture() throws IOException {
        String text = Files.readString(folder.resolve("desk.jen")).replace("fov 40", "fov 50");
        answer = Files.writeString(folder.resolve("wide.jen"), text);
        startCommand(Command.LOAD_FILE);
        waitFor("the scene is open", () -> model().editor().document().name().equals("wide.jen"));
        waitForPicture();
        assertThat(telemetry()).startsWith("full render: no image yet");
    }

    /** Returns a scene with a size that no other test uses, and enough work to be canceled on any machine. */
    private OpenDocument large() throws IOException, JenException {
        String text = Files.readString(folder.resolve("desk.jen")).replace("size 64 48", "size 170 170");
        // Many shadow rays in little memory.
        String lights = IntStream.range(0, 300).mapToObj(i -> "light more_" + i + " point { at 1 3 4  radius 0.5  samples 64 }\n")
                .collect(Collectors.joining());
        return OpenDocument.open(Files.writeString(folder.resolve("other.jen"), text + lights));
    }

    /** Returns the number of pixels in the traced picture; 0 without a picture. */
    private int shownPixels() {
        PictureView picture = robot.lookup("#traced-picture").query();
        return picture.isEmpty() ? 0 : picture.pixels().length;
    }

    /** The picture is always that of the scene in the title, or empty, regardless of thread timing. */
    @Test
    void otherSceneTitle_isNeverShownOverOldPicture() throws Exception {
        OpenDocument opened = large();
        List<String> wrong = new ArrayList<>();
        robot.interact(() -> {
            stage.titleProperty().subscribe(title -> {
                if (title.startsWith("other.jen") && shownPixels() == 64 * 48) {
                    wrong.add(title);
                }
            });
            model().open(opened);
        });
        robot.interact(() -> model().commands().run(Command.CANCEL));
        waitFor("the render is canceled", () -> model().picture().renderStateProperty().get().canceled());
        // Its center samples may have been shown before it was canceled.
        waitFor("the last scene's picture is cleared", () -> isShown("waiting") || shownPixels() == 170 * 170);
        assertThat(stage.getTitle()).startsWith("other.jen");
        assertThat(wrong).isEmpty();
    }

    @Test
    void otherScene_canceledImmediately_showsCanceled() throws Exception {
        OpenDocument opened = large();
        robot.interact(() -> {
            model().open(opened);
            model().commands().run(Command.CANCEL);
        });
        waitFor("no render is running", () -> model().editor().editorStateProperty().get().sceneInProgress().isEmpty());
        // A coarse picture may have been traced before it was canceled.
        waitFor("the message is shown", () -> isShown("waiting") ? text("waiting").equals("Canceled. Render the image with F5.")
                : text("pending").equals("Unfinished. Render (F5)"));
        assertThat(isEnabled(Command.GO)).isTrue();
    }

    @Test
    void droppedFile_opensOnlyScenes() throws IOException {
        Path small = Files.writeString(folder.resolve("small.jen"),
                Files.readString(folder.resolve("desk.jen")).replace("size 64 48", "size 40 30"));
        EditorWindow window = editor.window();
        AtomicBoolean taken = new AtomicBoolean(true);
        robot.interact(() -> taken.set(window.openDropped(List.of(folder.resolve("a.png").toFile()))));
        assertThat(taken).isFalse();
        robot.interact(() -> taken.set(window.openDropped(List.of(folder.resolve("a.png").toFile(), small.toFile()))));
        assertThat(taken).isTrue();
        waitFor("the scene is open", () -> model().editor().document().name().equals("small.jen"));
    }

    @Test
    void droppedMeshWithoutCamera_fitsItsPane() throws IOException {
        Path mesh = Files.writeString(folder.resolve("tri.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        robot.interact(() -> editor.window().openDropped(List.of(mesh.toFile())));
        chooseLighting("studio");
        waitFor("the scene is open", () -> model().editor().document().name().equals("tri.jen"));
        PictureSettings picture = model().editor().scene().picture();
        PictureArea pane = model().layout().pictureArea();
        assertThat(picture.width()).isEqualTo((int) Math.min(pane.width(), pane.height() * 16 / 9));
        assertThat(picture.height()).isEqualTo((int) Math.min(pane.height(), pane.width() * 9 / 16));
        assertThat(model().editor().editorStateProperty().get().dirty()).isFalse();
    }

    @Test
    void droppedMesh_createsSceneNextToIt_andAsksBeforeAnother() throws IOException {
        Path mesh = Files.writeString(folder.resolve("tri.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n");
        robot.interact(() -> editor.window().openDropped(List.of(mesh.toFile())));
        chooseLighting("sky");
        waitFor("the scene is open", () -> model().editor().document().name().equals("tri.jen"));
        waitFor("the message is shown", () -> text("message").startsWith("Imported tri.obj; 1 import note"));
        assertThat(closeNotes()).containsExactly("lines");
        assertThat(model().editor().scene().lights()).extracting(Light::name).containsExactly("sun", "sky");
        assertThat(model().editor().scene().picture().sampling().antialias()).isEqualTo(AntialiasMode.EDGES);
        String first = Files.readString(folder.resolve("tri.jen"));
        answer = folder.resolve("again.jen");
        robot.interact(() -> editor.window().openDropped(List.of(mesh.toFile())));
        chooseLighting("studio");
        waitFor("the other scene is open", () -> model().editor().document().name().equals("again.jen"));
        assertThat(model().editor().scene().lights()).extracting(Light::name).containsExactly("key", "fill", "rim", "sky");
        assertThat(Files.readString(folder.resolve("tri.jen"))).isEqualTo(first);
    }

    /** Copies and closes the list of notes; returns its lines. */
    private List<String> closeNotes() {
        waitFor("the notes are listed", () -> robot.lookup("#notes").tryQuery().isPresent());
        ListView<String> list = robot.lookup("#notes").query();
        robot.interact(() -> {
            Button copy = robot.lookup(".dialog-pane .button").lookup((Button button) -> button.getText().equals("Copy")).query();
            copy.fire();
            assertThat(Clipboard.getSystemClipboard().getString()).isEqualTo(String.join("\n", list.getItems()));
            list.getScene().getWindow().hide();
        });
        return list.getItems();
    }

    private void chooseLighting(String lighting) {
        waitFor("the question is shown", () -> robot.lookup("#lighting-" + lighting).tryQuery().isPresent());
        click("lighting-" + lighting);
    }

    @Test
    void fileWithoutUnits_offersUnits_andStoresChoice() throws IOException {
        Path gltf = Files.write(folder.resolve("lit.gltf"), GltfFixtures.text(GltfFixtures.LIT_JSON, GltfFixtures.SQUARE));
        robot.interact(() -> editor.window().openDropped(List.of(gltf.toFile())));
        waitFor("the question is shown", () -> robot.lookup("#units-watts").tryQuery().isPresent());
        assertThat(folder.resolve("lit.jen")).doesNotExist();
        click("units-watts");
        waitFor("the scene is open", () -> model().editor().document().name().equals("lit.jen"));
        assertThat(light("bulb").intensity() / light("bulb").attenuation().quadratic())
                .isCloseTo(100 / (4 * Math.PI * Math.PI), Offset.offset(1e-9));
        assertThat(Files.readString(folder.resolve("lit.jen"))).contains("# light units: the file's numbers were taken as watts");
    }

    @Test
    void unitsDialog_canBeCanceled() throws IOException {
        Path gltf = Files.write(folder.resolve("lit.gltf"), GltfFixtures.text(GltfFixtures.LIT_JSON, GltfFixtures.SQUARE));
        robot.interact(() -> editor.window().openDropped(List.of(gltf.toFile())));
        waitFor("the question is shown", () -> robot.lookup("#units-watts").tryQuery().isPresent());
        robot.type(javafx.scene.input.KeyCode.ESCAPE);
        waitFor("the dialog is closed", () -> robot.lookup("#units-watts").tryQuery().isEmpty());
        assertThat(text("message")).isEmpty();
        assertThat(model().editor().document().name()).isEqualTo("desk.jen");
        assertThat(folder.resolve("lit.jen")).doesNotExist();
    }

    @Test
    void brokenMesh_showsErrorAndKeepsScene() throws IOException {
        answer = Files.writeString(folder.resolve("bad.obj"), "v 0 0 0\nf 1 2 3\n");
        startCommand(Command.LOAD_FILE);
        waitFor("the error is shown", () -> isMessageShown("bad.obj could not be opened"));
        assertThat(robot.lookup(".dialog-pane .label").queryAllAs(Label.class)).extracting(Label::getText)
                .anyMatch(text -> text.startsWith(folder.resolve("bad.obj") + ": line 2: "));
        assertThat(text("message")).isEmpty();
        assertThat(model().editor().document().name()).isEqualTo("desk.jen");
        assertThat(folder.resolve("bad.jen")).doesNotExist();
        robot.type(javafx.scene.input.KeyCode.ESCAPE);
    }

    @Test
    void longError_isCenteredInWindow() throws IOException {
        Path deep = Files.createDirectories(folder.resolve("a folder of meshes ".repeat(10).strip()));
        answer = Files.writeString(deep.resolve("bad.obj"), "v 0 0 0\nf 1 2 3\n");
        startCommand(Command.LOAD_FILE);
        waitFor("the error is shown", () -> isMessageShown("bad.obj could not be opened"));
        Window dialog = robot.lookup(".dialog-pane").query().getScene().getWindow();
        assertThat(dialog.getX() + dialog.getWidth() / 2).isCloseTo(stage.getX() + stage.getWidth() / 2, Offset.offset(2.0));
        robot.type(javafx.scene.input.KeyCode.ESCAPE);
    }

    @Test
    @OwnEditor
    void recentScene_isOpenedFromTheMenu() throws IOException {
        answer = Files.writeString(folder.resolve("other.jen"), Files.readString(folder.resolve("desk.jen")));
        startCommand(Command.LOAD_FILE);
        waitFor("the scene is open", () -> model().editor().document().name().equals("other.jen"));
        waitFor("the menu lists the first scene",
                () -> editor.files().recentItems().stream().anyMatch(i -> i.getText().endsWith("desk.jen")));
        robot.interact(() -> editor.files().recentItems().stream().filter(i -> i.getText().equals(folder.resolve("desk.jen").toString()))
                .findFirst().orElseThrow().fire());
        waitFor("the first scene is open again", () -> model().editor().document().name().equals("desk.jen"));
    }

    @Test
    void unsavedEdits_canBeDiscardedForAnotherScene() throws IOException, JenException {
        dim();
        answer = Files.writeString(folder.resolve("other.jen"), Files.readString(folder.resolve("desk.jen")));
        startCommand(Command.LOAD_FILE);
        waitFor("the question is shown", () -> isMessageShown("Save changes to desk.jen?"));
        robot.clickOn("Don't Save");
        waitFor("the scene is open", () -> model().editor().document().name().equals("other.jen"));
        assertThat(JenReader.read(folder.resolve("desk.jen")).scene().light("lamp").orElseThrow().intensity()).isEqualTo(1);
    }

    @Test
    void reload_revertsAndCanBeUndone() {
        dim();
        click("reload");
        waitFor("the scene is reloaded", () -> light("lamp").intensity() == 1);
        click("undo");
        assertThat(light("lamp").intensity()).isEqualTo(0.25);
    }

    @Test
    void closing_withUnsavedEdits_asksAndCancelKeepsOpen() {
        dim();
        Platform.runLater(() -> stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST)));
        waitFor("the question is shown", () -> isMessageShown("Save changes to desk.jen?"));
        robot.clickOn("Cancel");
        assertThat(stage.isShowing()).isTrue();
        assertThat(model().editor().document().isDirty()).isTrue();
    }

    @Test
    void closing_duringSave_waitsForSave() throws IOException, JenException {
        dim();
        robot.interact(() -> {
            model().commands().run(Command.SAVE_SCENE);
            stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST));
        });
        waitFor("the window is closed", () -> !stage.isShowing());
        assertThat(JenReader.read(folder.resolve("desk.jen")).scene().light("lamp").orElseThrow().intensity()).isEqualTo(0.25);
    }

    @Test
    void edit_whileLoadingOtherScene_asksBeforeDiscard() throws IOException {
        Path other = Files.writeString(folder.resolve("other.jen"), Files.readString(folder.resolve("desk.jen")));
        robot.interact(() -> {
            editor.files().load(other);
            model().editor().edit(scene -> DeskScene.parameter("intensity").set(scene, "lamp", 0.25));
        });
        waitFor("the question is shown", () -> isMessageShown("Save changes to desk.jen?"));
        robot.clickOn("Cancel");
        assertThat(model().editor().document().name()).isEqualTo("desk.jen");
        assertThat(light("lamp").intensity()).isEqualTo(0.25);
    }

    @Test
    void loading_afterCancel_isDiscarded() throws IOException {
        Path other = Files.writeString(folder.resolve("other.jen"), Files.readString(folder.resolve("desk.jen")));
        robot.interact(() -> {
            editor.files().load(other);
            model().commands().run(Command.CANCEL);
        });
        Path third = Files.writeString(folder.resolve("third.jen"), Files.readString(folder.resolve("desk.jen")));
        List<String> opened = new ArrayList<>();
        robot.interact(() -> model().editor().documentProperty().addListener((_, _, now) -> opened.add(now.name())));
        robot.interact(() -> editor.files().load(third));
        waitFor("the third scene is open", () -> model().editor().document().name().equals("third.jen"));
        assertThat(opened).containsExactly("third.jen");
    }

    @Test
    void canceledLoading_clearsProgress() throws IOException {
        Path other = Files.writeString(folder.resolve("other.jen"), Files.readString(folder.resolve("desk.jen")));
        robot.interact(() -> {
            editor.files().load(other);
            model().editor().message().show("Reading other.jen: 64 %");
            model().commands().run(Command.CANCEL);
        });
        assertThat(text("message")).isEmpty();
    }

    @Test
    @OwnEditor
    void accuracyChoice_isSavedImmediately() {
        robot.interact(() -> model().accuracyModeProperty().set(AccuracyMode.RATIO));
        waitFor("the preference is saved",
                () -> new Preferences(folder.resolve("own"), Runnable::run).enumValue("precision", AccuracyMode.EXACT)
                        == AccuracyMode.RATIO);
    }

    @Test
    void approximateAccuracy_endsWithTheOpenFile() throws IOException {
        Path other = Files.writeString(folder.resolve("other.jen"), Files.readString(folder.resolve("desk.jen")));
        robot.interact(() -> {
            model().accuracyModeProperty().set(AccuracyMode.RATIO);
            model().commands().run(Command.RELOAD);
        });
        waitForPicture();
        assertThat(model().accuracyModeProperty().get()).isEqualTo(AccuracyMode.RATIO);
        robot.interact(() -> editor.files().load(other));
        waitFor("the other scene is open", () -> model().editor().document().name().equals("other.jen"));
        assertThat(model().accuracyModeProperty().get()).isEqualTo(AccuracyMode.EXACT);
        Path third = Files.writeString(folder.resolve("third.jen"), Files.readString(folder.resolve("desk.jen")));
        robot.interact(() -> {
            model().accuracyModeProperty().set(AccuracyMode.ON_DEMAND);
            editor.files().load(third);
        });
        waitFor("the third scene is open", () -> model().editor().document().name().equals("third.jen"));
        assertThat(model().accuracyModeProperty().get()).isEqualTo(AccuracyMode.ON_DEMAND);
    }

    @Test
    void message_isOwnedByTheWindowThatAsked() {
        floatPanels();
        robot.interact(() -> model().commands().run(Command.HISTORY_PANEL));
        Stage panel =
                Window.getWindows().stream().filter(w -> w != stage && w.isShowing()).map(Stage.class::cast).findFirst().orElseThrow();
        robot.interact(panel::requestFocus);
        robot.interact(() -> model().commands().run(Command.ABOUT));
        assertThat(messageWindow(panel).getOwner()).isSameAs(panel);
        robot.interact(messageWindow(panel)::close);
        robot.interact(panel::close);
        robot.interact(() -> model().commands().run(Command.ABOUT));
        assertThat(messageWindow(panel).getOwner()).isSameAs(stage);
        robot.interact(messageWindow(panel)::close);
    }

    private Stage messageWindow(Stage panel) {
        return Window.getWindows().stream().filter(w -> w != stage && w != panel && w.isShowing()).map(Stage.class::cast).findFirst()
                .orElseThrow();
    }

    @Test
    void saveOnClosing_writesTheScene() throws IOException, JenException {
        dim();
        Platform.runLater(() -> stage.fireEvent(new WindowEvent(stage, WindowEvent.WINDOW_CLOSE_REQUEST)));
        waitFor("the question is shown", () -> isMessageShown("Save changes to desk.jen?"));
        robot.clickOn("Save");
        waitFor("the scene is saved", () -> !model().editor().document().isDirty());
        Path file = folder.resolve("desk.jen");
        assertThat(JenReader.read(file).scene().light("lamp").orElseThrow().intensity()).isEqualTo(0.25);
    }
}
