package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SequenceRenderTest {
    private static final String SCENE = """
            jen 1
            picture { size 12 8 }
            camera { from 0 1 4  to 0 0 0 }
            sphere ball { }
            light key point { at 1 2 3  intensity %s }
            shot { frames 1 3  camera { from { 1 0 1 4  3 0 1 8 } } }
            """;

    @TempDir
    private Path folder;
    private Path sequence;

    private static String scene(String intensity) {
        return SCENE.replace("%s", intensity);
    }

    @BeforeEach
    void write() throws IOException {
        Files.writeString(folder.resolve("a.jen"), scene("1"));
        Files.writeString(folder.resolve("rig.jen"), "jen 1\nlight key point { at 1 2 3  intensity 2 }\n");
        sequence = Files.writeString(folder.resolve("seq.json"), """
                {"lightning_sequence": 1, "rig": "rig.jen", "shots": [
                  {"name": "one", "scene": "a.jen"},
                  {"name": "two", "scene": "a.jen", "frames": [2, 2], "set": ["key.intensity=0.5"]}]}
                """);
    }

    private List<String> files(String name) throws IOException {
        try (Stream<Path> files = Files.list(folder.resolve(name))) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void shots_areRenderedAsTheirScenesWithTheRig() throws IOException {
        CliResult.run("shot", "render", sequence, "-o", folder.resolve("out")).assertSuccess();
        assertThat(files("out")).containsExactly("one-0001.png", "one-0002.png", "one-0003.png", "two-0002.png");
        Files.writeString(folder.resolve("one.jen"), scene("2"));
        Files.writeString(folder.resolve("two.jen"), scene("0.5"));
        for (String name : List.of("one", "two")) {
            CliResult.run("shot", "render", folder.resolve(name + ".jen"), "-o", folder.resolve("single")).assertSuccess();
            assertThat(folder.resolve("out/" + name + "-0002.png")).hasSameBinaryContentAs(folder.resolve("single/" + name + "-0002.png"));
        }
    }

    @Test
    void chosenShotAndFrames_areThoseOfATask() throws IOException {
        CliResult.run("shot", "render", sequence, "--shots", "one", "--frames", "2-3", "-o", folder.resolve("out")).assertSuccess();
        assertThat(files("out")).containsExactly("one-0002.png", "one-0003.png");
        CliResult result =
                CliResult.run("shot", "render", sequence, "--shots", "one", "--resume", "-o", folder.resolve("out")).assertSuccess();
        assertThat(result.out()).contains("2 of 3 frames already rendered");
    }

    @Test
    void wrongUse_isRejected() {
        CliResult.run("shot", "render", sequence, "--shots", "three", "-o", folder.resolve("out")).assertRejected("no shot 'three'",
                "one, two");
        CliResult.run("shot", "render", sequence, "-o", folder.resolve("a.mp4")).assertRejected("a video has one shot");
        CliResult.run("shot", "render", folder.resolve("a.jen"), "--shots", "one", "-o", folder.resolve("out"))
                .assertRejected("--shots works only for a sequence");
    }
}
