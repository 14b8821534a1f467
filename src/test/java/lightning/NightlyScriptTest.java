package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.sample.Slow;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code .ci/nightly} in a small repository, with a script in place of Maven. */
@DisabledOnOs(OS.WINDOWS)
@Slow
class NightlyScriptTest {
    private static final String PASSED = """
            mkdir -p target/surefire-reports
            echo '<testsuite name="A" time="1" tests="5" errors="0" skipped="2" failures="0">' >target/surefire-reports/TEST-A.xml
            """;
    /** A test that does not end, with a process of its own. */
    private static final String ENDLESS = PASSED + """
            sleep 600 &
            echo $! >child.new
            mv child.new child
            wait
            """;

    @TempDir
    private Path folder;

    private Path document;

    @BeforeEach
    void createRepository() throws Exception {
        document = Files.createDirectories(folder.resolve("docs")).resolve("nightly.md");
        Files.copy(Path.of("pom.xml"), folder.resolve("pom.xml"));
        for (String name : List.of("scene", "format/jen")) {
            Path classes = Files.createDirectories(folder.resolve("src/main/java/lightning").resolve(name));
            for (int i = 0; i < 10; i++) {
                Files.createFile(classes.resolve("C" + i + ".java"));
            }
        }
        Files.writeString(Files.createDirectories(folder.resolve("src/test/java/lightning")).resolve("ATest.java"),
                "@Property\n@Nightly\nimport lightning.sample.ByteFuzzer;\n");
        Files.createDirectories(folder.resolve(".ci"));
        Files.copy(Path.of(".ci/nightly"), folder.resolve(".ci/nightly"));
        Files.writeString(folder.resolve(".gitignore"), "target/\nchild\narguments\n");
        maven(PASSED);
        assertThat(start("git", "init", "-q").waitFor()).isZero();
        commit();
    }

    @Test
    void partWithoutResult_isNext() throws Exception {
        assertThat(nightly("models", "mutation-scene")).isZero();
        assertThat(nightly("next")).isZero();
        assertThat(parts()).containsExactly("models", "mutation-scene", "mutation-jen");
    }

    @Test
    void partWithOldestResult_isNext() throws Exception {
        List<String> all = Stream.of(output("list").split("\n")).map(line -> line.strip().split(" ")[0]).toList();
        assertThat(all).contains("models", "fuzzers").hasSizeGreaterThan(9);
        rows(Stream.concat(all.stream().filter(part -> !part.equals("fuzzers")), Stream.of("fuzzers", all.getFirst())).toList());
        assertThat(nightly("next")).isZero();
        assertThat(parts().getLast()).isEqualTo(all.get(1));
    }

    @Test
    void passedPart_isAppendedWithCommitAndCounts() throws Exception {
        rows(List.of("models"));
        assertThat(nightly("packaged")).isZero();
        assertThat(lastRow()).startsWith("| packaged | " + head() + " | ").endsWith(" | passed | 5 tests, 0 failed, 2 skipped |");
        assertThat(parts()).containsExactly("models", "packaged");
    }

    @Test
    void failedPart_namesTheTests() throws Exception {
        maven(PASSED.replace("failures=\"0\">", "failures=\"1\">\n<testcase name=\"a|b\" classname=\"lightning.x.CTest\" time=\"1\">"
                + "\n<failure message=\"m\">") + "exit 1\n");
        assertThat(nightly("packaged")).isEqualTo(1);
        assertThat(lastRow()).contains(", changed | ").endsWith(" | failed | 5 tests, 1 failed (CTest.a/b), 2 skipped |");
    }

    @Test
    void partAfterTheLimit_isStoppedWithItsProcesses() throws Exception {
        maven(ENDLESS);
        assertThat(nightly("models")).isEqualTo(1);
        assertThat(lastRow()).endsWith(" | stopped after 0 minutes | 5 tests, 0 failed, 2 skipped |");
        assertThat(isChildAlive()).isFalse();
    }

    @Test
    void stoppedPart_saysHowManyOfItsClassesEnded() throws Exception {
        maven(ENDLESS);
        assertThat(nightly("fuzzers")).isEqualTo(1);
        assertThat(lastRow()).endsWith(" | stopped after 0 minutes | 1 of 1 classes, 5 tests, 0 failed, 2 skipped |");
    }

    @Test
    void stoppedPartWithoutAnEndedClass_saysSo() throws Exception {
        maven("sleep 600\n");
        assertThat(nightly("fuzzers")).isEqualTo(1);
        assertThat(lastRow()).endsWith(" | stopped after 0 minutes | no test ended |");
    }

