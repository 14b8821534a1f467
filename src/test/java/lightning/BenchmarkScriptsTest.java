package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import lightning.sample.Slow;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the programs of {@code benchmarks}, which are compiled against a build when they are used. */
@Slow
class BenchmarkScriptsTest {
    @TempDir
    private Path classes;

    /** Compiles them together, because some use others. */
    @Test
    void programs_compileAgainstTheBuild() throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        DiagnosticCollector<JavaFileObject> problems = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(problems, null, null)) {
            String path = System.getProperty("java.class.path") + File.pathSeparator + System.getProperty("jdk.module.path", "");
            List<String> options = List.of("-nowarn", "-proc:none", "-d", classes.toString(), "-cp", path);
            compiler.getTask(null, files, problems, options, null, files.getJavaFileObjectsFromPaths(programs())).call();
        }
        assertThat(problems.getDiagnostics()).filteredOn(problem -> problem.getKind() == Diagnostic.Kind.ERROR).isEmpty();
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void windowOfWrongFolder_isOneSentence() throws Exception {
        Path build = Files.createDirectory(classes.resolve("build"));
        assertThat(runWindow(build, "true", "true")).isEqualTo("window: " + build
                + ": expected a folder like target/lightning, found none of its files lib/lightning.jar and bin/java.options\n");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void windowOfOtherVersion_namesTheFirstCompilerError() throws Exception {
        String compiler = "for i in 1 2; do echo \"A.java:$i: error: cannot find symbol $i\" >&2; done; exit 1";
        assertThat(runWindow(build(), compiler, "true")).hasLineCount(1).contains("is of another version")
                .endsWith("A.java:1: error: cannot find symbol 1\n");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void windowWithoutDisplay_namesTheReason() throws Exception {
        String java = "echo 'java.lang.UnsupportedOperationException: Unable to load glass GTK library.' >&2; exit 1";
        assertThat(runWindow(build(), "true", java)).hasLineCount(2).contains("making an archive\n", "the measurement 'empty' failed: "
                + "Unable to load glass GTK library.", "libgtk-3-0");
    }

    /** Creates a program folder whose archive is never made. */
    private Path build() throws IOException {
        Path build = classes.resolve("build");
        Files.createFile(Files.createDirectories(build.resolve("lib")).resolve("lightning.jar"));
        Files.writeString(Files.createDirectories(build.resolve("bin")).resolve("java.options"), "-Xmx1g\n");
        writeProgram(build.resolve("bin/make-archive"), "true");
        return build;
    }

    /** Returns what benchmarks/window prints, with shell commands in place of the compiler and of Java. */
    private String runWindow(Path build, String compiler, String java) throws Exception {
        Path home = classes.resolve("java");
        Files.createDirectories(home.resolve("bin"));
        Files.writeString(home.resolve("release"), "JAVA_VERSION=\"25.0.1\"\n");
        writeProgram(home.resolve("bin/javac"), compiler);
        writeProgram(home.resolve("bin/java"), java);
        var script = new ProcessBuilder("benchmarks/window", build.toString(), "1", "scene.jen").redirectErrorStream(true);
        script.environment().put("JAVA_HOME", home.toString());
        Process process = script.start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(out).isIn(1, 2);
        return out;
    }

    private static void writeProgram(Path file, String commands) throws IOException {
        Files.writeString(file, "#!/usr/bin/env bash\n" + commands + "\n");
        assertThat(file.toFile().setExecutable(true)).isTrue();
    }

    /** Neither JAVA_HOME nor JAVA25_HOME is set; Java is in a standard location. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void scripts_findJavaLikeTheLauncher() throws Exception {
        Path home = Files.createDirectories(classes.resolve("home"));
        Path java = Files.createDirectories(home.resolve(".sdkman/candidates/java/25/bin")).resolve("java");
        for (Path program : List.of(java, java.resolveSibling("javac"))) {
            assertThat(Files.createFile(program).toFile().setExecutable(true)).isTrue();
        }
        Files.writeString(home.resolve(".sdkman/candidates/java/25/release"), "JAVA_VERSION=\"25.0.1\"\n");
        var script = new ProcessBuilder("bash", "-c", "set -euo pipefail; here=$PWD/benchmarks; . benchmarks/two-builds; echo $java")
                .redirectErrorStream(true);
        script.environment().clear();
        script.environment().putAll(Map.of("HOME", home.toString(), "PATH", "/usr/bin:/bin"));
        Process process = script.start();
        String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertThat(process.waitFor()).as(out).isZero();
        assertThat(out.strip()).endsWith("/bin/java");
    }

    /** The scripts {@code corpus}, {@code beside-cycles}, {@code fog-beside-cycles}, {@code gallery-pictures} and {@code peers} only start an assembled program. */
    @Test
    void everyScript_usesTheSameJavaLookup() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("benchmarks"))) {
            assertThat(files.filter(Files::isExecutable).filter(Files::isRegularFile)
                    .filter(file -> !file.endsWith("run") && !file.endsWith("corpus") && !file.endsWith("beside-cycles")
                            && !file.endsWith("fog-beside-cycles") && !file.endsWith("gallery-pictures") && !file.endsWith("peers")))
                    .isNotEmpty().allSatisfy(file -> assertThat(file).content().contains(". \"$here/two-builds\"").doesNotContain("_HOME"));
        }
    }

    private static List<Path> programs() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("benchmarks"))) {
            return files.filter(file -> file.toString().endsWith(".java")).sorted().toList();
        }
    }
}
