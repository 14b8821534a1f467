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
import lightning.format.gltf.Gltf;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/**
 * The examples of the help, README.md and the pages in docs work for a user who has the program installed: each is run in a folder that
 * holds nothing but the files that the examples take for the user's own. Those of the help, and those that a document shows indented, are
 * run small.
 */
@Slow
class ExamplesTest {
    /** What is said where another program is not installed. */
    private static final Pattern OTHER_PROGRAM = Pattern.compile("no program povray|program ffmpeg, which is not installed");
    /** A user's files that examples read. */
    private static final List<String> PICTURES = List.of("before.png", "after.png", "before.pfm", "after.pfm");

    @TempDir
    private static Path folder;

    private static ExampleProcess elsewhere;

    @BeforeAll
    static void start() throws IOException {
        elsewhere = new ExampleProcess(folder);
        Files.write(folder.resolve("house.glb"), Gltf.binary(Gltf.LIT_JSON, Gltf.SQUARE));
        done("import", "house.glb", "-o", "house.jen", "--light-units", "candela");
        for (String picture : PICTURES) {
            done("render", "scenes/bird.jen", "-o", picture, "--size", "20x20");
        }
        done("bench", "scenes/bird.jen", "-o", "old", "--quick", "--figure", "24", "--size", "60x40", "--repetitions", "1");
    }

    @AfterAll
    static void end() throws IOException {
        elsewhere.close();
    }

    private static void done(String... arguments) throws IOException {
        Result result = elsewhere.run(List.of(arguments));
        assertThat(result.exit()).as(result.text()).isZero();
    }

    @Test
    void everyHelpPage_showsExamplesOfItsCommand() {
        List<Example> all = Example.ofHelp();
        assertThat(HelpPages.all()).hasSizeGreaterThan(15).allSatisfy(page -> assertThat(all)
                .filteredOn(example -> example.where().equals(page.name())).isNotEmpty()
                .allSatisfy(example -> assertThat("lightning " + String.join(" ", example.arguments())).startsWith(page.name())));
    }

    @Test
    void smallExample_differsInSizeAndRepetitionsOnly() {
        assertThat(Example.small(List.of("shot", "relight", "a.jen", "--size", "900x600", "--cluster", "b", "--set", "c=1", "--no-savings",
                "-o", "d"))).containsExactly("shot", "relight", "a.jen", "--set", "c=1", "-o", "d", "--size", "60x40", "--no-savings");
    }

    @TestFactory
    Stream<DynamicTest> everyExample_works() throws IOException {
        List<Example> examples = new ArrayList<>(Example.ofHelp());
        for (Path document : DocsTest.pages()) {
            String markdown = Files.readString(document);
            examples.addAll(Example.inBlocksOf(document.toString(), markdown));
            examples.addAll(Example.indentedIn(document.toString(), markdown));
        }
        Set<List<String>> seen = new HashSet<>();
        return examples.stream().filter(example -> seen.add(example.tested()))
                .map(example -> dynamicTest(example.where() + ": " + String.join(" ", example.arguments()), () -> check(example)));
    }

    private static void check(Example example) throws IOException {
        HelpPages.parse(example.arguments());
        if (example.goesOn()) {
            return;
        }
        Result result = elsewhere.run(example.tested());
        Assumptions.assumeFalse(result.exit() == 2 && OTHER_PROGRAM.matcher(result.text()).find(), result.text());
        if (!(result.exit() == 1 && example.mayFailItsCheck())) {
            assertThat(result.exit()).as(result.text()).isEqualTo(example.exit());
        }
    }
}
