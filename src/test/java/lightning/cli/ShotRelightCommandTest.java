package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.Slow;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Edits in all frames of a shot. */
@Slow
class ShotRelightCommandTest {
    /** First only lights change, then the camera, then a shape. */
    private static final String SHOT = """
            shot {
              frames 3 7
              light lamp { intensity { 3 0.5  5 2 } }
              camera { from { 5 0 2 7  6 0.5 2 7 } }
              sphere ball { at { 6 0 1 0  7 0.5 1 0 } }
            }
            """;

    @TempDir
    Path folder;
    private Path scene;

    @BeforeEach
    void write() throws Exception {
        scene = Files.writeString(folder.resolve("a.jen"), CliResult.SCENE + SHOT);
    }

    private List<String> files(String name) throws Exception {
        try (Stream<Path> files = Files.list(folder.resolve(name))) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    private Film reference(int frame, String set) throws Exception {
        JenDocument document = JenReader.read(scene);
        Scene edited = PropertyEdit.apply(document.scene(), set, folder);
        return new ReferenceTracer(document.shot().orElseThrow().sceneAt(edited, frame)).trace();
    }

    @Test
    void everyFrame_matchesReference() throws Exception {
        Files.createDirectory(folder.resolve("out"));
        CliResult done =
                CliResult.run("shot", "relight", scene, "--set", "sun.intensity=0.7", "-o", folder.resolve("out/b.pfm")).assertSuccess();
        assertThat(files("out")).containsExactly("b-0003.pfm", "b-0004.pfm", "b-0005.pfm", "b-0006.pfm", "b-0007.pfm");
        for (int frame = 3; frame <= 7; frame++) {
            assertThat(ImageFile.read(folder.resolve("out/b-000" + frame + ".pfm")).hasSameBits(reference(frame, "sun.intensity=0.7")))
                    .as("frame " + frame).isTrue();
        }
        assertThat(done.out()).contains("5 frames traced in", "5 frames relit in", "0 of them retraced, 0 rays", "saves");
    }

    @Test
    void unusedProperty_isWarnedAbout() throws Exception {
        Files.createDirectory(folder.resolve("out"));
        CliResult done =
                CliResult.run("shot", "relight", scene, "--frames", "4", "--no-savings", "--size", "8x8", "--set", "sun.at=1 2 3", "-o",
                        folder.resolve("out/b.pfm")).assertSuccess();
        assertThat(done.err()).contains("sun.at has no effect: a directional light has no position");
    }

    @Test
    void framesOnDisk_areRelitWithoutRaysAndRemoved() throws Exception {
        Path disk = Files.createDirectory(folder.resolve("disk"));
        Files.createDirectory(folder.resolve("out"));
        CliResult done =
                CliResult.run("shot", "relight", scene, "--memory", "0", "--disk", disk, "--no-savings", "--set", "sun.intensity=0.7", "-o",
                        folder.resolve("out/b.pfm")).assertSuccess();
        assertThat(done.out()).contains("cached: 0 frames", "and 5,", "0 of them retraced, 0 rays").doesNotContain("saves");
        assertThat(ImageFile.read(folder.resolve("out/b-0007.pfm")).hasSameBits(reference(7, "sun.intensity=0.7"))).isTrue();
        assertThat(files("disk")).isEmpty();
    }

    @Test
    void editGroups_haveSeparateFolders() throws Exception {
        CliResult.run("shot", "relight", scene, "--frames", "4", "--no-savings", "--size", "8x8", "--set", "sun.intensity=0.7", "--then",
                "--delete", "sun", "-o", folder.resolve("tries")).assertSuccess();
        assertThat(files("tries")).containsExactly("1", "2");
        assertThat(files("tries/1")).containsExactly("a-0004.png");
        assertThat(files("tries/2")).containsExactly("a-0004.png");
    }

    @Test
    void keyedAttribute_isRejected() {
        CliResult.run("shot", "relight", scene, "--set", "lamp.intensity=3", "-o", folder.resolve("x"))
                .assertRejected("light 'lamp': intensity is animated (keyframes at frames 3, 5)");
        assertThat(folder.resolve("x")).doesNotExist();
    }

    @Test
    void lightWithKeys_canBeDeleted() throws Exception {
        CliResult.run("shot", "relight", scene, "--frames", "3-4", "--no-savings", "--size", "8x8", "--delete", "lamp", "-o",
                folder.resolve("x")).assertSuccess();
        assertThat(files("x")).hasSize(2);
    }

    @Test
    void tooLargeShot_isRejectedWithSuggestion() {
        CliResult
                .run("shot", "relight", scene, "--frames", "0-99999", "--size", "4000x4000", "--memory", "0", "--set", "sun.intensity=3",
                        "-o",
                        folder.resolve("x"))
                .assertRejected("100000 frames of about", "of disk space are free;", "frames would fit, or a size of", "--disk");
        assertThat(folder.resolve("x")).doesNotExist();
    }

    @Test
    void diskThatIsNoFolder_isRejected() {
        CliResult.run("shot", "relight", scene, "--set", "sun.intensity=3", "-o", folder.resolve("x"), "--disk", folder.resolve("none"))
                .assertRejected("--disk", "not a folder");
    }

    @Test
    void negativeMemory_isRejected() {
        CliResult.run("shot", "relight", scene, "--set", "sun.intensity=3", "-o", folder.resolve("x"), "--memory=-1")
                .assertRejected("--memory must be 0 or more, was -1");
    }
}
