package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.format.picture.PictureFile;
import lightning.render.image.Film;
import lightning.render.shading.ReferenceTracer;
import lightning.sample.Slow;
import lightning.scene.Scene;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Edits in all frames of a shot. */
@Slow
class ShotRelightCommandTest {
    /** Lights alone change at first, then the camera, then a shape. */
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
        scene = Files.writeString(folder.resolve("a.jen"), Cli.SCENE + SHOT);
    }

    private List<String> files(String name) throws Exception {
        try (Stream<Path> files = Files.list(folder.resolve(name))) {
            return files.map(f -> f.getFileName().toString()).sorted().toList();
        }
    }

    private Film reference(int frame, String set) throws Exception {
        JenDocument document = JenReader.read(scene);
        Scene edited = PropertyEdit.apply(document.scene(), set, folder);
        return new ReferenceTracer(document.shot().orElseThrow().at(edited, frame)).trace();
    }

    @Test
    void everyFrame_isTheReferencePictureOfItsEditedScene() throws Exception {
        Files.createDirectory(folder.resolve("out"));
        Cli done = Cli.run("shot", "relight", scene, "--set", "sun.intensity=0.7", "-o", folder.resolve("out/b.pfm")).isDone();
        assertThat(files("out")).containsExactly("b-0003.pfm", "b-0004.pfm", "b-0005.pfm", "b-0006.pfm", "b-0007.pfm");
        for (int frame = 3; frame <= 7; frame++) {
            assertThat(PictureFile.read(folder.resolve("out/b-000" + frame + ".pfm")).sameBits(reference(frame, "sun.intensity=0.7")))
                    .as("frame " + frame).isTrue();
        }
        assertThat(done.out()).contains("5 frames traced in", "5 frames relit in", "0 of them traced again, 0 rays", "saves");
    }

    @Test
    void setPropertyThatTheLightDoesNotUse_isRemarkedOn() throws Exception {
        Files.createDirectory(folder.resolve("out"));
        Cli done = Cli.run("shot", "relight", scene, "--frames", "4", "--no-savings", "--size", "8x8", "--set", "sun.at=1 2 3", "-o",
                folder.resolve("out/b.pfm")).isDone();
        assertThat(done.err()).contains("sun.at has no effect: a directional light has no position");
    }

    @Test
    void framesOnDisk_areRelitWithoutARayAndLeaveNothing() throws Exception {
        Path disk = Files.createDirectory(folder.resolve("disk"));
        Files.createDirectory(folder.resolve("out"));
        Cli done = Cli.run("shot", "relight", scene, "--memory", "0", "--disk", disk, "--no-savings", "--set", "sun.intensity=0.7", "-o",
                folder.resolve("out/b.pfm")).isDone();
        assertThat(done.out()).contains("kept: 0 frames", "and 5,", "0 of them traced again, 0 rays").doesNotContain("saves");
        assertThat(PictureFile.read(folder.resolve("out/b-0007.pfm")).sameBits(reference(7, "sun.intensity=0.7"))).isTrue();
        assertThat(files("disk")).isEmpty();
    }

    @Test
    void groupsOfEdits_haveAFolderEach() throws Exception {
        Cli.run("shot", "relight", scene, "--frames", "4", "--no-savings", "--size", "8x8", "--set", "sun.intensity=0.7", "--then",
                "--delete", "sun", "-o", folder.resolve("tries")).isDone();
        assertThat(files("tries")).containsExactly("1", "2");
        assertThat(files("tries/1")).containsExactly("a-0004.png");
        assertThat(files("tries/2")).containsExactly("a-0004.png");
    }

    @Test
    void whatHasKeys_isNotSet() {
        Cli.run("shot", "relight", scene, "--set", "lamp.intensity=3", "-o", folder.resolve("x"))
                .isRefusedSaying("light 'lamp': intensity has keys at frames 3, 5");
        assertThat(folder.resolve("x")).doesNotExist();
    }

    @Test
    void lightWithKeys_canBeDeleted() throws Exception {
        Cli.run("shot", "relight", scene, "--frames", "3-4", "--no-savings", "--size", "8x8", "--delete", "lamp", "-o",
                folder.resolve("x")).isDone();
        assertThat(files("x")).hasSize(2);
    }

    @Test
    void framesThatFitNowhere_areRefusedWithWhatWould() {
        Cli.run("shot", "relight", scene, "--frames", "0-99999", "--size", "4000x4000", "--memory", "0", "--set", "sun.intensity=3", "-o",
                folder.resolve("x")).isRefusedSaying("100000 frames of about", "on disk;", "frames would fit, or a size of", "--disk");
        assertThat(folder.resolve("x")).doesNotExist();
    }

    @Test
    void diskThatIsNoFolder_isRefused() {
        Cli.run("shot", "relight", scene, "--set", "sun.intensity=3", "-o", folder.resolve("x"), "--disk", folder.resolve("none"))
                .isRefusedSaying("--disk", "is no folder");
    }

    @Test
    void memoryBelowNothing_isRefused() {
        Cli.run("shot", "relight", scene, "--set", "sun.intensity=3", "-o", folder.resolve("x"), "--memory=-1")
                .isRefusedSaying("--memory must be 0 or more, was -1");
    }
}
