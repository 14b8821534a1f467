package lightning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import lightning.sample.Nightly;
import lightning.sample.Packaged;
import org.assertj.core.api.ThrowingConsumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Tests the assembled program folder. */
@Packaged
class ProgramFolderIT {
    private static final Path PROGRAM = Path.of("target/lightning");
    /** {@code javafx-base-26.0.2-linux.jar}, {@code lwjgl-3.3.6-natives-linux.jar}: name, version, and for some the platform. */
    private static final Pattern LIBRARY =
            Pattern.compile("(.+?)-(\\d.*?)(?:-(?:natives-)?(?:linux|macos|mac|windows|win)(?:-aarch64|-arm64)?)?\\.jar");

    private static final int TIMEOUT_SECONDS = 900;

    /** Unwritable cache: no archive is found or created there. */
    private static final Path NO_CACHE = Path.of("/dev/null");

    /** Java that logs its options, with the archives created by it, shared by all tests. */
    @TempDir
    private static Path shared;

    @TempDir
    private Path folder;
    private Path cache = NO_CACHE;

    @Test
    void everyLibrary_isListedWithLicense() throws IOException {
        List<String> lines = Files.readAllLines(PROGRAM.resolve("licences.txt"));
        assertThat(libraries()).isNotEmpty().allSatisfy(library -> assertThat(lines)
                .filteredOn(line -> line.contains(":" + library + " ")).singleElement().asString().matches("\\s*\\(\\w[^)].*\\) .+"));
        assertThat(lines.toString()).doesNotContainIgnoringCase("unknown license");
    }

    @Test
    void everyLicense_hasItsText() throws IOException {
        List<String> names = Files.readAllLines(PROGRAM.resolve("licences.txt")).stream().filter(line -> line.startsWith("     ("))
                .map(line -> line.substring(line.indexOf('(') + 1, line.indexOf(')'))).distinct().toList();
        assertThat(names).isNotEmpty()
                .allSatisfy(name -> assertThat(PROGRAM.resolve("licences").resolve(name + ".txt")).isNotEmptyFile());
        assertThat(PROGRAM.resolve("LICENSE")).content().contains("Apache License");
    }

    @Test
    void clusterLibraries_areInSeparateFolder() throws IOException {
        assertThat(PROGRAM.resolve("lib")).isDirectoryNotContaining("glob:**/jgroups*");
        assertThat(PROGRAM.resolve("cluster")).isDirectoryContaining("glob:**/jgroups*").isDirectoryNotContaining("glob:**/picocli*");
    }

    /** Java makes no archive of a class path with a folder, for example one that the manifest of a library names. */
    @Test
    void libraries_canBeArchived() throws Exception {
        Path archive = folder.resolve("archive.jsa");
        Path out = folder.resolve("out");
        Process java = new ProcessBuilder(System.getProperty("java.home") + "/bin/java", "-XX:ArchiveClassesAtExit=" + archive, "-cp",
                PROGRAM.toRealPath() + "/lib/*", "lightning.Main", "--version").redirectErrorStream(true).redirectOutput(out.toFile())
                .start();
        java.waitFor();
        assertThat(archive).as(Files.readString(out)).isNotEmptyFile();
    }

