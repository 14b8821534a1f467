package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import lightning.base.work.Await;
import lightning.sample.Slow;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests the launcher script, with scripts in place of Java that report their arguments. */
@DisabledOnOs(OS.WINDOWS)
@Slow
class LauncherTest {
    private static final String WARNING = "WARNING: Using incubator modules: jdk.incubator.vector";

    /** Runs its arguments; cat waits for the filter, which may end after the program. */
    private static final String STDERR_OF_LAST_START =
            "{ \"$@\" 2>&1 >&3 | cat >\"$ERR\"; } 3>&1; exit ${PIPESTATUS[0]}";

    @TempDir
    private Path folder;

    private Path launcher;

    private record Result(int code, String out, String err) {}

    @BeforeEach
    void install() throws IOException {
        launcher = folder.resolve("installed here/bin/lightning");
        Files.createDirectories(launcher.getParent());
        String script = Files.readString(Path.of("src/main/launcher/lightning"));
        String withoutInstalledJava = script.replace("/usr/lib/jvm", folder + "/jvm")
                .replace("/Library/Java", folder + "/Library");
        Files.writeString(launcher, withoutInstalledJava);
        assertThat(launcher.toFile().setExecutable(true)).isTrue();
        Files.copy(Path.of("src/main/launcher/java.options"), launcher.resolveSibling("java.options"));
        Files.copy(Path.of("src/main/launcher/render.options"), launcher.resolveSibling("render.options"));
        Files.copy(Path.of("src/main/launcher/picture.options"), launcher.resolveSibling("picture.options"));
        Files.copy(Path.of("src/main/launcher/make-archive"), launcher.resolveSibling("make-archive"));
    }

    @Test
    void arguments_arePassedUnchanged() throws Exception {
        Path java = java("25.0.1", "printf '[%s]' \"$@\"");
        Result result = run(Map.of("JAVA_HOME", java), "", launcher, "render", "a b.jen", "*", "");
        assertThat(result.out()).endsWith("[lightning.Main][render][a b.jen][*][]");
    }

    @Test
    void home_throughSymbolicLinks_isFound() throws Exception {
        Path java = java("25", "printf '[%s]' \"$@\"");
        Path elsewhere = Files.createDirectory(folder.resolve("elsewhere"));
        Files.createSymbolicLink(elsewhere.resolve("first"), Path.of("../installed here/bin/lightning"));
        Path second = Files.createSymbolicLink(folder.resolve("second"), Path.of("elsewhere/first"));
        Result result = run(Map.of("JAVA_HOME", java), "", second);
        assertThat(result.out()).contains("[-Dlightning.home=" + folder.toRealPath() + "/installed here]");
    }

    @Test
    void home_withConflictingCdpath_isFound() throws Exception {
        Path java = java("25", "printf '[%s]' \"$@\"");
        Files.createDirectories(folder.resolve("elsewhere/installed here/bin"));
        Result result = run(Map.of("JAVA_HOME", java, "CDPATH", folder.resolve("elsewhere")), "", Path.of("installed here/bin/lightning"));
        assertThat(result.out()).contains("[-Dlightning.home=" + folder.toRealPath() + "/installed here]");
    }

    @Test
    void pathWithColon_isRejectedWithExitCode2() throws Exception {
        Path java = java("25", "echo started");
        Path there = Files.move(launcher.getParent().getParent(), folder.resolve("a:b"));
        Result result = run(Map.of("JAVA_HOME", java), "", there.resolve("bin/lightning"));
        assertThat(result).isEqualTo(new Result(2, "", "lightning: " + there.toRealPath()
                + ": Java cannot run from a folder with ':' in its path; move or rename it.\n"));
    }

