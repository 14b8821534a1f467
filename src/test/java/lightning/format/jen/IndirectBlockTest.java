package lightning.format.jen;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.Optional;
import lightning.scene.IndirectSettings;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The block of indirect light in the picture's block. */
class IndirectBlockTest {
    private static final String LINES = """
            jen 1
            picture {
              size 300 200   # small
              indirect {     # color bleeding
                bounces 3
              }
            }
            """;

    @Provide
    Arbitrary<Optional<IndirectSettings>> settings() {
        return Combinators.combine(Arbitraries.integers().between(1, IndirectSettings.MAX_BOUNCES),
                Arbitraries.of(IndirectSettings.RAY_COUNTS),
                Arbitraries.integers().between(IndirectSettings.MIN_SPACING, IndirectSettings.MAX_SPACING),
                Arbitraries.of(true, false)).as(IndirectSettings::new).optional();
    }

    @Test
    void missingBlock_isNoIndirectLight() throws Exception {
        assertThat(picture("picture { size 300 200 }").indirect()).isEmpty();
        assertThat(JenWriter.write(scene(new PictureSettings(300, 200, 3)))).isEqualTo("jen 1\n\npicture { size 300 200 }\n");
    }

    @Test
    void missingProperties_haveDefaults() throws Exception {
        assertThat(picture("picture { indirect {} }").indirect()).contains(IndirectSettings.DEFAULT);
        assertThat(picture("picture{indirect{rays 256}depth 2}"))
                .isEqualTo(new PictureSettings(200, 200, 2).withIndirect(Optional.of(IndirectSettings.DEFAULT.withRays(256))));
        assertThat(JenWriter.write(scene(PictureSettings.DEFAULT.withIndirect(Optional.of(IndirectSettings.DEFAULT)))))
                .isEqualTo("jen 1\n\npicture { indirect {} }\n");
    }

    @Test
    void allProperties_areReadAndWritten() throws Exception {
        String text = "jen 1\n\npicture { depth 5  indirect { bounces 4  rays 1024  spacing 2  background on } }\n";
        Scene scene = read(text).scene();
        assertThat(scene.picture().indirect()).contains(new IndirectSettings(4, 1024, 2, true));
        assertThat(JenWriter.write(scene)).isEqualTo(text);
    }