    @Test
    void libraryNotices_arePreserved() {
        assertThat(PROGRAM.resolve("licences/jackson-databind/META-INF/NOTICE")).isNotEmptyFile();
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void fullOutputDevice_exitsWithCode2() throws Exception {
        Path err = folder.resolve("err");
        Process check = launcher(folder, "check", Path.of("scenes/bird.jen").toAbsolutePath().toString())
                .redirectOutput(new File("/dev/full")).redirectError(err.toFile()).start();
        assertThat(check.waitFor()).isEqualTo(2);
        assertThat(Files.readString(err)).contains("lightning: cannot write to the standard output")
                .doesNotContain("Exception");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void closedOutputPipe_endsWithoutMessage() throws Exception {
        Path err = folder.resolve("err");
        Process completion = launcher(folder, "completion", "bash").redirectError(err.toFile()).start();
        completion.getInputStream().close();
        assertThat(completion.waitFor()).isEqualTo(2);
        assertThat(Files.readAllLines(err)).allMatch(line -> line.startsWith("WARNING: Using incubator modules"));
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void nonAsciiSceneName_isReadInLocaleC() throws Exception {
        String name = "Käfer-光.jen";
        // The test's Java may run in the locale C and could not name the file; a shell can.
        Path script = Files.writeString(folder.resolve("copy.sh"), "cp \"$1\" '" + name + "' && exec \"$2\" check '" + name + "'\n");
        Path scene = Files.writeString(folder.resolve("plain.jen"), "jen 1\nsphere ball { }\nlight lamp point { at 0 3 3 }\n");
        Path out = folder.resolve("out");
        Path err = folder.resolve("err");
        var builder = new ProcessBuilder("bash", script.toString(), scene.toString(),
                PROGRAM.resolve("bin/lightning").toAbsolutePath().toString())
                .directory(folder.toFile()).redirectOutput(out.toFile()).redirectError(err.toFile());
        builder.environment().keySet().removeIf(variable -> variable.startsWith("LC_") || variable.equals("LANG"));
        builder.environment().put("LC_ALL", "C");
        builder.environment().put("XDG_CACHE_HOME", NO_CACHE.toString());
        assertThat(builder.start().waitFor()).as(Files.readString(err)).isZero();
        assertThat(Files.readString(out)).startsWith(name + ": no problems; 1 object (1 sphere)");
    }

    @Test
    @EnabledOnOs(OS.LINUX)
    void bundledScenes_areFoundFromAnyFolder() throws Exception {
        String list = output("shot", "render", "scenes/dusk.jen", "-o", "frames", "--frames", "20",
                "--size", "30x20");
        assertThat(list).contains("dusk-0020.png");
        assertThat(folder.resolve("frames/dusk-0020.png")).isNotEmptyFile();
        assertThat(output("export", "scenes/balls.jen", "-o", "balls.pov")).doesNotContain("Exception");
        assertThat(folder.resolve("balls-checker_png.png")).as("a texture beside the export").exists();
    }

    /** {@link LauncherTest} checks the choice of archives in the usual check; making them takes a minute. */
    @Test
    @Nightly
    @EnabledOnOs(OS.LINUX)
    void classArchive_isUsed_andIgnoredIfBroken() throws Exception {
        String plain = checked();
        Path archive = copyArchives();
        var java = new ArrayList<>(List.of(System.getProperty("java.home") + "/bin/java"));
        java.addAll(Files.readAllLines(PROGRAM.resolve("bin/java.options")).stream().filter(line -> line.startsWith("-")).toList());
        // With -Xshare:on Java exits if it cannot use the archive.
        java.addAll(List.of("-XX:SharedArchiveFile=" + archive, "-Xshare:on", "-cp", PROGRAM.toRealPath() + "/lib/*", "lightning.Main",
                "--version"));
        assertThat(new ProcessBuilder(java).redirectErrorStream(true).start().waitFor()).isZero();
        java.set(java.indexOf("-cp") + 1, PROGRAM.toRealPath() + "/lib/*:" + PROGRAM.toRealPath() + "/cluster/*");
        assertThat(new ProcessBuilder(java).redirectErrorStream(true).start().waitFor()).as("with a cluster's libraries").isZero();
        assertThat(checked()).as("with the archive").isEqualTo(plain);
        assertBrokenArchiveIsIgnored(archive, what -> assertThat(checked()).as(what).isEqualTo(plain));
    }

    /** As above. */
    @Test
    @Nightly
    @EnabledOnOs(OS.LINUX)
    void shortRender_usesFastStartingJava_longRenderRestarts() throws Exception {
        String few = "light a point { at 0 3 3 }\n";
        byte[] plain = rendered(few);
        assertThat(startedCommands()).singleElement().asString().contains("jdk.incubator.vector");
        Path archive = Path.of(copyArchives().toString().replace(".jsa", ".aot"));
        assertThat(rendered(few)).as("by a lighter Java").isEqualTo(plain);
        assertThat(startedCommands()).singleElement().asString().contains("AOTCache=").doesNotContain("jdk.incubator.vector");
        String many = IntStream.range(0, 8).mapToObj(i -> "light a" + i + " directional { spread 1 samples 64 }\n")
                .collect(Collectors.joining());
        rendered("picture { size 640 400 }\n" + many);
        assertThat(startedCommands()).satisfiesExactly(first -> assertThat(first).contains("AOTCache="),
                second -> assertThat(second).contains("jdk.incubator.vector").doesNotContain("AOTCache="));
        assertBrokenArchiveIsIgnored(archive, what -> assertThat(rendered(few)).as(what).isEqualTo(plain));
    }

    /** Runs a check with the archive broken in several ways; the check receives a name of each. */
    private static void assertBrokenArchiveIsIgnored(Path archive, ThrowingConsumer<String> check) throws IOException {
        byte[] whole = Files.readAllBytes(archive);
        Files.write(archive, Arrays.copyOf(whole, whole.length / 2));
        check.accept("half the archive");
        Arrays.fill(whole, whole.length / 2, whole.length / 2 + 1000, (byte) 7);
        Files.write(archive, whole);
        check.accept("an archive with other bytes");
        Files.writeString(archive, "no archive at all");
        check.accept("another file");
    }

    /** Returns the home of a Java that appends its options to the file named by {@code STARTS}. */
    private static Path loggingJava() throws IOException {
        Path home = shared.resolve("java");
        if (Files.notExists(home)) {
            Path real = Path.of(System.getProperty("java.home"));
            Files.createDirectories(home.resolve("bin"));
            Files.copy(real.resolve("release"), home.resolve("release"));
            Path script = Files.writeString(home.resolve("bin/java"),
                    "#!/bin/bash\necho \"$*\" >>\"${STARTS:-/dev/null}\"\nexec '" + real.resolve("bin/java") + "' \"$@\"\n");
            assertThat(script.toFile().setExecutable(true)).isTrue();
        }
        return home;
    }

    /**
     * Returns a folder with a {@code renice} that does nothing. Archives are created at the lowest priority, which took five minutes while
     * other tests ran.
     */
    private static Path normalPriority() throws IOException {
        Path tools = shared.resolve("tools");
        if (Files.notExists(tools)) {
            Path script = Files.writeString(Files.createDirectories(tools).resolve("renice"), "#!/bin/sh\n");
            assertThat(script.toFile().setExecutable(true)).isTrue();
        }
        return tools;
    }

    /** Returns Java's arguments for renders since the last call, without those that make an archive in the background. */
    private List<String> startedCommands() throws IOException {
        Path starts = folder.resolve("starts");
        List<String> lines = Files.readAllLines(starts).stream()
                .filter(line -> line.contains("lightning.Main render") && !line.contains("AOTCacheOutput=")).toList();
        Files.delete(starts);
        return lines;
    }

    /** Returns the program's image of a ball in some lights; expects no errors. */
    private byte[] rendered(String lights) throws Exception {
        Path scene = Files.writeString(folder.resolve("scene.jen"), "jen 1\nsphere ball { }\n" + lights);
        Path picture = folder.resolve("picture.pfm");
        assertThat(output("render", scene.toString(), "-o", picture.toString()))
                .contains("first pass of").doesNotContain("[warning]", "[error]", "Error", "Exception");
        byte[] bytes = Files.readAllBytes(picture);
        Files.delete(picture);
        return bytes;
    }

    /** Returns both outputs of checking a scene. */
    private String checked() throws Exception {
        return output("check", Path.of("scenes/bird.jen").toAbsolutePath().toString());
    }

    /** Returns both outputs of a successful command. */
    private String output(String... arguments) throws Exception {
        Path out = folder.resolve("out");
        ProcessBuilder program = launcher(folder, arguments).redirectErrorStream(true).redirectOutput(out.toFile());
        program.environment().put("XDG_CACHE_HOME", cache.toString());
        program.environment().put("JAVA_HOME", loggingJava().toString());
        program.environment().put("STARTS", folder.resolve("starts").toString());
        program.environment().merge("PATH", normalPriority().toString(), (path, first) -> first + File.pathSeparator + path);
        assertThat(program.start().waitFor()).as(Files.readString(out)).isZero();
        return Files.readString(out);
    }

    /** Creates a separate cache with the archives of a first start; returns that of the editor's classes. */
    private Path copyArchives() throws Exception {
        Path made = shared.resolve("cache/lightning");
        if (Files.notExists(made)) {
            cache = shared.resolve("cache");
            checked();
        }
        Path archive = awaitArchive(made);
        cache = folder.resolve("cache");
        Path copies = Files.createDirectories(cache.resolve("lightning"));
        Path picture = made.resolve(archive.getFileName().toString().replace(".jsa", ".aot"));
        Files.copy(picture, copies.resolve(picture.getFileName()));
        return Files.copy(archive, copies.resolve(archive.getFileName()));
    }

    private static Path awaitArchive(Path made) throws Exception {
        for (int i = 0; i < TIMEOUT_SECONDS; i++) {
            try (Stream<Path> files = Files.list(made)) {
                Optional<Path> archive = files.filter(file -> file.toString().endsWith(".jsa")).findFirst();
                if (archive.isPresent()) {
                    return archive.get();
                }
            } catch (NoSuchFileException e) {
                // The process is just starting.
            }
            Thread.sleep(1000);
        }
        throw new AssertionError("no archive was made in " + TIMEOUT_SECONDS + " s");
    }

    private static ProcessBuilder launcher(Path in, String... arguments) {
        List<String> line = new ArrayList<>(List.of(PROGRAM.resolve("bin/lightning").toAbsolutePath().toString()));
        line.addAll(List.of(arguments));
        var program = new ProcessBuilder(line).directory(in.toFile());
        program.environment().put("XDG_CACHE_HOME", NO_CACHE.toString());
        return program;
    }

    /** Returns name and version, as in {@code picocli:4.7.7}, without the program's own. */
    private static List<String> libraries() throws IOException {
        try (Stream<Path> shared = Files.list(PROGRAM.resolve("lib")); Stream<Path> apart = Files.list(PROGRAM.resolve("cluster"))) {
            return Stream.concat(shared, apart).map(jar -> jar.getFileName().toString()).filter(jar -> !jar.equals("lightning.jar"))
                    .map(jar -> {
                        Matcher library = LIBRARY.matcher(jar);
                        assertThat(library.matches()).as(jar).isTrue();
                        return library.group(1) + ":" + library.group(2);
                    }).distinct().toList();
        }
    }
}