    @Test
    void killedPart_leavesNoResultAndIsNextAgain() throws Exception {
        maven(ENDLESS);
        Process killed = start("env", "-u", "LIGHTNING_NIGHT_SMOKE", "LIGHTNING_NIGHT_MINUTES=60", ".ci/nightly", "next");
        while (!Files.exists(folder.resolve("child"))) {
            assertThat(killed.isAlive()).isTrue();
            Thread.sleep(20);
        }
        killed.destroyForcibly().waitFor();
        assertThat(isChildAlive()).isTrue();
        assertThat(parts()).isEmpty();
        maven(PASSED);
        assertThat(nightly("next")).isZero();
        assertThat(isChildAlive()).isFalse();
        assertThat(parts()).containsExactly("mutation-scene");
    }

    /** The shares are computed from both turns: 2 + 2 mutants, of which 1 survived and 1 is not covered. */
    @Test
    void mutationPart_takesTheNextTurn() throws Exception {
        maven("""
                mkdir -p target/mutation/jen
                echo "$3" >>arguments
                printf 'A.java,A,m,f,1,KILLED,t\\nA.java,A,m,f,1,%s,none\\nA.java,A,m,f,2,KIL' "$(test -s once && echo SURVIVED || echo NO_COVERAGE)" \\
                  >target/mutation/jen/mutations.csv
                echo 1 >once
                """);
        assertThat(nightly("mutation-jen", "mutation-jen")).isZero();
        assertThat(lastRow()).endsWith(" | turn 2 of 8: 2 mutants, 1 survived, 0 not covered, 0 timed out |");
        assertThat(document).content().contains("| jen | 2 of 8 | 4 | 1 | 1 | 50.0 % |\n");
        assertThat(folder.resolve("arguments")).content().isEqualTo("-Dmutated.jen=lightning.format.jen.C0,lightning.format.jen.C0$*,"
                + "lightning.format.jen.C8,lightning.format.jen.C8$*\n-Dmutated.jen=lightning.format.jen.C1,lightning.format.jen.C1$*,"
                + "lightning.format.jen.C9,lightning.format.jen.C9$*\n");
    }

    @Test
    void unknownPart_runsNothing() throws Exception {
        assertThat(output("models", "nothing")).startsWith("nightly: expected a part, found 'nothing'");
        assertThat(parts()).isEmpty();
    }

    private void maven(String commands) throws IOException {
        Path script = Files.writeString(folder.resolve(".ci/run"), "#!/usr/bin/env bash\n" + commands);
        assertThat(script.toFile().setExecutable(true)).isTrue();
    }

    private void rows(List<String> parts) throws Exception {
        Files.writeString(document, String.join("", parts.stream().map(part -> "| " + part
                + " | 0123456789ab | 2026-01-01 | 1 | m | passed | 1 tests, 0 failed, 0 skipped |\n").toList()));
    }

    private List<String> parts() throws IOException {
        try (Stream<String> lines = Files.lines(document)) {
            return lines.filter(line -> line.matches("\\| [a-z-]+ \\| [0-9a-f]{12}.*")).map(line -> line.split(" ")[1]).toList();
        }
    }

    private String lastRow() throws IOException {
        return Files.readAllLines(document).getLast();
    }

    private boolean isChildAlive() throws IOException {
        long id = Long.parseLong(Files.readString(folder.resolve("child")).strip());
        return ProcessHandle.of(id).filter(ProcessHandle::isAlive).isPresent();
    }

    private void commit() throws Exception {
        assertThat(start("git", "add", "-A").waitFor()).isZero();
        assertThat(start("git", "-c", "user.name=a", "-c", "user.email=a@b", "commit", "-q", "-m", "a").waitFor()).isZero();
    }

    private String head() throws Exception {
        return new String(start("git", "rev-parse", "--short=12", "HEAD").getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
    }

    private int nightly(String... arguments) throws Exception {
        Process process = nightlyProcess(arguments);
        assertThat(process.waitFor(1, TimeUnit.MINUTES)).isTrue();
        return process.exitValue();
    }

    private String output(String... arguments) throws Exception {
        return new String(nightlyProcess(arguments).getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    }

    /** A limit of 0 minutes ends each part that takes longer than a second. */
    private Process nightlyProcess(String... arguments) throws IOException {
        return start(Stream
                .concat(Stream.of("env", "-u", "LIGHTNING_NIGHT_SMOKE", "LIGHTNING_NIGHT_MINUTES=0", ".ci/nightly"), Stream.of(arguments))
                .toArray(String[]::new));
    }

    private Process start(String... command) throws IOException {
        return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    }
}
