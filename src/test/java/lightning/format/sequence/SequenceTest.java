package lightning.format.sequence;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import lightning.base.file.AtomicFile;
import lightning.scene.Scene;
import lightning.scene.shot.AnimatedScene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SequenceTest {
    private static final String SHOT = """
            jen 1
            picture { size 12 8 }
            camera { from 0 1 4  to 0 0 0 }
            world { background 0.1 0.2 0.3 }
            sphere BALL { }
            light old point { at 0 3 0 }
            light key point { at 0 9 0 }
            """;
    private static final String RIG = """
            jen 1
            world { background 0.5 0.5 0.5 }
            bank all { intensity 0.5 }
            light key point { at 1 2 3  intensity 3  bank all  illuminates except "ball" }
            light fill point { at -1 2 3 }
            """;
    private static final String SEQUENCE = """
            {"lightning_sequence": 1, "rig": "rig.jen", "shots": [
              {"name": "wide", "scene": "a.jen"},
              {"name": "close", "scene": "b.jen", "frames": [3, 5], "set": ["key.intensity=7", "fill.on=no"], "note": "cooler"}],
             "notes": {"key": "through the window"}}
            """;

    @TempDir
    private Path folder;
    private Path file;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(folder.resolve("a.jen"), SHOT.replace("BALL", "ball"));
        Files.writeString(folder.resolve("b.jen"), SHOT.replace("BALL", "other") + """
                shot { frames 1 8  rate 25
                  camera { from { 1 0 1 4  8 0 1 8 } }
                  light old { intensity { 1 1  8 2 } }
                }
                """);
        Files.writeString(folder.resolve("rig.jen"), RIG);
        file = Files.writeString(folder.resolve("seq.json"), SEQUENCE);
    }

    private LoadedSequence read() throws Exception {
        return LoadedSequence.read(file);
    }

    private static AnimatedScene lit(LoadedSequence sequence, int shot) {
        return sequence.lit(sequence.shots().get(shot), sequence.rig());
    }

    @Test
    void shots_getTheLightsOfTheRig() throws Exception {
        Scene wide = lit(read(), 0).base();
        assertThat(wide.lights()).extracting("name").containsExactly("key", "fill");
        assertThat(wide.light("key").orElseThrow().intensity()).isEqualTo(3);
        assertThat(wide.rig().lightGroups()).hasSize(1);
        assertThat(wide.stage().hasNode("ball")).isTrue();
        assertThat(wide.world().background().r()).isEqualTo(0.1);
    }

    @Test
    void world_isSharedOnRequest() throws Exception {
        Files.writeString(file, SEQUENCE.replace("\"shots\"", "\"world\": true, \"shots\""));
        assertThat(lit(read(), 0).base().world().background().r()).isEqualTo(0.5);
    }

    @Test
    void overrides_applyToTheirShotOnly() throws Exception {
        LoadedSequence sequence = read();
        Scene close = lit(sequence, 1).base();
        assertThat(close.light("key").orElseThrow().intensity()).isEqualTo(7);
        assertThat(close.light("fill").orElseThrow().on()).isFalse();
        assertThat(lit(sequence, 0).base().light("fill").orElseThrow().on()).isTrue();
    }

    @Test
    void links_areThoseOfEachShot() throws Exception {
        LoadedSequence sequence = read();
        assertThat(lit(sequence, 0).base().light("key").orElseThrow().illuminates().isAll()).isFalse();
        assertThat(lit(sequence, 1).base().light("key").orElseThrow().illuminates().isAll()).isTrue();
    }

    @Test
    void keyframes_stayExceptThoseOfMissingLights() throws Exception {
        AnimatedScene close = lit(read(), 1);
        assertThat(close.shot().orElseThrow().first()).isEqualTo(3);
        assertThat(close.shot().orElseThrow().last()).isEqualTo(5);
        assertThat(close.shot().orElseThrow().tracks()).hasSize(1);
        assertThat(close.sceneAt(4).camera().from().z()).isGreaterThan(4);
    }

    @Test
    void stillScene_hasOneFrame() throws Exception {
        assertThat(lit(read(), 0).shot().orElseThrow().first()).isEqualTo(lit(read(), 0).shot().orElseThrow().last());
    }

    @Test
    void writtenSequence_isReadAsItWas() throws Exception {
        Sequence sequence = SequenceReader.read(file);
        Path copy = folder.resolve("copy.json");
        sequence.write(AtomicFile.of(copy));
        assertThat(SequenceReader.read(copy)).isEqualTo(sequence);
        Sequence changed =
                sequence.with("wide", shot -> shot.withOverrides(List.of("key.on=no")).withNote("new")).withLightNote("fill", "x")
                        .withLightNote("key", " ");
        changed.write(AtomicFile.of(copy));
        assertThat(SequenceReader.read(copy)).isEqualTo(changed);
        assertThat(changed.shot("wide")).contains(new Sequence.Entry("wide", "a.jen", Optional.empty(), List.of("key.on=no"), "new"));
        assertThat(changed.lightNotes()).isEqualTo(new LinkedHashMap<>(Map.of("fill", "x")));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "\"lightning_sequence\": 1 | \"lightning_sequence\": 2 | expected \"lightning_sequence\": 1",
        "\"rig\": | \"rigg\": | rigg: unknown key",
        "\"name\": \"wide\" | \"name\": \"../wide\" | shots[0].name: expected a part of a file name",
        "\"name\": \"wide\" | \"name\": \"Close\" | another shot has the name",
        "\"name\": \"wide\" | \"label\": \"wide\" | shots[0].label: unknown key",
        "[3, 5] | [5, 3] | shots[1].frames: expected the first and the last frame",
        "[3, 5] | [3, 9] | expected frames from 1 to 8",
        "\"rig.jen\" | 7 | rig: expected a text",
        "\"key.intensity=7\" | 7 | shots[1].set[0]: expected an edit",
        "\"rig.jen\" | \"gone.jen\" | gone.jen",
        "{\"name\": \"wide\", \"scene\": \"a.jen\"}, | , | expected a sequence"})
    void wrongSequence_getsOneSentence(String old, String replacement, String message) throws IOException {
        Files.writeString(file, SEQUENCE.replace(old, replacement));
        assertThatThrownBy(this::read).isInstanceOf(IOException.class).hasMessageContaining(message);
    }

    @Test
    void wrongOverride_namesItsShot() throws Exception {
        Files.writeString(file, SEQUENCE.replace("fill.on=no", "fil.on=no"));
        LoadedSequence sequence = read();
        assertThatThrownBy(() -> lit(sequence, 1)).isInstanceOf(IllegalArgumentException.class).hasMessageContaining("shot 'close'")
                .hasMessageContaining("fil.on=no").hasMessageContaining("fill");
    }
}
