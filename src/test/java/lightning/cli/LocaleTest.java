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
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** All commands under locales whose digits (Egypt), upper and lower case (Turkey) or decimal point (Germany) are not those of English. */
@Slow
class LocaleTest {
    @TempDir
    private Path folder;

    static Stream<Locale> locales() {
        return Stream.of(Locale.of("ar", "EG"), Locale.of("tr", "TR"), Locale.GERMANY);
    }

    @ParameterizedTest
    @MethodSource("locales")
    void filesAndWords_areTheSameInEveryLocale(Locale locale) throws Exception {
        Path scene = Cli.scene(folder);
        Path here = Files.createDirectory(folder.resolve("here"));
        Path abroad = Files.createDirectory(folder.resolve("abroad"));
        List<String> expected = DefaultLocale.during(Locale.ROOT, () -> exactCommands(scene, here));
        assertThat(DefaultLocale.during(locale, () -> exactCommands(scene, abroad))).isEqualTo(expected);
        assertThat(names(here)).hasSizeGreaterThan(6).isEqualTo(names(abroad));
        for (String file : names(here)) {
            assertThat(abroad.resolve(file)).hasSameBinaryContentAs(here.resolve(file));
        }
    }

    /** What commands say that measure nothing; folders and times taken out. */
    private static List<String> exactCommands(Path scene, Path to) {
        List<String> said = new ArrayList<>();
        run(said, to, "check", scene);
        for (String picture : List.of("a.xpm", "a.png", "a.pfm")) {
            run(said, to, "render", scene, "-o", to.resolve(picture), "--antialias", "edges", "--samples", "2");
        }
        run(said, to, "relight", scene, "-o", to.resolve("b.png"), "--accuracy", "ratio", "--reflections", "current", "--storage", "shapes",
                "--set", "lamp.intensity=0.25", "--then", "--set", "lamp.type=directional", "--verify", "--save", to.resolve("b.jen"));
        run(said, to, "compare", to.resolve("a.png"), to.resolve("b.png"), "-o", to.resolve("d.png"));
        run(said, to, "explain", scene, "20,20");
        run(said, to, "export", scene, "-o", to.resolve("a.pov"));
        assertThat(said.stream().filter(text -> !text.startsWith("0\n"))).singleElement().asString().startsWith("1\ndifferent: ");
        run(said, to, "check", to.resolve("missing.jen"));
        run(said, to, "RENDER");
        run(said, to, "--help");
        return said;
    }

    private static void run(List<String> said, Path folder, Object... arguments) {
        Cli done = Cli.run(arguments);
        said.add(done.exit() + "\n"
                + (done.out() + done.err()).replace(folder.toString(), "FOLDER").replaceAll("-?\\d+\\.\\d+|-?\\d+(?= (ms|%))", "TIME"));
    }

    /** Egypt's digits are the ones that can be told from plain ones; {@link BenchCommandTest} asks the same of what takes longest. */
    @Test
    void measurements_areWrittenInPlainDigits() throws Exception {
        Path scene = Cli.scene(folder);
        assertThat(DefaultLocale.during(Locale.of("ar", "EG"), () -> List.of(
                Cli.run("tour", scene, "-o", folder.resolve("tour"), "--size", "24x16", "--repetitions", "1").isDone().out(),
                Cli.run("effects", scene, "--repetitions", "1").isDone().out())))
                .allSatisfy(LocaleTest::assertPlainDigits);
    }

    static void assertPlainDigits(String text) {
        assertThat(text).containsPattern("[0-9]").doesNotContainPattern("[\\p{Nd}&&[^0-9]]");
    }

    private static List<String> names(Path folder) throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
