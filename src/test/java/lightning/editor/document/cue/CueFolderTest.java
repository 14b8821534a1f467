package lightning.editor.document.cue;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Light;
import lightning.scene.Links;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CueFolderTest {
    private static final String TEXT = """
            jen 1
            world { ambience 0.3  background 0 0.1 0.2 }
            sphere ball {}
            bank rims { intensity 2 }
            light key spot { at 0 3 0  bank rims  illuminates only "ball" }
            light fill point { intensity 0.5 }
            """;

    @TempDir
    private Path folder;
    private Scene scene;
    private CueFolder cues;

    @BeforeEach
    void open() throws Exception {
        Path file = Files.writeString(folder.resolve("room.jen"), TEXT);
        scene = JenReader.read(file).scene();
        cues = new CueFolder(file);
    }

    private void keep(String name) throws IOException {
        cues.keep(name, Lighting.of(scene), Film.black(4, 3), ViewTransform.DEFAULT);
    }

    private List<Cue> list() throws IOException {
        return cues.list(scene.stage());
    }

    @Test
    void keptCue_isReadBackWithItsLinksAndItsPicture() throws IOException {
        keep("warm evening");
        Cue cue = list().getFirst();
        assertThat(cue.name()).isEqualTo("warm evening");
        assertThat(cue.lighting()).hasValue(Lighting.of(scene));
        assertThat(cue.picture().orElseThrow().sameBits(Film.black(4, 3))).isTrue();
        assertThat(folder.resolve("room.cues/warm evening.jen")).content().startsWith("jen 1\n").contains("light key spot")
                .doesNotContain("sphere");
        assertThat(folder.resolve("room.cues/warm evening.png")).exists();
    }

    @Test
    void sceneWithoutCues_hasNone() throws IOException {
        assertThat(list()).isEmpty();
        assertThat(cues.path()).doesNotExist();
    }

    @Test
    void brokenCue_isListedWithItsProblemAndTheOthersStay() throws IOException {
        keep("good");
        Files.writeString(cues.path().resolve("bad.jen"), "jen 1\nlight key spot { bank none }\n");
        assertThat(list()).extracting(Cue::name).containsExactly("bad", "good");
        assertThat(list().getFirst().lighting()).isEmpty();
        assertThat(list().getFirst().problem()).contains("there is no bank").contains(":2:");
    }

    @Test
    void damagedPicture_leavesTheLights() throws IOException {
        keep("dusk");
        Files.writeString(cues.path().resolve("dusk.png"), "no picture");
        assertThat(list().getFirst().picture()).isEmpty();
        assertThat(list().getFirst().lighting()).isPresent();
    }

    @Test
    void linkOutOfTheScenesFolder_isRefused(@TempDir Path elsewhere) throws IOException {
        keep("dusk");
        Path secret = Files.writeString(elsewhere.resolve("secret.jen"), "jen 1\n");
        Files.createSymbolicLink(cues.path().resolve("out.jen"), secret);
        assertThat(list()).filteredOn(c -> c.name().equals("out")).first()
                .satisfies(c -> assertThat(c.problem()).contains("leads out of the scene's folder"));
    }

    @Test
    void renamedCue_keepsBothFilesAndTakesNoNameThatIsThere() throws IOException {
        keep("a");
        keep("b");
        assertThatThrownBy(() -> cues.rename("a", "b")).isInstanceOf(IOException.class);
        cues.rename("a", "c");
        assertThat(list()).extracting(Cue::name).containsExactly("b", "c");
        assertThat(list().getLast().picture()).isPresent();
    }

    @Test
    void removedCue_comesBack() throws IOException {
        keep("a");
        cues.remove("a");
        assertThat(list()).isEmpty();
        cues.bringBack("a");
        assertThat(list().getFirst().lighting()).hasValue(Lighting.of(scene));
        assertThat(list().getFirst().picture()).isPresent();
    }

    @Test
    void namesThatAreNoFiles_areRefused() {
        for (String name : List.of("", " ", "../x", "a/b", "a\\b", ".hidden", "end.", "a\nb", "x".repeat(61), "a:b")) {
            assertThat(CueFolder.refusal(name)).as(name).isPresent();
            assertThatThrownBy(() -> keep(name)).isInstanceOf(IOException.class);
        }
        assertThat(CueFolder.refusal("Über Nacht 2")).isEmpty();
    }

    @Test
    void lighting_leavesOutLinksToShapesThatAreNotThere() throws IOException {
        Scene other = scene.withNodes(List.of());
        Scene lit = Lighting.of(scene).on(other).or(null);
        assertThat(lit.light("key").orElseThrow().illuminates()).isEqualTo(Links.NONE);
        assertThat(lit.stage()).isEqualTo(other.stage());
    }

    @Test
    void addedRig_takesFreeNames() {
        Scene more = Lighting.of(scene).addedTo(scene).or(null);
        assertThat(more.lights()).extracting(Light::name).containsExactly("key", "fill", "key2", "fill2");
        assertThat(more.lights().get(2).bank()).isEqualTo("rims2");
        assertThat(more.world()).isEqualTo(scene.world());
    }
}
