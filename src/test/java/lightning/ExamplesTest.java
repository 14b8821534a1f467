package lightning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import lightning.ExampleProcess.Result;
import lightning.cli.HelpPages;
import lightning.format.gltf.GltfFixtures;
import lightning.sample.Nightly;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/**
 * Tests that the examples of the help, README.md and docs work for a user of the installed program. Each runs in a folder with only the
 * files that the examples expect. They run at a small size; at night, those in shell blocks of the documents also run unchanged.
 */
@Slow
class ExamplesTest {
    /** Messages for optional programs that are not installed. */
    private static final Pattern MISSING_PROGRAM =
            Pattern.compile("program povray not found|needs ffmpeg, which is not installed|USD files need |OpenColorIO views need ");
    /** User files that examples read. */
    private static final List<String> PICTURES = List.of("before.png", "after.png", "before.pfm", "after.pfm");

    private static final Set<String> MEASUREMENTS = Set.of("bench", "tour", "effects");

    @TempDir
    private static Path folder;

    private static ExampleProcess elsewhere;

    @BeforeAll
    static void start() throws IOException {
        elsewhere = new ExampleProcess(folder);
        Files.write(folder.resolve("house.glb"), GltfFixtures.binary(GltfFixtures.LIT_JSON, GltfFixtures.SQUARE));
        runSuccessfully("import", "house.glb", "-o", "house.jen", "--light-units", "candela");
        Files.writeString(folder.resolve("shot.usda"), """
                #usda 1.0
                def Sphere "ball" (
                    variants = { string look = "red" }
                    prepend variantSets = "look"
                )
                {
                    variantSet "look" = {
                        "red" {
                            double radius = 2
                        }
                    }
                }
                def Camera "side"
                {
                }
                """);
        Files.copy(folder.resolve("house.jen"), folder.resolve("shot.jen"));
        Files.writeString(folder.resolve("door.jen"), """
                jen 1
                camera { from 0 1 4  to 0 0 0 }
                sphere ball { }
                light key point { at 1 2 3 }
                shot { frames 1 8  light key { intensity { 1 1  8 2 } } }
                """);
        Files.writeString(folder.resolve("sequence.json"), """
                {"lightning_sequence": 1, "rig": "door.jen", "shots": [{"name": "wide", "scene": "door.jen"},
                  {"name": "close", "scene": "door.jen", "set": ["key.color=1 0.5 0.5"]}]}
                """);
        for (String picture : PICTURES) {
            runSuccessfully("render", "scenes/bird.jen", "-o", picture, "--size", "30x20");
        }
        runSuccessfully("bench", "scenes/bird.jen", "-o", "old", "--quick", "--figure", "24", "--size", "60x40", "--repetitions", "1");
    }

    @AfterAll
    static void end() throws IOException {
        elsewhere.close();
    }

    private static void runSuccessfully(String... arguments) throws IOException {
        Result result = elsewhere.run(List.of(arguments));
        assertThat(result.exit()).as(result.text()).isZero();
    }

    @Test
    void everyHelpPage_hasExamplesOfItsCommand() {
        List<DocExample> all = DocExample.fromHelp();
        assertThat(HelpPages.all()).hasSizeGreaterThan(15).allSatisfy(page -> assertThat(all)
                .filteredOn(example -> example.source().equals(page.name())).isNotEmpty()
                .allSatisfy(example -> assertThat("lightning " + String.join(" ", example.arguments())).startsWith(page.name())));
    }

    @Test
    void shippedScene_isFoundBesideAnotherFolderOfThatName() throws IOException {
        Path own = Files.createDirectory(folder.resolve("scenes"));
        try {
            runSuccessfully("check", "scenes/bird.jen");
        } finally {
            Files.delete(own);
        }
    }

    @Test
    void smallExample_changesSizeAndRepetitionsOnly() {
        assertThat(
                DocExample.shrink(List.of("shot", "relight", "a.jen", "--size", "900x600", "--cluster", "b", "--set", "c=1", "--no-savings",
                        "-o", "d")))
                .containsExactly("shot", "relight", "a.jen", "--set", "c=1", "-o", "d", "--size", "60x40", "--no-savings");
    }

    @TestFactory
    Stream<DynamicTest> everyExample_succeeds() throws IOException {
        return tests(examples().map(DocExample::small), false);
    }

    /** In the usual check, {@link #everyExample_succeeds} runs them at a small size. */
    @TestFactory
    @Nightly
    Stream<DynamicTest> everyUnchangedExample_succeeds() throws IOException {
        return tests(examples(), false);
    }

    /**
     * Commands that measure take half of the time. In the usual check, {@code BenchCommandTest}, {@code OtherCommandsTest} and {@code
     * JsonReportTest} run them.
     */
    @TestFactory
    @Nightly
    Stream<DynamicTest> everyMeasurement_succeeds() throws IOException {
        return tests(examples(), true);
    }

    private static Stream<DocExample> examples() throws IOException {
        List<DocExample> examples = new ArrayList<>(DocExample.fromHelp());
        for (Path document : DocsTest.pages()) {
            String markdown = Files.readString(document);
            examples.addAll(DocExample.inBlocks(document.toString(), markdown));
            examples.addAll(DocExample.fromIndentedLines(document.toString(), markdown));
        }
        return examples.stream();
    }

    private static Stream<DynamicTest> tests(Stream<DocExample> examples, boolean measurements) {
        Set<List<String>> seen = new HashSet<>();
        return examples.filter(example -> MEASUREMENTS.contains(example.arguments().getFirst()) == measurements)
                .filter(example -> seen.add(example.testArguments()))
                .map(example -> dynamicTest(example.source() + ": " + String.join(" ", example.arguments()), () -> check(example)));
    }

    private static void check(DocExample example) throws IOException {
        try {
            HelpPages.parse(example.arguments());
        } catch (CommandLine.ParameterException e) {
            Assumptions.assumeFalse(MISSING_PROGRAM.matcher(String.valueOf(e.getMessage())).find(), e.getMessage());
            throw e;
        }
        if (example.runsUntilStopped()) {
            return;
        }
        Result result = elsewhere.run(example.testArguments());
        Assumptions.assumeFalse(result.exit() == 2 && MISSING_PROGRAM.matcher(result.text()).find(), result.text());
        if (!(result.exit() == 1 && example.mayFailCheck())) {
            assertThat(result.exit()).as(result.text()).isEqualTo(example.exit());
        }
    }
}
