package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.tools.Diagnostic;
import javax.tools.DiagnosticCollector;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The programs of {@code benchmarks}, which are compiled against a build when they are used, long after it was made. */
class BenchmarksTest {
    @TempDir
    private Path classes;

    /** Together, as some know others. */
    @Test
    void programs_fitTheBuildThatTheyMeasure() throws IOException {
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        DiagnosticCollector<JavaFileObject> problems = new DiagnosticCollector<>();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(problems, null, null)) {
            String path = System.getProperty("java.class.path") + File.pathSeparator + System.getProperty("jdk.module.path", "");
            List<String> options = List.of("-nowarn", "-proc:none", "-d", classes.toString(), "-cp", path);
            compiler.getTask(null, files, problems, options, null, files.getJavaFileObjectsFromPaths(programs())).call();
        }
        assertThat(problems.getDiagnostics()).filteredOn(problem -> problem.getKind() == Diagnostic.Kind.ERROR).isEmpty();
    }

    private static List<Path> programs() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("benchmarks"))) {
            return files.filter(file -> file.toString().endsWith(".java")).sorted().toList();
        }
    }
}
