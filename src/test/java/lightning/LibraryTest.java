package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compiles and runs the example of docs/library.md in a module of its own, which sees only exported packages. */
class LibraryTest {
    /** Libraries of the module; those of the tests are not modules. */
    private static final Pattern LIBRARY =
            Pattern.compile(
                    ".*(picocli|diff-utils|jackson|javafx|atlantafx|ikonli|drako|qrcodegen|ojalgo|imageio-|common-|jgroups)[^/\\\\]*\\.jar");

    @TempDir
    Path folder;

    @Test
    void example_compilesAndRuns() throws IOException, InterruptedException {
        Matcher code = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL).matcher(Files.readString(Path.of("docs/library.md")));
        assertThat(code.find()).isTrue();
        Path example = Files.writeString(folder.resolve("Example.java"), "package example;\n" + code.group(1));
        Path module = Files.writeString(folder.resolve("module-info.java"), "module example { requires lightning; }");
        Path classes = folder.resolve("classes");
        String path = Stream.concat(Stream.of("target/classes"),
                Stream.of(System.getProperty("java.class.path").split(File.pathSeparator)).filter(jar -> LIBRARY.matcher(jar).matches()))
                .collect(Collectors.joining(File.pathSeparator));
        run("javac", "-p", path, "-d", classes.toString(), module.toString(), example.toString());
        Path image = folder.resolve("brighter.png");
        // Anti-aliasing casts shadow rays for the samples of new edges.
        Path plain =
                Files.writeString(folder.resolve("bird.jen"), Files.readString(Path.of("scenes/bird.jen")).replace("antialias edges", ""));
        String printed =
                run("java", "-Xmx512m", "-Dlightning.warmup=0", "-p", path + File.pathSeparator + classes, "-m", "example/example.Example",
                        plain.toString(), image.toString());
        assertThat(printed).contains("0 shadow rays");
        assertThat(image).isNotEmptyFile();
    }

    private static String run(String tool, String... arguments) throws IOException, InterruptedException {
        Process process = new ProcessBuilder(Stream.concat(Stream.of(Path.of(System.getProperty("java.home"), "bin", tool).toString()),
                Stream.of(arguments)).toList()).redirectErrorStream(true).start();
        String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(text).isZero();
        return text;
    }
}
