package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import lightning.base.math.Rgb;
import lightning.cli.output.Console;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.review.Review;
import lightning.review.live.LiveChange;
import lightning.review.live.LiveState;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LiveDocumentTest {
    @TempDir
    private Path folder;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final Console console = new Console(new PrintStream(printed, true, StandardCharsets.UTF_8),
            new PrintStream(printed, true, StandardCharsets.UTF_8), false);
    private Path file;

    @BeforeEach
    void setFile() {
        file = folder.resolve("out.jen");
    }

    private LiveDocument document() throws IOException, JenException {
        JenDocument read = JenReader.read("jen 1\nlight key point { }\n", "s.jen", folder);
        return new LiveDocument(console, read, file);
    }

    private static LiveChange intensity(double value) {
        return new LiveChange("p", "Ann", new LiveState(List.of(new LiveState.LightValue("key", value, Rgb.WHITE, false, false)), List.of(),
                Optional.empty()), List.of(new Review.Note(0.5, 0.5, "too dark")));
    }

    private static double saved(Path file) throws IOException, JenException {
        return JenReader.read(file).scene().light("key").orElseThrow().intensity();
    }

    private String printed() {
        return printed.toString(StandardCharsets.UTF_8);
    }

    @Test
    void change_isSavedAndPrintedBeforeItsAnswer() throws Exception {
        assertThat(document().apply(intensity(2))).isEqualTo("p");
        assertThat(saved(file)).isEqualTo(2);
        assertThat(printed()).contains("Ann", "too dark");
    }

    @Test
    void fileOfAnotherProgram_staysAndTheReviewGoesOnElsewhere() throws Exception {
        LiveDocument document = document();
        document.apply(intensity(2));
        Files.writeString(file, Files.readString(file) + "# of the artist\n");
        document.apply(intensity(3));
        document.apply(intensity(4));
        assertThat(file).content().contains("# of the artist");
        assertThat(saved(file)).isEqualTo(2);
        assertThat(saved(folder.resolve("out-2.jen"))).isEqualTo(4);
        assertThat(printed()).containsOnlyOnce("was changed by another program").contains("out-2.jen from now on");
    }

    @Test
    void otherNames_areNotOverwritten() throws Exception {
        LiveDocument document = document();
        Files.writeString(folder.resolve("out-2.jen"), "jen 1\n");
        Files.writeString(file, "jen 1\n");
        document.apply(intensity(3));
        assertThat(folder.resolve("out-2.jen")).hasContent("jen 1");
        assertThat(saved(folder.resolve("out-3.jen"))).isEqualTo(3);
    }

    @Test
    void failedWrite_isRepeatedWithTheNextChange() throws Exception {
        LiveDocument document = document();
        Files.createDirectory(file);
        document.apply(intensity(2));
        assertThat(printed()).contains("out.jen", "the next change is saved with this one");
        Files.delete(file);
        document.apply(intensity(3));
        assertThat(saved(file)).isEqualTo(3);
    }

    @Test
    void failedWrite_isRepeatedAtTheEnd() throws Exception {
        LiveDocument document = document();
        Files.createDirectory(file);
        document.apply(intensity(2));
        Files.delete(file);
        document.save();
        assertThat(saved(file)).isEqualTo(2);
    }

    @Test
    void changeThatTheSceneDoesNotAllow_isLeftOut() throws Exception {
        LiveDocument document = document();
        assertThat(document.apply(intensity(-1))).isEmpty();
        assertThat(document.scene().light("key").orElseThrow().intensity()).isEqualTo(1);
        assertThat(printed()).contains("a change was left out");
    }

    @Test
    void existingFile_isReplacedUnlessItChangesLater() throws Exception {
        Files.writeString(file, "jen 1\n");
        document().apply(intensity(2));
        assertThat(saved(file)).isEqualTo(2);
    }
}
