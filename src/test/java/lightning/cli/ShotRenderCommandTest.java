package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import lightning.format.exr.ExrReader;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenReader;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.shot.movie.Ffmpeg;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.json.JsonMapper;

/** Shot rendered to numbered images. */
class ShotRenderCommandTest {
    /** First only lights change, then the camera, then a shape. */
    private static final String SHOT = """
            shot {
              frames 3 7
              light lamp { intensity { 3 0.5  5 2 } at { 3 -3 4 3 smooth  5 -1 4 3 } }
              light sun { on { 3 yes  5 no } }
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

    @Test
    void everyFrame_matchesReference() throws Exception {
        Files.createDirectory(folder.resolve("out"));
        CliResult done = CliResult.run("shot", "render", scene, "-o", folder.resolve("out/b.pfm")).assertSuccess();
        assertThat(files("out")).containsExactly("b-0003.pfm", "b-0004.pfm", "b-0005.pfm", "b-0006.pfm", "b-0007.pfm");
        JenDocument document = JenReader.read(scene);
        for (int frame = 3; frame <= 7; frame++) {
            assertThat(ImageFile.read(folder.resolve("out/b-000" + frame + ".pfm"))
                    .hasSameBits(new ReferenceTracer(document.shot().orElseThrow().sceneAt(document.scene(), frame)).trace()))
                    .as("frame " + frame)
                    .isTrue();
        }
        // The first frame, and the one in which the camera moved.
        assertThat(done.out()).contains("2 frames traced in", "3 relit in");
    }

    /** Paths are kept, traced again for the camera, and repeated in part for the ball. */
    @Test
    void everyFrameWithIndirectLight_matchesReference() throws Exception {
        Files.writeString(scene, Files.readString(scene).replace("depth 2", "depth 2  indirect { rays 16  spacing 4 }"));
        CliResult.run("shot", "render", scene, "-o", folder.resolve("b.pfm")).assertSuccess();
        JenDocument document = JenReader.read(scene);
        for (int frame = 3; frame <= 7; frame++) {
            assertThat(ImageFile.read(folder.resolve("b-000" + frame + ".pfm"))
                    .hasSameBits(new ReferenceTracer(document.shot().orElseThrow().sceneAt(document.scene(), frame)).trace()))
                    .as("frame " + frame)
                    .isTrue();
        }
    }

    /** The light that is off in some frames has layers in all of them. */
    @Test
    void layersAndMattes_areWrittenForEachFrame() throws Exception {
        CliResult.run("shot", "render", scene, "-o", folder.resolve("b.exr"), "--layers", "--bits", "32", "--cryptomatte",
                folder.resolve("m.exr")).assertSuccess();
        JenDocument document = JenReader.read(scene);
        for (int frame = 3; frame <= 7; frame++) {
            Path file = folder.resolve("b-000" + frame + ".exr");
            assertThat(ImageFile.read(file)
                    .hasSameBits(new ReferenceTracer(document.shot().orElseThrow().sceneAt(document.scene(), frame)).trace()))
                    .as("frame " + frame)
                    .isTrue();
            assertSumOfLayers(file);
            try (ExrReader mattes = new ExrReader(folder.resolve("m-000" + frame + ".exr"))) {
                assertThat(mattes.header().texts().values()).contains("CryptoObject", "CryptoMaterial", "CryptoAsset");
            }
        }
        CliResult again = CliResult.run("shot", "render", scene, "-o", folder.resolve("b.exr"), "--layers", "--bits", "32", "--cryptomatte",
                folder.resolve("m.exr"), "--resume").assertSuccess();
        assertThat(again.out()).isEqualTo("5 frames already rendered\n");
        CliResult.run("shot", "render", scene, "-o", folder.resolve("b.png"), "--layers").assertRejected("layers are written to .exr");
    }

    private static void assertSumOfLayers(Path file) throws Exception {
        try (ExrReader reader = new ExrReader(file)) {
            List<String> channels = new ArrayList<>(List.of("G"));
            for (String layer : JsonMapper.shared().readValue(reader.header().texts().get("lightning/sum"), String[].class)) {
                channels.add(layer + ".G");
            }
            assertThat(channels).contains("sun_diffuse.G", "lamp_specular.G", "stage_diffuse.G");
            reader.read(channels, (_, _, values) -> {
                float sum = 0;
                for (int i = 1; i < values.length; i++) {
                    sum += values[i];
                }
                assertThat(sum).isEqualTo(values[0]);
            });
        }
    }

    @Test
    void singleFrame_isCountedAsOne() {
        CliResult done = CliResult.run("shot", "render", scene, "-o", folder.resolve("out"), "--frames", "4").assertSuccess();
        assertThat(done.out()).contains("\n1 frame traced in ");
        CliResult again = CliResult.run("shot", "render", scene, "-o", folder.resolve("out"), "--frames", "4", "--resume").assertSuccess();
        assertThat(again.out()).isEqualTo("1 frame already rendered\n");
        assertThat(CliResult.run("shot", "render", scene, "-o", folder.resolve("out"), "--frames", "4-5", "--resume").assertSuccess().out())
                .endsWith("\n1 of 2 frames already rendered\n");
    }

    @Test
    void outputWithoutExtension_createsFolder() throws Exception {
        CliResult.run("shot", "render", scene, "--frames", "4-5", "-o", folder.resolve("frames"), "--size", "8x8").assertSuccess();
        assertThat(files("frames")).containsExactly("a-0004.png", "a-0005.png");
    }

    @Test
    void resume_skipsExistingPictures() throws Exception {
        Path out = Files.createDirectory(folder.resolve("frames"));
        Files.writeString(out.resolve("a-0004.png"), "mine");
        CliResult done = CliResult.run("shot", "render", scene, "--resume", "--frames", "3-5", "-o", out, "--size", "8x8").assertSuccess();
        assertThat(Files.readString(out.resolve("a-0004.png"))).isEqualTo("mine");
        assertThat(files("frames")).containsExactly("a-0003.png", "a-0004.png", "a-0005.png");
        assertThat(done.out()).contains("1 of 3 frames already rendered");
        CliResult.run("shot", "render", scene, "--frames", "4", "-o", out, "--size", "8x8").assertSuccess();
        assertThat(ImageFile.read(out.resolve("a-0004.png")).width()).isEqualTo(8);
    }

    @Test
    void sceneWithoutShot_isRejected() throws Exception {
        CliResult.run("shot", "render", CliResult.scene(folder), "-o", folder.resolve("x")).assertRejected("has no shot");
    }

    @Test
    void invalidFrame_isRejectedBeforeWriting() throws Exception {
        Files.writeString(scene, CliResult.SCENE + "shot { frames 1 9  camera { from { 1 0 2 7  9 0 0.5 0 } } }");
        CliResult.run("shot", "render", scene, "-o", folder.resolve("x"))
                .assertRejected("frame 9: from and to must be different points");
        assertThat(folder.resolve("x")).doesNotExist();
    }

    @ParameterizedTest
    @CsvSource({"9-3", "1-200000", "x", "-1", "1-", "1-99999999999", "1.5", "1-2-3"})
    void invalidFrames_areRejected(String frames) {
        CliResult.run("shot", "render", scene, "-o", folder.resolve("x"), "--frames=" + frames).assertRejected("--frames",
                "found '" + frames + "'");
    }

    @Test
    void shotWithoutSubcommand_listsSubcommands() {
        CliResult.run("shot").assertRejected("expected a subcommand of shot", "render");
    }

    @Test
    void unknownExtension_isRejected() {
        CliResult.run("shot", "render", scene, "-o", folder.resolve("x.tiff")).assertRejected(".tiff");
    }

    static boolean hasFfmpeg() {
        return Ffmpeg.find().isPresent();
    }

    @Test
    @EnabledIf("hasFfmpeg")
    void movie_hasExactlyAllFrames() throws Exception {
        Path out = Files.createDirectory(folder.resolve("out"));
        CliResult done =
                CliResult.run("shot", "render", scene, "-o", out.resolve("b.mp4"), "--size", "31x20", "--view", "filmic").assertSuccess();
        assertThat(done.out()).contains("frame 7: ", "b.mp4: 5 frames, 24 fps");
        assertThat(files("out")).containsExactly("b.mp4");
        Process probe = new ProcessBuilder("ffprobe", "-v", "error", "-count_frames", "-show_entries",
                "stream=width,height,r_frame_rate,nb_read_frames", "-of", "csv=p=0", out.resolve("b.mp4").toString()).start();
        assertThat(new String(probe.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip()).isEqualTo("32,20,24/1,5");
        CliResult.run("shot", "render", scene, "-o", out.resolve("b.mp4"), "--resume")
                .assertRejected("--resume works only for numbered images");
    }
}
