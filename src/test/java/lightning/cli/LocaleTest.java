package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import lightning.sample.DefaultLocale;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** All commands in locales with other digits (Egypt), case rules (Turkey) or decimal points (Germany) than English. */
@Slow
class LocaleTest {
    @TempDir
    private static Path shared;

    private static Path scene;
    private static Path outputs;
    private static List<String> expected;

    @TempDir
    private Path folder;

    @BeforeAll
    static void runInRootLocale() throws Exception {
        scene = CliResult.scene(shared);
        outputs = Files.createDirectory(shared.resolve("here"));
        expected = DefaultLocale.during(Locale.ROOT, () -> exactCommands(scene, outputs));
    }

    static Stream<Locale> locales() {
        return Stream.of(Locale.of("ar", "EG"), Locale.of("tr", "TR"), Locale.GERMANY);
    }

    @ParameterizedTest
    @MethodSource("locales")
    void filesAndOutput_areLocaleIndependent(Locale locale) throws Exception {
        Path abroad = Files.createDirectory(folder.resolve("abroad"));
        assertThat(DefaultLocale.during(locale, () -> exactCommands(scene, abroad))).isEqualTo(expected);
        assertThat(names(outputs)).hasSizeGreaterThan(6).isEqualTo(names(abroad));
        for (String file : names(outputs)) {
            assertThat(abroad.resolve(file)).hasSameBinaryContentAs(outputs.resolve(file));
        }
    }

    /** Returns the output of commands without measurements; folders and times are replaced. */
    private static List<String> exactCommands(Path scene, Path to) {
        List<String> output = new ArrayList<>();
        run(output, to, "check", scene);
        for (String picture : List.of("a.xpm", "a.png", "a.pfm")) {
            run(output, to, "render", scene, "-o", to.resolve(picture), "--antialias", "edges", "--samples", "2");
        }
        run(output, to, "relight", scene, "-o", to.resolve("b.png"), "--accuracy", "ratio", "--reflections", "current", "--storage",
                "shapes",
                "--set", "lamp.intensity=0.25", "--then", "--set", "lamp.type=directional", "--verify", "--save", to.resolve("b.jen"));
        run(output, to, "compare", to.resolve("a.png"), to.resolve("b.png"), "-o", to.resolve("d.png"));
        run(output, to, "explain", scene, "20,20");
        run(output, to, "export", scene, "-o", to.resolve("a.pov"));
        Path lit = to.resolve("indirect.jen");
        run(output, to, "relight", scene, "-o", to.resolve("c.pfm"), "--set", "picture.indirect={ rays 16 }", "--then", "--set",
                "lamp.intensity=0.25", "--verify", "--save", lit);
        run(output, to, "render", lit, "-o", to.resolve("indirect.pfm"));
        assertThat(output.stream().filter(text -> !text.startsWith("0\n"))).singleElement().asString().startsWith("1\ndifferent: ");
        run(output, to, "check", to.resolve("missing.jen"));
        run(output, to, "RENDER");
        run(output, to, "--help");
        return output;
    }

    private static void run(List<String> output, Path folder, Object... arguments) {
        CliResult done = CliResult.run(arguments);
        output.add(done.exit() + "\n"
                + (done.out() + done.err()).replace(folder.toString(), "FOLDER").replaceAll("-?\\d+\\.\\d+|-?\\d+(?= (ms|%))", "TIME"));
    }

    /** Egypt's digits differ from ASCII digits; {@link BenchCommandTest} covers the slowest command. */
    @Test
    void measurements_useAsciiDigits() throws Exception {
        assertThat(DefaultLocale.during(Locale.of("ar", "EG"), () -> List.of(
                CliResult.run("tour", scene, "-o", folder.resolve("tour"), "--size", "24x16", "--repetitions", "1").assertSuccess().out(),
                CliResult.run("effects", scene, "--repetitions", "1").assertSuccess().out())))
                .allSatisfy(LocaleTest::assertAsciiDigits);
    }

    static void assertAsciiDigits(String text) {
        assertThat(text).containsPattern("[0-9]").doesNotContainPattern("[\\p{Nd}&&[^0-9]]");
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