    @ParameterizedTest
    @ValueSource(strings = {"JAVA_TOOL_OPTIONS", "JDK_JAVA_OPTIONS", "_JAVA_OPTIONS"})
    void userCollector_replacesDefault(String variable) throws Exception {
        Path options = Path.of("-XX:+UseSerialGC");
        Result result = run(Map.of("JAVA_HOME", realJava(), variable, options), "", launcher, "--version");
        // The program is not next to the launcher; Java itself got as far as looking for it.
        assertThat(result.out() + result.err()).contains("lightning").doesNotContain("Conflicting", "does not start");
    }

    @ParameterizedTest
    @ValueSource(strings = {"render", "bench"})
    void commands_useG1(String command) throws Exception {
        Path java = java("25", "printf '[%s]' \"$@\"");
        String out = run(Map.of("JAVA_HOME", java), "", launcher, command).out();
        assertThat(out).contains("[-XX:+UseG1GC]").containsOnlyOnce("GC]");
    }

    /** With the serial or parallel collector, the program of this test does not end. */
    @ParameterizedTest
    @ValueSource(strings = {"java.options", "picture.options"})
    void damagedJpegs_doNotLockJava(String options) throws Exception {
        Process java = new ProcessBuilder(realJava().resolve("bin/java").toString(), "@src/main/launcher/" + options, "-Xmx64m", "-Xmn2m",
                "-cp", System.getProperty("java.class.path"), DamagedJpegs.class.getName())
                .redirectErrorStream(true).redirectOutput(folder.resolve("out").toFile()).start();
        try {
            assertThat(java.waitFor(3, TimeUnit.MINUTES)).isTrue();
            assertThat(java.exitValue()).as(Files.readString(folder.resolve("out"))).isZero();
        } finally {
            java.destroyForcibly();
        }
    }

    @Test
    void invalidUserOptions_exitWithCode2() throws Exception {
        Result result = run(Map.of("JAVA_HOME", realJava(), "JAVA_TOOL_OPTIONS", Path.of("-XX:+NoSuchThing")), "", launcher);
        assertThat(result.code()).isEqualTo(2);
        assertThat(result.out()).isEmpty();
        assertThat(result.err()).startsWith("lightning: Java does not start with JAVA_TOOL_OPTIONS").contains("NoSuchThing")
                .hasLineCount(1);
    }

