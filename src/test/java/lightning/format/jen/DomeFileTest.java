package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.format.image.ImageFile;
import lightning.render.image.Film;
import lightning.render.image.ViewTransform;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.sky.Sky;
import lightning.scene.value.DomeRotation;
import lightning.scene.value.SceneLimits;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Domes in scene files and edits. */
class DomeFileTest {
    private static final String BLOCK = "dome west { environment \"west.hdr\"  rotation 30  tilt 5  roll -3  intensity 0.5  gain 2"
            + "  lamps 8  softness 0.25  on no  solo yes }\n";

    @TempDir
    private Path folder;

    @BeforeEach
    void writeImages() throws IOException {
        image("west.hdr", 0.5f);
        image("east.hdr", 0.25f);
    }

    private void image(String name, float value) throws IOException {
        float[] rgb = new float[3 * 8 * 4];
        Arrays.fill(rgb, value);
        ImageFile.write(folder.resolve(name), Film.ofScanlines(8, 4, rgb), ViewTransform.DEFAULT);
    }

    private JenDocument read(String text) throws JenException {
        return JenReader.read("jen 1\n" + text, "s.jen", folder);
    }

    private List<String> problems(String text) {
        try {
            read(text);
            return List.of();
        } catch (JenException e) {
            return e.problems().stream().map(Problem::toString).toList();
        }
    }

    @Test
    void block_hasAllValues() throws JenException {
        Scene scene = read(BLOCK + "dome \"the east\" { environment \"east.hdr\" }").scene();
        assertThat(scene.world().named()).extracting(Dome::name).containsExactly("west", "the east");
        Dome west = scene.world().named().getFirst();
        assertThat(west.withImage(Optional.empty()))
                .isEqualTo(new Dome("west", Optional.empty(), Sky.NONE, DomeRotation.of(30, 5, -3), 0.5, 2, 8, 0.25, false, true));
        assertThat(west.image().orElseThrow().file()).isEqualTo("west.hdr");
        assertThat(west.image().orElseThrow().map().channel(3, 2, 1)).isEqualTo(0.5f);
    }

    @Test
    void defaults_areThoseOfTheWorldsEnvironment() throws JenException {
        Scene scene = read("world { environment \"west.hdr\" }\ndome sky { environment \"west.hdr\" }").scene();
        assertThat(scene.world().environments()).extracting(Dome::rotation).containsOnly(DomeRotation.NONE);
        assertThat(scene.world().environments().getFirst()).usingRecursiveComparison().ignoringFields("name")
                .isEqualTo(scene.world().environments().getLast());
    }

    @Test
    void writtenScene_readsBack() throws JenException {
        Scene scene = read(BLOCK + "dome east { environment \"east.hdr\" }\nlight key point {}").scene();
        assertThat(read(JenWriter.write(scene).substring(6)).scene()).isEqualTo(scene);
        assertThat(JenWriter.write(scene)).contains("\ndome east { environment \"east.hdr\" }\n");
    }

    @Test
    void savedEdit_changesOnlyItsValue() throws JenException {
        JenDocument document = read("# both skies\n" + BLOCK + "dome east { environment \"east.hdr\" } # right\n");
        Scene edited = PropertyEdit.apply(document.scene(), "dome:east.gain=3");
        assertThat(document.withScene(edited).text())
                .isEqualTo(document.text().replace("\"east.hdr\" }", "\"east.hdr\"  gain 3 }"));
        Scene removed = PropertyEdit.delete(document.scene(), "west");
        assertThat(document.withScene(removed).text()).isEqualTo("jen 1\n# both skies\ndome east { environment \"east.hdr\" } # right\n");
    }

    @Test
    void edits_nameADomeWithOrWithoutItsKind() throws JenException {
        Scene scene = read("dome west { environment \"west.hdr\" }\nmaterial west {}").scene();
        assertThat(PropertyEdit.apply(scene, "dome:west.intensity=2").world().named().getFirst().intensity()).isEqualTo(2);
        assertThat(PropertyEdit.apply(scene, "west.tilt=20").world().named().getFirst().rotation().tilt()).isEqualTo(20);
        assertThat(PropertyEdit.apply(scene, "dome:\"west\".name=sky").world().named().getFirst().name()).isEqualTo("sky");
        assertThat(PropertyEdit.apply(scene, "dome:west.environment=none").world().named().getFirst().image()).isEmpty();
        assertThat(PropertyEdit.apply(scene, "dome:west.environment=\"east.hdr\"", folder).world().named().getFirst().image().orElseThrow()
                .file()).isEqualTo("east.hdr");
        assertThat(PropertyQuery.get(scene, "dome:west.gain")).isEqualTo("1");
        assertThat(PropertyQuery.get(scene, "west.environment")).isEqualTo("\"west.hdr\"");
    }

