package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.stream.Stream;
import lightning.cli.output.ExitCode;
import lightning.format.image.ImageFile;
import lightning.format.jen.JenReader;
import lightning.format.jen.PropertyEdit;
import lightning.render.image.Difference;
import lightning.render.image.Film;
import lightning.render.shading.reference.ReferenceTracer;
import lightning.sample.Slow;
import lightning.sample.TransparentScenes;
import lightning.scene.Scene;
import lightning.scene.paper.PaperCases;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class RelightCommandTest {
    @TempDir
    Path folder;
    private Path path;
    private Path picture;
    private Scene scene;

    @BeforeEach
    void write() throws Exception {
        path = CliResult.scene(folder);
        picture = folder.resolve("out.pfm");
        scene = JenReader.read(path).scene();
    }

    @ParameterizedTest
    @ValueSource(strings = {"--storage=rows", "--storage=shapes"})
    void currentReflections_matchReference(String storage) throws Exception {
        CliResult.run("relight", path, "-o", picture, "--set", "lamp.at=1 3 2", "--set", "sun.color=1 0 0", "--reflections", "current",
                storage, "--verify").assertSuccess();
        Scene edited = PropertyEdit.apply(PropertyEdit.apply(scene, "lamp.at=1 3 2"), "sun.color=1 0 0");
        assertThat(ImageFile.read(picture).hasSameBits(new ReferenceTracer(edited).trace())).isTrue();
    }

    @Test
    void edits_byDefault_updateMirrors() throws Exception {
        CliResult.run("relight", path, "-o", picture, "--set", "lamp.intensity=3").assertSuccess();
        Film reference = new ReferenceTracer(PropertyEdit.apply(scene, "lamp.intensity=3")).trace();
        assertThat(ImageFile.read(picture).hasSameBits(reference)).isTrue();
    }

    @Test
    void staleReflections_showInitialScene() throws Exception {
        String out =
                CliResult.run("relight", path, "-o", picture, "--set", "lamp.intensity=3", "--reflections", "stale", "--verify")
                        .assertSuccess().out();
        Scene edited = PropertyEdit.apply(scene, "lamp.intensity=3");
        Film reference = new ReferenceTracer(edited, scene).trace();
        assertThat(ImageFile.read(picture).hasSameBits(reference)).isTrue();
        long stale = Difference.of(reference, new ReferenceTracer(edited).trace()).pixels();
        assertThat(out).contains("Verified: equal to a full trace with outdated reflections in every bit",
                stale + " pixels would change with current reflections");
        assertThat(stale).isPositive();
    }

    @Test
    void then_startsNextEdit() {
        String out = CliResult.run("relight", path, "-o", picture, "--set", "stage.angle=12", "--set", "stage.dropoff=9", "--then",
                "--delete", "sun", "--then", "--add", "fill point at=0 3 2 intensity=0.2", "--reflections", "stale").assertSuccess().out();
        assertThat(out.lines().map(line -> line.replaceAll(": \\d+ rows.*", "")).skip(1)).containsExactly(
                "1. stage: angle remove + falloff", "2. sun: delete", "3. fill: add");
    }

    @Test
    void eachEdit_printsPlanRowsRaysTimesAndAccuracy() {
        String out = CliResult.run("relight", path, "-o", picture, "--set", "sun.intensity=0.1").assertSuccess().out();
        assertThat(out.lines().skip(1)).singleElement().asString().matches(
                "1\\. sun: weight, reflections: \\d+ rows, 0 shadow rays, [\\d.]+ ms of a full trace's [\\d.]+ \\(saves -?[\\d.]+ %\\), exact");
    }

    @Test
    void noSavings_printsOwnTimeOnly() {
        String out = CliResult.run("relight", path, "-o", picture, "--set", "sun.intensity=0.1", "--no-savings").assertSuccess().out();
        assertThat(out.lines().skip(1)).singleElement().asString().matches(
                "1\\. sun: weight, reflections: \\d+ rows, 0 shadow rays, [\\d.]+ ms, exact");
    }

    @Test
    void unusedProperty_isWarnedAbout() {
        CliResult run =
                CliResult.run("relight", path, "-o", picture, "--set", "sun.at=1 2 3", "--set", "lamp.intensity=2", "--then", "--set",
                        "lamp.angle=20", "--no-savings").assertSuccess();
        assertThat(run.err().lines()).containsExactly("sun.at has no effect: a directional light has no position",
                "lamp.angle has no effect: a point light has no cone half-angle");
        assertThat(run.out().lines().skip(1)).hasSize(2);
    }

    /** Uses the light's type after the whole edit; a material and the world have no light properties. */
    @Test
    void usedProperty_isNotWarnedAbout() {
        CliResult run = CliResult
                .run("relight", path, "-o", picture, "--set", "sun.at=1 2 3", "--set", "sun.type=point", "--set", "stage.angle=20",
                        "--set", "world.intensity=2", "--set", "material:red.model=phong", "--set", "sun.name=key", "--no-savings")
                .assertSuccess();
        assertThat(run.err()).isEmpty();
    }

    @Test
    void updateReflections_appliesLastEditToMirrors() throws Exception {
        String out = CliResult.run("relight", path, "-o", picture, "--set", "lamp.intensity=3", "--update-reflections", "--verify")
                .assertSuccess().out();
        Film reference = new ReferenceTracer(PropertyEdit.apply(scene, "lamp.intensity=3")).trace();
        assertThat(ImageFile.read(picture).hasSameBits(reference)).isTrue();
        assertThat(out.lines().filter(line -> line.startsWith("mirrors: reflections: "))).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {TransparentScenes.BALL, TransparentScenes.PANE})
    void staleLightThroughGlass_isReportedAndUpdated(String text) throws Exception {
        Files.writeString(path, text);
        scene = JenReader.read(path).scene();
        Scene edited = PropertyEdit.apply(scene, "lamp.intensity=3");
        String stale = CliResult.run("relight", path, "-o", picture, "--set", "lamp.intensity=3", "--reflections", "stale", "--verify",
                "--no-savings").assertSuccess().out();
        assertThat(stale).contains("exact, reflections out of date",
                "Verified: equal to a full trace with outdated reflections in every bit",
                Difference.of(new ReferenceTracer(edited, scene).trace(), new ReferenceTracer(edited).trace()).pixels()
                        + " pixels would change with current reflections");
        String updated = CliResult.run("relight", path, "-o", picture, "--set", "lamp.intensity=3", "--update-reflections", "--verify",
                "--no-savings").assertSuccess().out();
        assertThat(updated.lines().filter(line -> line.startsWith("mirrors: reflections: "))).singleElement().asString()
                .endsWith(", exact");
        assertThat(updated).contains("Verified: equal to a full trace in every bit").doesNotContain("Verification failed");
        assertThat(ImageFile.read(picture).hasSameBits(new ReferenceTracer(edited).trace())).isTrue();
    }

    @Test
    void updateReflections_withCurrentMirrors_isRejected() {
        CliResult.run("relight", path, "-o", picture, "--set", "lamp.intensity=3", "--reflections", "current", "--update-reflections")
                .assertRejected("--update-reflections updates stale reflections; with --reflections current they need no update");
        assertThat(picture).doesNotExist();
    }

    @Test
    void multiSceneCase_rendersEach() {
        String out = CliResult.run("relight", path, "-o", picture, "--case", "undo", "--verify").assertSuccess().out();
        assertThat(out.lines().filter(line -> line.matches("\\d\\. lamp: weight, reflections: .*"))).hasSize(2);
    }

    /** Returns each case in the first scene that has it; PaperCasesTest compares all of them in all scenes. */
    static Stream<Arguments> cases() throws Exception {
        Map<String, Path> cases = new LinkedHashMap<>();
        try (Stream<Path> files = Files.list(Path.of("scenes"))) {
            for (Path file : files.filter(f -> f.toString().endsWith(".jen")).sorted().toList()) {
                PaperCases.of(JenReader.read(file).scene()).forEach(edit -> cases.putIfAbsent(edit.name(), file));
            }
        }
        return cases.entrySet().stream().map(edit -> Arguments.of(edit.getValue(), edit.getKey()));
    }

    @ParameterizedTest
    @MethodSource("cases")
    @Slow
    void everyCase_isVerified(Path file, String name) {
        CliResult relit =
                CliResult.run("relight", file, "-o", picture, "--case", name, "--size", "18x12", "--no-indirect",
                        "--update-reflections", "--verify", "--no-savings");
        assertThat(relit.assertSuccess().out()).contains("Verified: equal to a full trace in every bit")
                .doesNotContain("Verification failed");
    }

    @Test
    void ratio_statesAndMeetsItsBound() {
        String out = CliResult.run("relight", path, "-o", picture, "--set", "lamp.intensity=0.3", "--then", "--set",
                "lamp.intensity=0.7", "--accuracy", "ratio", "--verify").assertSuccess().out();
        assertThat(out).contains("off by at most", "Verified: ");
    }

    @Test
    void save_preservesUneditedText() throws Exception {
        Path saved = folder.resolve("saved.jen");
        CliResult.run("relight", path, "-o", picture, "--set", "sun.intensity=0.25", "--size", "20x20", "--save", saved).assertSuccess();
        assertThat(Files.readString(saved)).isEqualTo(CliResult.SCENE.replace("intensity 0.4", "intensity 0.25"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"--accuracy=exact", "--accuracy=ratio"})
    @Slow
    void materialEdit_needsNoPass(String accuracy) {
        String out = CliResult
                .run("relight", "scenes/balls.jen", "--size", "60x40", "-o", picture, accuracy, "--verify", "--set",
                        "material:gold.shininess=5",
                        "--then", "--set", "material:gold.reflective=0 0 0", "--set", "key.intensity=1", "--then", "--set",
                        "material:jade.texture=\"wood.png\"", "--set", "material:gold.reflective=0.1 0.1 0.1", "--update-reflections")
                .assertSuccess().out();
        assertThat(out.lines().filter(line -> line.matches("\\d\\. .*")).map(line -> line.replaceAll(": \\d+ rows.*", ""))).containsExactly(
                "1. gold: specular term", "2. key: weight, gold: ceases to mirror", "3. gold: begins to mirror, jade: texture");
        assertThat(out).contains("Verified: ").doesNotContain("Verification failed");
    }

    @Test
    void save_writesEditedMaterialInPlace() throws Exception {
        Path saved = folder.resolve("saved.jen");
        CliResult
                .run("relight", "scenes/balls.jen", "--size", "20x20", "-o", picture, "--set", "material:gold.shininess=91", "--save",
                        saved)
                .assertSuccess();
        assertThat(Files.readString(saved))
                .isEqualTo(Files.readString(Path.of("scenes/balls.jen")).replace("shininess 90 ", "shininess 91 "));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', value = {
        "--set | material:moon.shininess=1 | --set material:moon.shininess=1: there is no material 'moon'",
        "--set | moon.intensity=1 | --set moon.intensity=1: the scene has nothing named 'moon'",
        "--set | sun.intensity | must be written as NAME.PROPERTY=VALUE",
        "--set | sun.intensity=-1 | intensity must be ≥ 0, was -1",
        "--set | sun.intensty=1 | unknown property 'intensty'",
        "--delete | moon | there is no light 'moon'",
        "--add | fill | expected a light's name and type",
        "--case | polish | --case polish: expected one of color, intensity",
        "--accuracy | fine | --accuracy",
        "--storage | none | --storage"})
    void invalidEdit_isRejectedBeforeTracing(String option, String value, String sentence) {
        CliResult.run("relight", path, "-o", picture, "--set", "sun.intensity=1", option, value).assertRejected(sentence);
        assertThat(picture).doesNotExist();
    }

    @Test
    void noEdit_isRejected() {
        CliResult.run("relight", path, "-o", picture).assertRejected("--set");
    }

    /** Each picture and each layered file equals the file that a render of the scene after its group of edits writes. */
    @Test
    void numberedOutput_hasAPictureForEachGroup() throws Exception {
        Path saved = folder.resolve("saved.jen");
        String[] edit = {"--set", "lamp.intensity=2", "--set", "ball.at=0 1.5 0"};
        CliResult.run("relight", path, "-o", folder.resolve("%d.exr"), "--layers", "--bits", "32", "--cryptomatte",
                folder.resolve("m%02d.exr"), "--no-savings", edit[0], edit[1], edit[2], edit[3], "--then", "--delete", "sun")
                .assertSuccess();
        CliResult
                .run("relight", path, "-o", folder.resolve("last.exr"), "--no-savings", edit[0], edit[1], edit[2], edit[3], "--save", saved)
                .assertSuccess();
        CliResult.run("render", saved, "-o", folder.resolve("r1.exr"), "--layers", "--bits", "32", "--cryptomatte",
                folder.resolve("c1.exr")).assertSuccess();
        assertThat(folder.resolve("1.exr")).hasSameBinaryContentAs(folder.resolve("r1.exr"));
        assertThat(folder.resolve("m01.exr")).hasSameBinaryContentAs(folder.resolve("c1.exr"));
        assertThat(CliResult.run("compare", folder.resolve("1.exr"), folder.resolve("2.exr")).exit()).isEqualTo(ExitCode.CHECK_FAILED);
        assertThat(folder.resolve("m02.exr")).exists();
        CliResult.run("relight", path, "-o", folder.resolve("steps"), "--no-savings", edit[0], edit[1], "--then", edit[2], edit[3])
                .assertSuccess();
        assertThat(folder.resolve("steps")).isDirectoryContaining("glob:**/a-0001.png").isDirectoryContaining("glob:**/a-0002.png");
        CliResult.run("relight", path, "-o", folder.resolve("x.tiff"), edit[0], edit[1]).assertRejected(".tiff");
        CliResult.run("relight", path, "-o", folder.resolve("x.png"), "--layers", edit[0], edit[1])
                .assertRejected("layers are written to .exr");
    }
}
