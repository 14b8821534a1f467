package lightning.editor.window.sequence;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import javafx.scene.control.CheckBox;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelFormat;
import lightning.base.work.Progress;
import lightning.document.EditOutcome;
import lightning.editor.Command;
import lightning.editor.window.EditorFixture;
import lightning.editor.window.command.PathPrompt;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.format.sequence.SequenceReader;
import lightning.render.RenderOptions;
import lightning.render.image.ViewTransform;
import lightning.render.relight.Renderer;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SequencePaneTest extends EditorFixture {
    private static final String SHOT = """
            jen 1
            picture { size 32 18 }
            camera { from 0 1 %s  to 0 0 0 }
            sphere ball { }
            light lamp point { at 0 3 3 }
            """;

    @TempDir
    private Path folder;
    private static int opened;
    private Path file;
    private String name;
    private SequencePane pane;

    @BeforeEach
    void open() throws IOException {
        Files.writeString(folder.resolve("a.jen"), SHOT.replace("%s", "4"));
        Files.writeString(folder.resolve("b.jen"), SHOT.replace("%s", "6"));
        Files.writeString(folder.resolve("rig.jen"), "jen 1\nlight lamp point { at 1 2 3  intensity 2 }\n");
        // Tests of a class share their editor: another name shows that this one is open.
        name = "seq" + ++opened + ".json";
        file = Files.writeString(folder.resolve(name), """
                {"lightning_sequence": 1, "rig": "rig.jen", "shots": [
                  {"name": "a", "scene": "a.jen"}, {"name": "b", "scene": "b.jen", "set": ["lamp.intensity=0.5"]}]}
                """);
        robot.interact(() -> model().commands().run(Command.SEQUENCE));
        waitFor("the panel is open", () -> robot.lookup("#sequence").tryQuery().isPresent());
        pane = robot.lookup("#sequence").query();
        robot.interact(() -> pane.open(file));
        waitFor("the sequence is open", () -> text("sequence-file").equals(name));
    }

    /** Returns the exact picture of a shot with one lamp. */
    private int[] expected(String shot, Light lamp) {
        try (Renderer renderer = new Renderer(RenderOptions.DEFAULT.withThreads(1))) {
            Scene scene = JenReader.read(folder.resolve(shot + ".jen")).scene();
            renderer.render(scene.withLights(List.of(lamp)), Progress.NONE);
            return ViewTransform.DEFAULT.toPixels(renderer.film());
        } catch (IOException | JenException e) {
            throw new AssertionError(e);
        }
    }

    private boolean shows(String shot, int[] pixels) {
        ImageView view = (ImageView) robot.lookup("#shot-" + shot).query().lookup(".image-view");
        Image image = view.getImage();
        if (image == null || image.getWidth() * image.getHeight() != pixels.length) {
            return false;
        }
        int[] shown = new int[pixels.length];
        image.getPixelReader().getPixels(0, 0, (int) image.getWidth(), (int) image.getHeight(), PixelFormat.getIntArgbPreInstance(), shown,
                0, (int) image.getWidth());
        return Arrays.equals(shown, pixels);
    }

    private Light lamp(double intensity) {
        try {
            return JenReader.read(folder.resolve("rig.jen")).scene().light("lamp").orElseThrow().withIntensity(intensity);
        } catch (IOException | JenException e) {
            throw new AssertionError(e);
        }
    }

    @Test
    void cards_showTheExactPicturesWithTheRig() {
        int[] a = expected("a", lamp(2));
        int[] b = expected("b", lamp(0.5));
        waitFor("both shots are shown", () -> shows("a", a) && shows("b", b));
    }

    @Test
    void editOfTheOpenScene_lightsAllShots() {
        robot.interact(() -> robot.lookup("#sequence-follows").<CheckBox>query().setSelected(true));
        Light own = light("lamp");
        Light edited = own.withIntensity(0.25 * own.intensity());
        robot.interact(() -> model().editor().editOrReport(scene -> EditOutcome.of(() -> scene.withLights(List.of(edited)))));
        int[] a = expected("a", edited.retainLinks(name -> name.equals("ball")));
        waitFor("the edit is shown", () -> shows("a", a));
    }

    @Test
    void lastEdit_becomesAValueOfTheSelectedShot() {
        robot.interact(() -> robot.lookup("#sequence-follows").<CheckBox>query().setSelected(true));
        clickCard("b");
        Light own = light("lamp");
        robot.interact(() -> model().editor().editOrReport(scene -> EditOutcome.of(() -> scene.withLight(own.withIntensity(3)))));
        click("sequence-own");
        assertThat(light("lamp")).isEqualTo(own);
        assertThat(robot.lookup("#sequence-overrides").<TextArea>query().getText()).isEqualTo("lamp.intensity=3");
        waitFor("the value is saved", () -> overrides("b").equals(List.of("lamp.intensity=3")));
    }

    private List<String> overrides(String shot) {
        try {
            return SequenceReader.read(file).shot(shot).orElseThrow().overrides();
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    /** Shot a has nine frames, b has one. */
    @Test
    void threeFrames_areShownForAShot() throws IOException {
        Files.writeString(folder.resolve("a.jen"),
                SHOT.replace("%s", "4") + "shot { frames 1 9  light lamp { intensity { 1 1  9 2 } } }\n");
        robot.interact(() -> pane.open(file));
        robot.interact(() -> robot.lookup("#sequence-moment").<ChoiceBox<SheetMoment>>query().setValue(SheetMoment.ALL));
        waitFor("all pictures are shown", () -> pictures("a") == 3 && pictures("b") == 1);
        robot.interact(() -> robot.lookup("#sequence-moment").<ChoiceBox<SheetMoment>>query().setValue(SheetMoment.FIRST));
        waitFor("one picture is shown", () -> pictures("a") == 1);
    }

    private long pictures(String shot) {
        return robot.lookup("#shot-" + shot).query().lookupAll(".image-view").stream().filter(view -> ((ImageView) view).getImage() != null)
                .count();
    }

    @Test
    void override_isShownAndSaved() {
        clickCard("a");
        robot.interact(() -> robot.lookup("#sequence-overrides").<TextArea>query().setText("lamp.intensity=1.5"));
        int[] a = expected("a", lamp(1.5));
        waitFor("the override is shown", () -> shows("a", a));
        robot.interact(() -> robot.lookup("#sequence-note").<TextField>query().setText("softer"));
        waitFor("it is saved", () -> {
            try {
                return SequenceReader.read(file).shot("a").filter(
                        shot -> shot.overrides().equals(List.of("lamp.intensity=1.5")) && shot.note().equals("softer")).isPresent();
            } catch (IOException e) {
                return false;
            }
        });
    }

    @Test
    void wrongOverride_saysWhyThereIsNoPicture() {
        clickCard("b");
        robot.interact(() -> robot.lookup("#sequence-overrides").<TextArea>query().setText("lamb.intensity=1.5"));
        waitFor("the reason is shown", () -> robot.lookup("#shot-b").<ShotCard>query().problem().contains("lamb"));
        robot.interact(() -> robot.lookup("#sequence-overrides").<TextArea>query().setText(""));
        int[] b = expected("b", lamp(2));
        waitFor("the picture is back", () -> shows("b", b) && robot.lookup("#shot-b").<ShotCard>query().problem().isEmpty());
    }

    @Test
    void fileChangedElsewhere_isNotOverwritten() throws IOException {
        String other = Files.readString(file).replace("lamp.intensity=0.5", "lamp.intensity=9");
        Files.writeString(file, other);
        clickCard("a");
        robot.interact(() -> robot.lookup("#sequence-note").<TextField>query().setText("lost?"));
        waitFor("the reason is shown", () -> text("sequence-message").contains("changed by another program"));
        assertThat(Files.readString(file)).isEqualTo(other);
        assertThat(text("sequence-file")).isEqualTo(name + " *");
    }

    @Test
    void brokenFile_keepsTheOpenSequence() throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.json"), "{}");
        robot.interact(() -> pane.open(broken));
        waitFor("the reason is shown", () -> text("sequence-message").contains("broken.json"));
        assertThat(text("sequence-file")).isEqualTo(name);
    }

    /** Answers all dialogs with a file. */
    private record Answer(Path file) implements PathPrompt {
        @Override
        public Optional<Path> fileToOpen(String title, String extension) {
            return Optional.of(file);
        }

        @Override
        public Optional<Path> fileToSave(String title, String proposal, String extension) {
            return Optional.of(file);
        }

        @Override
        public Optional<Path> folder(String title) {
            return Optional.empty();
        }
    }

    @Test
    void newSequence_beginsWithTheOpenScene_andTakesMoreShots() throws IOException {
        Path created = folder.resolve("new" + opened + ".json");
        robot.interact(() -> pane.setPrompt(new Answer(created)));
        click("sequence-new");
        waitFor("it is open", () -> text("sequence-file").equals(created.getFileName().toString()));
        Path scene = model().editor().document().file().toAbsolutePath();
        assertThat(folder.resolve(SequenceReader.read(created).rig()).toAbsolutePath().normalize()).isEqualTo(scene.normalize());
        robot.interact(() -> pane.setPrompt(new Answer(folder.resolve("a.jen"))));
        click("sequence-add");
        waitFor("the shot is there", () -> robot.lookup("#shot-a").tryQuery().isPresent());
        click("sequence-add");
        waitFor("it is there twice", () -> SequenceReader.read(created).names().contains("a 2"));
        assertThat(SequenceReader.read(created).shot("a 2").orElseThrow().scene()).isEqualTo("a.jen");
    }

    private void clickCard(String shot) {
        robot.clickOn("#shot-" + shot);
    }
}