    @Property
    void settings_roundTripThroughNewAndSavedFiles(@ForAll("settings") Optional<IndirectSettings> before,
            @ForAll("settings") Optional<IndirectSettings> after) throws JenException {
        Scene old = scene(new PictureSettings(300, 200, 3).withIndirect(before));
        JenDocument document = read(JenWriter.write(old));
        assertThat(document.scene()).isEqualTo(old);
        Scene edited = scene(old.picture().withIndirect(after));
        assertThat(read(document.withScene(edited).text()).scene()).isEqualTo(edited);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "picture { indirect { bounces 9 } } | 30: indirect: bounces must be from 1 to 8, was 9",
        "picture { indirect { bounces 1.5 } } | 30: indirect: bounces must be a whole number, was 1.5",
        "picture { indirect { rays 100 } } | 27: indirect: rays must be 16, 64, 256 or 1024, was 100",
        "picture { indirect { spacing 1 } } | 30: indirect: spacing must be from 2 to 64, was 1",
        "picture { indirect { background yes } } | 33: indirect: background must be on or off, was 'yes'",
        "picture { indirect { bounce 2 } } | 22: indirect: unknown property 'bounce', did you mean 'bounces'?",
        "picture { indirect { size 2 2 } } | 22: indirect: unknown property 'size', expected one of bounces, rays, spacing, background",
        "picture { indirect { rays 16  rays 64 } } | 31: indirect: rays must be written once, found it again",
        "picture { indirect {} indirect {} } | 23: picture: indirect must be written once, found it again",
        "picture { indirect on } | 20: picture: indirect: expected '{', found 'on'",
        "picture { indirect 3  depth 2 } | 20: picture: indirect: expected '{', found '3'",
        "picture { indirect { 3 } } | 22: indirect: expected a property, found '3'",
        "picture { indirect { { rays 3 } } } | 22: indirect: expected a property, found '{'",
        "picture { indirect { rays 64 | 29: indirect: expected '}', found the end of the file",
        "indirect { rays 64 } | 1: expected a block (bank, camera, cone, cylinder, dome, frustum",
    })
    void mistake_isReportedWithPlace(String block, String problem) {
        assertThatThrownBy(() -> read("jen 1\n" + block)).isInstanceOf(JenException.class)
                .satisfies(e -> assertThat(((JenException) e).problems().getFirst().toString()).startsWith("test:2:" + problem));
    }

    @Test
    void mistakeInBlock_hidesNoLaterMistake() {
        assertThatThrownBy(() -> read("jen 1\npicture { indirect { rays 3  spacing 0 }  depth 11 }\ncamera { fov 0 }"))
                .satisfies(e -> assertThat(((JenException) e).problems()).hasSize(4));
    }

    @Test
    void unclosedBlock_endsBeforeNextBlock() {
        assertThatThrownBy(() -> read("jen 1\npicture { indirect { rays 64\ncamera { fov 30 }"))
                .satisfies(e -> assertThat(((JenException) e).problems()).hasSize(1));
    }

    @Test
    void edit_changesOnlyItsText() throws Exception {
        assertThat(edited(LINES, "picture.indirect.bounces=4")).isEqualTo(LINES.replace("bounces 3", "bounces 4"));
        assertThat(edited(LINES, "picture.indirect.rays=16")).isEqualTo(LINES.replace("bounces 3\n", "bounces 3\n    rays 16\n"));
        assertThat(edited(LINES, "picture.depth=5")).isEqualTo(LINES.replace("  }\n}", "  }\n  depth 5\n}"));
        assertThat(edited("jen 1\npicture { indirect {} }\n", "picture.indirect.spacing=4"))
                .isEqualTo("jen 1\npicture { indirect { spacing 4 } }\n");
        assertThat(edited("jen 1\npicture { depth 2 }\n", "picture.indirect={}")).isEqualTo("jen 1\npicture { depth 2  indirect {} }\n");
    }

    @Test
    void switchedOffLight_isRemovedWithItsLines() throws Exception {
        assertThat(edited(LINES, "picture.indirect=none")).isEqualTo("jen 1\npicture {\n  size 300 200   # small\n}\n");
        String windows = LINES.replace("\n", "\r\n");
        assertThat(edited(windows, "picture.indirect=none")).isEqualTo("jen 1\r\npicture {\r\n  size 300 200   # small\r\n}\r\n");
        assertThat(edited("jen 1\npicture { size 2 2  indirect { rays 16 }  depth 5 }\n", "picture.indirect=none"))
                .isEqualTo("jen 1\npicture { size 2 2  depth 5 }\n");
        assertThat(edited("jen 1\npicture { size 2 2 indirect{rays 16}depth 5 }\n", "picture.indirect=none"))
                .isEqualTo("jen 1\npicture { size 2 2 depth 5 }\n");
    }

    @Test
    void switchingOffAndAnotherEdit_areSavedTogether() throws Exception {
        JenDocument document = read(LINES);
        Scene edited = scene(document.scene().picture().withIndirect(Optional.empty()).withDepth(5));
        assertThat(document.withScene(edited).text()).isEqualTo("jen 1\npicture {\n  size 300 200   # small\n  depth 5\n}\n");
    }

    @Test
    void commandLineEdit_startsFromPresentSettings() throws Exception {
        Scene off = read("jen 1").scene();
        Scene on = PropertyEdit.apply(off, "picture.indirect.bounces=3");
        assertThat(on.picture().indirect()).contains(IndirectSettings.DEFAULT.withBounces(3));
        assertThat(PropertyEdit.apply(on, "picture.indirect.background=on").picture().indirect())
                .contains(IndirectSettings.DEFAULT.withBounces(3).withBackground(true));
        assertThat(PropertyEdit.apply(on, "picture.indirect={ spacing 4 }").picture().indirect())
                .contains(IndirectSettings.DEFAULT.withSpacing(4));
        assertThat(PropertyEdit.apply(on, "picture.depth=5").picture().indirect()).isEqualTo(on.picture().indirect());
        assertThat(PropertyEdit.apply(on, "picture.indirect=none")).isEqualTo(off);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "picture.indirect.rays=17 | indirect: rays must be 16, 64, 256 or 1024, was 17",
        "picture.indirect.size=1 | indirect: unknown property 'size', expected one of bounces, rays, spacing, background",
        "picture.indirect=on | picture: indirect: expected '{', found 'on'",
        "picture.indirekt.rays=16 | the scene has nothing named 'picture.indirekt', did you mean 'picture.indirect'?",
    })
    void invalidEdit_isReported(String edit, String message) throws Exception {
        Scene scene = read("jen 1").scene();
        assertThatThrownBy(() -> PropertyEdit.apply(scene, edit)).isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(message);
    }

    private static String edited(String text, String edit) throws JenException {
        JenDocument document = read(text);
        Scene edited = PropertyEdit.apply(document.scene(), edit);
        String saved = document.withScene(edited).text();
        assertThat(read(saved).scene()).isEqualTo(edited);
        return saved;
    }

    private static PictureSettings picture(String block) throws JenException {
        return read("jen 1\n" + block).scene().picture();
    }

    private static Scene scene(PictureSettings picture) throws JenException {
        return read("jen 1").scene().withPicture(picture);
    }

    private static JenDocument read(String text) throws JenException {
        return JenReader.read(text, "test", Path.of(""));
    }
}