    @Test
    void programOptions_areAcceptedByJava() throws Exception {
        Process java = new ProcessBuilder(realJava().resolve("bin/java").toString(), "@src/main/launcher/java.options", "-version")
                .redirectErrorStream(true).start();
        assertThat(new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8)).doesNotContain("Unrecognized", "warning");
        assertThat(java.waitFor()).isZero();
    }

    @ParameterizedTest
    @ValueSource(strings = {"render.options", "picture.options"})
    void renderOptions_areAcceptedByJava(String options) throws Exception {
        Process java = new ProcessBuilder(realJava().resolve("bin/java").toString(), "@src/main/launcher/" + options, "-version")
                .redirectErrorStream(true).start();
        assertThat(new String(java.getInputStream().readAllBytes(), StandardCharsets.UTF_8)).doesNotContain("Unrecognized", "warning");
        assertThat(java.waitFor()).isZero();
    }

    @ParameterizedTest
    @CsvSource({"node, true", "shot --cluster host:7800, true", "shot --cluster=host:7800, true", "render, false", "a-node.jen, false"})
    void clusterCommands_rejectSerializedObjects_andLoadClusterLibrariesLast(String words, boolean given)
            throws Exception {
        Path java = java("25", "printf '[%s]' \"$@\"");
        String home = folder.toRealPath() + "/installed here";
        String out = run(Map.of("JAVA_HOME", java), "", launcher, words.split(" ")).out();
        assertThat(out.contains("[-Djdk.serialFilter=!*]")).isEqualTo(given);
        assertThat(out).contains("[-cp][" + home + "/lib/*:" + home + "/cluster/*]");
    }

    @ParameterizedTest
    @CsvSource({"render, true", "relight, false", "scene.jen, false"})
    void renderOptions_applyToRenderOnly(String command, boolean given) throws Exception {
        Path java = java("25", "printf '[%s]' \"$@\"");
        assertThat(run(Map.of("JAVA_HOME", java), "", launcher, command).out().contains("[-XX:Tier4BackEdgeThreshold=800000]"))
                .isEqualTo(given);
    }

    @Test
    void noUserOptions_startJavaOnce() throws Exception {
        Path java = java("25", "echo started");
        assertThat(run(Map.of("JAVA_HOME", java), "", launcher).out()).isEqualTo("started\n");
    }

    @ParameterizedTest
    @CsvSource({"java.base jdk.incubator.vector, true", "jdk.incubator.vector java.base, true", "java.base java.desktop, false",
        "java.base jdk.incubator.vectors, false"})
    void vectorModule_isAddedIfAvailable(String modules, boolean asked) throws Exception {
        Path java = java("25", "printf '[%s]' \"$@\"");
        Files.writeString(java.resolve("release"), "MODULES=\"" + modules + "\"\n", StandardOpenOption.APPEND);
        assertThat(run(Map.of("JAVA_HOME", java), "", launcher).out().contains("[--add-modules=jdk.incubator.vector]")).isEqualTo(asked);
    }

    @Test
    void javaWithoutModuleList_getsVectorModule() throws Exception {
        Path java = java("25", "printf '[%s]' \"$@\"");
        assertThat(run(Map.of("JAVA_HOME", java), "", launcher).out()).contains("[--add-modules=jdk.incubator.vector]");
    }

    @Test
    void asciiLocale_becomesUtf8() throws Exception {
        Path java = java("25", "printf '%s' \"$LC_ALL\"");
        assertThat(run(Map.of("JAVA_HOME", java, "LC_ALL", Path.of("C")), "", launcher).out()).isEqualTo("C.UTF-8");
    }

    @Test
    void utf8Locale_isUnchanged() throws Exception {
        Path java = java("25", "printf '%s' \"$LC_ALL\"");
        assertThat(run(Map.of("JAVA_HOME", java, "LC_ALL", Path.of("C.utf8")), "", launcher).out()).isEqualTo("C.utf8");
    }

    /** Reports its arguments; creates the requested archive. */
    private static final String ARCHIVING_JAVA = """
            for option in "$@"; do
              case $option in -XX:ArchiveClassesAtExit=* | -XX:AOTCacheOutput=*) archive=${option#*=} ;; esac
            done
            case "$*" in
              *-XX:AOTCacheOutput=*) printf archive >"$archive" ;;
              *-XX:ArchiveClassesAtExit=*) echo "$*" >>"$HOME/making"; printf archive >"$archive" ;;
              *) printf '[%s]' "$@" ;;
            esac""";

    private Map<String, Path> archiving() throws IOException {
        Files.createDirectories(launcher.resolve("../../lib").normalize());
        Files.writeString(launcher.resolve("../../lib/lightning.jar").normalize(), "classes");
        return Map.of("JAVA_HOME", java("25", ARCHIVING_JAVA), "XDG_CACHE_HOME", folder.resolve("cache"), "PATH", toolsOfArchives());
    }

    /** Returns the archive that a first start created in the background. */
    private Path archiveOf(Map<String, Path> variables) throws Exception {
        assertThat(run(variables, "", launcher).out()).doesNotContain("SharedArchive");
        Await.until("an archive is made", () -> archives().size() == 1 && !Files.exists(Path.of(archives().getFirst() + ".making")));
        return archives().getFirst();
    }

    private List<Path> archives() throws IOException {
        Path cache = folder.resolve("cache/lightning");
        if (!Files.exists(cache)) {
            return List.of();
        }
        try (Stream<Path> files = Files.list(cache)) {
            return files.filter(f -> f.toString().endsWith(".jsa")).toList();
        }
    }

    /** An archive is created in the background; wait for its end before removing its folder. */
    @AfterEach
    void awaitBackgroundProcesses() throws Exception {
        Await.until("no process works in the folder", () -> ProcessHandle.allProcesses().noneMatch(this::runsInThisFolder));
    }

    private boolean runsInThisFolder(ProcessHandle process) {
        return process.info().commandLine().orElse("").contains(folder.toString());
    }

    @Test
    void archiveOfFirstStart_isUsedByNext() throws Exception {
        Map<String, Path> variables = archiving();
        Path archive = archiveOf(variables);
        assertThat(run(variables, "", launcher, "check").out())
                .contains("[-XX:SharedArchiveFile=" + archive + "][-XX:+VerifySharedSpaces][-Xlog:cds*=off][-Xlog:aot*=off]")
                .endsWith("[lightning.Main][check]");
        assertThat(Path.of(folder + "/making")).content().hasLineCount(1);
    }

    @Test
    void render_startsInFastStartingJava() throws Exception {
        Map<String, Path> variables = archiving();
        String archive = archiveOf(variables).toString().replace(".jsa", ".aot");
        assertThat(run(variables, "", launcher, "render", "a.jen").out()).contains("[-XX:AOTCache=" + archive + "]",
                "[-XX:TieredStopAtLevel=1]", "[-Dlightning.launcher=" + launcher.toRealPath() + "]").containsOnlyOnce("GC]")
                .doesNotContain("jdk.incubator.vector", "SharedArchiveFile", "Tier4").endsWith("[lightning.Main][render][a.jen]");
    }

    @Test
    void longRender_usesFullJava() throws Exception {
        var variables = new HashMap<>(archiving());
        archiveOf(variables);
        variables.put("LIGHTNING_LONG", Path.of("1"));
        assertThat(run(variables, "", launcher, "render").out()).contains("jdk.incubator.vector", "SharedArchiveFile", "Tier4")
                .doesNotContain("AOTCache", "TieredStopAtLevel");
    }

    @ParameterizedTest
    @ValueSource(strings = {"relight", "bench", "edit"})
    void otherCommands_useFullJava(String command) throws Exception {
        Map<String, Path> variables = archiving();
        archiveOf(variables);
        assertThat(run(variables, "", launcher, command).out()).contains("jdk.incubator.vector", "SharedArchiveFile")
                .doesNotContain("AOTCache", "TieredStopAtLevel");
    }

    @Test
    void renderWithUserOptions_usesFullJava() throws Exception {
        var variables = new HashMap<>(archiving());
        archiveOf(variables);
        variables.put("JAVA_TOOL_OPTIONS", Path.of("-Dtheirs"));
        assertThat(run(variables, "", launcher, "render").out()).contains("jdk.incubator.vector").doesNotContain("AOTCache");
    }

    @Test
    void archiveOfDifferentJars_isIgnored() throws Exception {
        Map<String, Path> variables = archiving();
        archiveOf(variables);
        Files.writeString(launcher.resolve("../../lib/lightning.jar").normalize(), "classEs");
        assertThat(run(withoutMaker(variables), "", launcher).out()).doesNotContain("SharedArchive");
    }

    @Test
    void archiveOfDifferentJava_isIgnored() throws Exception {
        Map<String, Path> variables = archiving();
        archiveOf(variables);
        var others = new HashMap<>(withoutMaker(variables));
        others.put("JAVA_HOME", java("26", ARCHIVING_JAVA));
        assertThat(run(others, "", launcher).out()).contains("[lightning.Main]").doesNotContain("SharedArchive");
    }

    @Test
    void userOptions_disableArchive() throws Exception {
        var variables = new HashMap<>(archiving());
        archiveOf(variables);
        variables.put("JAVA_TOOL_OPTIONS", Path.of("-Dtheirs"));
        assertThat(run(variables, "", launcher).out()).contains("[lightning.Main]").doesNotContain("SharedArchive");
    }

    @Test
    void failedArchive_isNotRetried() throws Exception {
        var variables = new HashMap<>(archiving());
        variables.put("JAVA_HOME", java("25", ARCHIVING_JAVA.replace("printf archive", "exit 1; printf archive")));
        assertThat(archiveOf(variables)).isEmptyFile();
        assertThat(run(variables, "", launcher).out()).contains("[lightning.Main]").doesNotContain("SharedArchive");
        assertThat(folder.resolve("making")).content().hasLineCount(1);
    }

    @Test
    void unusableCacheFolder_isIgnored() throws Exception {
        var variables = new HashMap<>(archiving());
        variables.put("XDG_CACHE_HOME", Files.writeString(folder.resolve("a file"), ""));
        Result result = run(variables, "", launcher, "check");
        assertThat(result.out()).endsWith("[lightning.Main][check]");
        assertThat(result.err()).isEmpty();
    }

    @Test
    void archiveInProgress_isNotRebuilt() throws Exception {
        Map<String, Path> variables = archiving();
        Path archive = archiveOf(variables);
        Files.delete(archive);
        Files.createDirectory(Path.of(archive + ".making"));
        Path maker = launcher.resolveSibling("make-archive");
        Result result = run(variables, "", maker, archive.toString(), variables.get("JAVA_HOME") + "/bin/java",
                folder + "/installed here");
        assertThat(result.code()).isNotZero();
        assertThat(archive).doesNotExist();
        assertThat(folder.resolve("making")).content().hasLineCount(1);
    }

    /** Runs without background work. */
    private static Map<String, Path> withoutMaker(Map<String, Path> variables) throws IOException {
        Files.delete(variables.get("PATH").resolve("mkdir"));
        return variables;
    }

    /** Returns the tools for archives, without pauses. */
    private Path toolsOfArchives() throws IOException {
        Path tools = toolsWithoutJava();
        for (String tool : List.of("stat", "cksum", "renice", "mkdir", "find", "rm", "mv", "ls", "tail")) {
            link(tools, tool);
        }
        Files.createSymbolicLink(tools.resolve("sleep"), Path.of("true"));
        link(tools, "true");
        return tools;
    }

    private static Path realJava() {
        return Path.of(System.getProperty("java.home"));
    }

    @Test
    void exitCodeAndStandardInput_arePassedThrough() throws Exception {
        Path java = java("26-ea", "cat; exit 3");
        assertThat(run(Map.of("JAVA_HOME", java), "two\nlines", launcher))
                .isEqualTo(new Result(3, "two\nlines", ""));
    }

    @Test
    void incubatorWarning_isHiddenInPipe() throws Exception {
        Path java = java("25", "printf '%s\\n' 'Picked up options' '" + WARNING + "' '" + WARNING + ", more' >&2;"
                + "printf 'last' >&2");
        assertThat(run(Map.of("JAVA_HOME", java), "", launcher).err())
                .isEqualTo("Picked up options\n" + WARNING + ", more\nlast");
    }

    @Test
    void otherErrors_reachPipe() throws Exception {
        Path java = java("25", "printf 'one\\ntwo\\n' >&2");
        assertThat(run(Map.of("JAVA_HOME", java), "", launcher).err()).isEqualTo("one\ntwo\n");
    }

    @Test
    void errorsToFile_areUnchanged() throws Exception {
        Path java = java("25", "printf '%s' '" + WARNING + "' >&2");
        Path file = folder.resolve("errors");
        run(Map.of("JAVA_HOME", java), "", Path.of("/bin/sh"), "-c", "exec \"$0\" 2>\"$1\"", launcher.toString(), file.toString());
        assertThat(file).hasContent(WARNING);
    }

    @Test
    void oldJavaHome_fallsBackToInstalledJava() throws Exception {
        Path old = java("17.0.15", "echo old");
        Path installed = java("25.0.3", "echo new");
        Files.createDirectories(folder.resolve("jvm"));
        Files.createSymbolicLink(folder.resolve("jvm/some-25-jdk"), installed);
        assertThat(run(Map.of("JAVA_HOME", old), "", launcher).out()).isEqualTo("new\n");
    }

    @Test
    void oldJavaOnPath_isNotStarted() throws Exception {
        Path old = java("17.0.15", "echo old >>\"$HOME/started\"");
        Path installed = java("25.0.3", "echo new");
        Path tools = toolsWithoutJava();
        Files.createSymbolicLink(tools.resolve("java"), old.resolve("bin/java"));
        assertThat(run(Map.of("JAVA25_HOME", installed, "PATH", tools), "", launcher).out()).isEqualTo("new\n");
        assertThat(folder.resolve("started")).doesNotExist();
    }

    @Test
    void noSuitableJava_exitsWithCode2() throws Exception {
        Path old = java("24.0.2", "echo old");
        Result result = run(Map.of("JAVA_HOME", old), "", launcher);
        assertThat(result.code()).isEqualTo(2);
        assertThat(result.out()).isEmpty();
        assertThat(result.err()).startsWith("lightning: needs Java 25 or newer and found none; install ").hasLineCount(1);
    }

    /** Returns the tools that the script calls, without Java. */
    private Path toolsWithoutJava() throws IOException {
        Path tools = Files.createDirectory(folder.resolve("tools"));
        for (String tool : List.of("bash", "env", "cat", "grep", "dirname", "readlink")) {
            link(tools, tool);
        }
        return tools;
    }

    private static void link(Path tools, String tool) throws IOException {
        Path found = Stream.of("/bin", "/usr/bin").map(place -> Path.of(place, tool))
                .filter(Files::isExecutable).findFirst().orElseThrow();
        Path call = Files.writeString(tools.resolve(tool), "#!/bin/sh\nexec " + found + " \"$@\"\n");
        assertThat(call.toFile().setExecutable(true)).isTrue();
    }

    /** Creates a Java home of the version whose java runs the shell commands. */
    private Path java(String version, String commands) throws IOException {
        Path home = Files.createTempDirectory(folder, "java");
        Files.writeString(home.resolve("release"), "IMPLEMENTOR=\"Test\"\nJAVA_VERSION=\"" + version + "\"\n");
        Path java = Files.createDirectory(home.resolve("bin")).resolve("java");
        Files.writeString(java, "#!/usr/bin/env bash\n" + commands + "\n");
        assertThat(java.toFile().setExecutable(true)).isTrue();
        return home;
    }

    /** Runs a command with only the Java that the variables name. */
    private Result run(Map<String, Path> variables, String input, Path command, String... arguments)
            throws IOException, InterruptedException {
        List<String> line = new ArrayList<>(List.of("bash", "-c", STDERR_OF_LAST_START, "bash", command.toString()));
        line.addAll(List.of(arguments));
        Path in = Files.writeString(folder.resolve("in"), input);
        Path out = folder.resolve("out");
        Path err = folder.resolve("err");
        var builder = new ProcessBuilder(line)
                .redirectInput(in.toFile()).redirectOutput(out.toFile())
                .redirectError(ProcessBuilder.Redirect.INHERIT);
        builder.environment().keySet().removeIf(name -> name.startsWith("JAVA"));
        builder.environment().put("ERR", err.toString());
        builder.environment().put("HOME", folder.toString());
        builder.environment().remove("XDG_CACHE_HOME");
        if (!variables.containsKey("PATH")) {
            builder.environment().put("PATH", toolsWithoutJava().toString());
        }
        variables.forEach((name, value) -> builder.environment().put(name, value.toString()));
        builder.directory(folder.toFile());
        Process process = builder.start();
        return new Result(process.waitFor(), Files.readString(out), Files.readString(err));
    }
}
