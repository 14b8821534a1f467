package lightning.document.look;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import lightning.format.jen.JenReader;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import lightning.scene.light.Light;
import lightning.scene.value.ShapeLinks;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LookFilesTest {
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
    private LookFiles looks;

    @BeforeEach
    void open() throws Exception {
        Path file = Files.writeString(folder.resolve("room.jen"), TEXT);
        scene = JenReader.read(file).scene();
        looks = new LookFiles(file);
    }

    private void save(String name) throws IOException {
        looks.save(name, Lighting.of(scene), Film.black(4, 3), ViewTransform.DEFAULT);
    }

    private List<Look> list() throws IOException {
        return looks.list(scene.stage());
    }

    @Test
    void savedLook_roundTripsWithLinksAndPicture() throws IOException {
        save("warm evening");
        Look look = list().getFirst();
        assertThat(look.name()).isEqualTo("warm evening");
        assertThat(look.lighting()).hasValue(Lighting.of(scene));
        assertThat(look.picture().orElseThrow().hasSameBits(Film.black(4, 3))).isTrue();
        assertThat(folder.resolve("room.cues/warm evening.jen")).content().startsWith("jen 1\n").contains("light key spot")
                .doesNotContain("sphere");
        assertThat(folder.resolve("room.cues/warm evening.png")).exists();
    }

    @Test
    void sceneWithoutLooks_hasEmptyList() throws IOException {
        assertThat(list()).isEmpty();
        assertThat(looks.path()).doesNotExist();
    }

    @Test
    void brokenLook_isListedWithProblem() throws IOException {
        save("good");
        Files.writeString(looks.path().resolve("bad.jen"), "jen 1\nlight key spot { bank none }\n");
        assertThat(list()).extracting(Look::name).containsExactly("bad", "good");
        assertThat(list().getFirst().lighting()).isEmpty();
        assertThat(list().getFirst().problem()).contains("there is no bank").contains(":2:");
    }

    @Test
    void damagedPicture_keepsLights() throws IOException {
        save("dusk");
        Files.writeString(looks.path().resolve("dusk.png"), "no picture");
        assertThat(list().getFirst().picture()).isEmpty();
        assertThat(list().getFirst().lighting()).isPresent();
    }

    @Test
    void linkOutsideSceneFolder_isRejected(@TempDir Path elsewhere) throws IOException {
        save("dusk");
        Path secret = Files.writeString(elsewhere.resolve("secret.jen"), "jen 1\n");
        Files.createSymbolicLink(looks.path().resolve("out.jen"), secret);
        assertThat(list()).filteredOn(c -> c.name().equals("out")).first()
                .satisfies(c -> assertThat(c.problem()).contains("expected a file in the scene's folder"));
    }

    @Test
    void rename_movesBothFilesAndRejectsTakenName() throws IOException {
        save("a");
        save("b");
        assertThatThrownBy(() -> looks.rename("a", "b")).isInstanceOf(IOException.class);
        looks.rename("a", "c");
        assertThat(list()).extracting(Look::name).containsExactly("b", "c");
        assertThat(list().getLast().picture()).isPresent();
    }

    @Test
    void removedLook_canBeRestored() throws IOException {
        save("a");
        looks.remove("a");
        assertThat(list()).isEmpty();
        looks.restore("a");
        assertThat(list().getFirst().lighting()).hasValue(Lighting.of(scene));
        assertThat(list().getFirst().picture()).isPresent();
    }

    @Test
    void invalidFileNames_areRejected() {
        for (String name : List.of("", " ", "../x", "a/b", "a\\b", ".hidden", "end.", "a\nb", "x".repeat(61), "a:b")) {
            assertThat(LookFiles.nameProblem(name)).as(name).isPresent();
            assertThatThrownBy(() -> save(name)).isInstanceOf(IOException.class);
        }
        assertThat(LookFiles.nameProblem("Über Nacht 2")).isEmpty();
    }

    @Test
    void lighting_dropsLinksToMissingShapes() throws IOException {
        Scene other = scene.withNodes(List.of());
        Scene lit = Lighting.of(scene).applyTo(other).sceneOr(null);
        assertThat(lit.light("key").orElseThrow().illuminates()).isEqualTo(ShapeLinks.NONE);
        assertThat(lit.stage()).isEqualTo(other.stage());
    }

    @Test
    void addedRig_getsFreeNames() {
        Scene more = Lighting.of(scene).addTo(scene).sceneOr(null);
        assertThat(more.lights()).extracting(Light::name).containsExactly("key", "fill", "key2", "fill2");
        assertThat(more.lights().get(2).lightGroup()).isEqualTo("rims2");
        assertThat(more.world()).isEqualTo(scene.world());
    }
}