    @Test
    void editsOfTheWorld_keepDomes() throws JenException {
        Scene scene = read(BLOCK).scene();
        assertThat(PropertyEdit.apply(scene, "world.ambience=0.5").world().named()).isEqualTo(scene.world().named());
    }

    @Test
    void addedAndDeletedDome_leavesTheSceneAsItWas() throws JenException {
        Scene scene = read("light key point {}").scene();
        Scene added = PropertyEdit.add(scene, "dome sky { intensity 0.5 }");
        assertThat(added.world().named()).containsExactly(Dome.of("sky").withIntensity(0.5));
        assertThat(PropertyEdit.delete(added, "sky")).isEqualTo(scene);
    }

    @Test
    void changes_areTheEditsThatMakeThem() throws JenException {
        Scene before = read(BLOCK).scene();
        Scene after = PropertyEdit.apply(PropertyEdit.apply(before, "dome:west.on=yes"), "dome:west.gain=1");
        assertThat(PropertyChanges.between(before, after, folder)).contains(List.of("dome:west.gain=1", "dome:west.on=yes"));
    }

    @Test
    void wrongEdit_isRefused() throws JenException {
        Scene scene = read(BLOCK).scene();
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "dome:wset.gain=1")).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("there is no dome 'wset', did you mean 'west'?");
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "dome:west.gain=-1")).isInstanceOf(IllegalArgumentException.class)
                .hasMessage("dome 'west': gain must be ≥ 0, was -1");
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "dome:west.ambience=1")).isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("unknown property 'ambience', expected one of environment, rotation, tilt, roll, intensity, gain");
    }

    @Test
    void takenNames_areReportedWithTheirPlace() {
        assertThat(problems("dome a {}\ndome a {}"))
                .containsExactly("s.jen:3:6: dome 'a': names must be unique, found a dome with this name before");
        assertThat(problems("dome a {}\nsphere a {}")).hasSize(1).first().asString().contains("names must be unique");
        assertThat(problems("light a point {}\ndome a {}")).hasSize(1).first().asString().startsWith("s.jen:3:6: dome 'a'");
    }

    @Test
    void tooManyDomes_areReportedOnce() {
        String most = IntStream.range(0, SceneLimits.MAX_DOMES).mapToObj(i -> "dome d" + i + " {}\n").collect(Collectors.joining());
        assertThat(problems(most)).isEmpty();
        assertThat(problems(most + "dome last {}")).containsExactly("s.jen:18:6: a scene may have at most 16 domes, found 17");
    }

    @Test
    void missingImage_isLeftOutWithANote() throws JenException {
        JenDocument document = read("dome sky { environment \"nort.hdr\"  gain 2 }\n");
        assertThat(document.notes()).hasSize(1).first().asString().startsWith("s.jen:2:24: dome 'sky': ").contains("nort.hdr");
        assertThat(document.scene().world().named()).containsExactly(Dome.of("sky").withGain(2));
        assertThat(document.withScene(PropertyEdit.apply(document.scene(), "dome:sky.gain=3")).text())
                .isEqualTo("jen 1\ndome sky { environment \"nort.hdr\"  gain 3 }\n");
    }

    @Test
    void sameImageTwice_isReadOnce() throws JenException {
        Scene scene = read("dome a { environment \"west.hdr\" }\ndome b { environment \"east.hdr\" }\ndome c { environment \"west.hdr\" }")
                .scene();
        assertThat(scene.world().named().get(2).image().orElseThrow().map())
                .isSameAs(scene.world().named().getFirst().image().orElseThrow().map());
        assertThat(scene.world().images()).hasSize(2);
    }

    /** The world's environment has the empty name in a scene, but no edit may use it. */
    @Test
    void emptyName_addressesNoEnvironment() throws JenException {
        Scene scene = read("world { sky yes }").scene();
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "\"\".intensity=2")).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> PropertyEdit.apply(scene, "dome:\"\".intensity=2")).isInstanceOf(IllegalArgumentException.class);
    }
}
