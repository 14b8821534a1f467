package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import lightning.base.work.Await;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrReader;
import lightning.sample.PythonPrograms;
import lightning.sample.Slow;
import lightning.sample.TestedProgram;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Job templates and scripts for schedulers. Templates are run by Open Job Description's own program. */
@Slow
@DisabledOnOs(OS.WINDOWS)
final class FarmTest {
    private static final String SCENE = """
            jen 1
            picture { size 32 20 }
            camera { from 0 1 6 to 0 0 0 }
            sphere ball { }
            light lamp point { at 2 4 5 intensity 1 }
            shot { frames 1 5 light lamp { intensity { 1 1 5 2 } } }
            """;

    @TempDir
    private Path folder;
    private Path scene;
    private Path program;

    @BeforeEach
    void writeScene() throws IOException {
        scene = Files.writeString(folder.resolve("a.jen"), SCENE);
        program = script("program", "exec '" + String.join("' '", TestedProgram.command("-Xmx500m")) + "' \"$@\"");
    }

    private Path script(String name, String commands) throws IOException {
        Path file = Files.writeString(folder.resolve(name), "#!/bin/sh\n" + commands + "\n");
        return Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwx------"));
    }

    private Path shell(String file) {
        return Path.of("src/main/farm", file).toAbsolutePath();
    }

    private String job(String template, String step, String... parameters) throws IOException {
        List<String> words = new ArrayList<>(List.of("-m", "openjd", "run", Path.of("docs", template).toAbsolutePath().toString(), "--step",
                step));
        for (String parameter : parameters) {
            words.addAll(List.of("-p", parameter));
        }
        words.addAll(List.of("-p", "Lightning=" + program));
        return PythonPrograms.output(folder, words);
    }

    private void assertSameAsShotRender(String output) throws IOException {
        CliResult.run("shot", "render", scene, "-o", folder.resolve("expected")).assertSuccess();
        assertThat(folder.resolve(output).toFile().list())
                .containsExactlyInAnyOrder("a-0001.png", "a-0002.png", "a-0003.png", "a-0004.png", "a-0005.png");
        for (int frame = 1; frame <= 5; frame++) {
            String name = "a-000" + frame + ".png";
            assertThat(folder.resolve(output).resolve(name)).hasSameBinaryContentAs(folder.resolve("expected").resolve(name));
        }
    }

    @Test
    void chunks_areRenderedByOneProcessEach() throws Exception {
        PythonPrograms.require("openjd.cli");
        String log = job("shot.openjd.json", "Render", "Scene=" + scene, "Output=" + folder.resolve("out"), "Frames=1-5", "Chunk=3");
        assertThat(log).contains("Chunks run: 2");
        assertSameAsShotRender("out");
    }

    @Test
    void chunks_takeNameAndOptionsOfPictures() throws Exception {
        PythonPrograms.require("openjd.cli");
        job("shot.openjd.json", "Render", "Scene=" + scene, "Output=" + folder.resolve("out"), "Frames=2-3", "Name=b.exr",
                "Options=--size 16x10 --layers");
        assertThat(folder.resolve("out").toFile().list()).containsExactlyInAnyOrder("b-0002.exr", "b-0003.exr");
        assertSmallWithLayers("b-0002.exr");
    }

    private void assertSmallWithLayers(String name) throws IOException {
        try (var picture = new ExrReader(folder.resolve("out").resolve(name))) {
            assertThat(picture.header().width()).isEqualTo(16);
            assertThat(picture.header().channels()).extracting(ExrChannel::name).contains("lamp_diffuse.R");
        }
    }

    /** Three tasks, one process. */
    @Test
    void adaptor_keepsSceneOpenForSession() throws Exception {
        String python = PythonPrograms.require("openjd.cli", "openjd.adaptor_runtime");
        Path starts = folder.resolve("starts");
        Path counted = script("counted", "echo start >> '" + starts + "'\nexec '" + program + "' \"$@\"");
        Path adaptor = adaptor(python);
        String log = PythonPrograms.output(folder, List.of("-m", "openjd", "run",
                Path.of("docs/shot-session.openjd.json").toAbsolutePath().toString(), "--step", "Render", "-p", "Scene=" + scene, "-p",
                "Output=" + folder.resolve("out"), "-p", "Frames=1-5", "-p", "Chunk=2", "-p", "Lightning=" + counted, "-p",
                "Adaptor=" + adaptor));
        assertThat(log).contains("Chunks run: 3", "openjd_progress: 100.0", "openjd_status: frame 5: lamp: weight");
        assertThat(starts).hasContent("start");
        assertSameAsShotRender("out");
    }

    private Path adaptor(String python) throws IOException {
        return script("adaptor", "export PYTHONPATH='" + Path.of("src/main/python").toAbsolutePath() + "'\nexec '" + python
                + "' -B -m lightning_openjd \"$@\"");
    }

    @Test
    void adaptor_makesEditsAndWritesLayers() throws Exception {
        Path adaptor = adaptor(PythonPrograms.require("openjd.cli", "openjd.adaptor_runtime"));
        job("shot-session.openjd.json", "Render", "Scene=" + scene, "Output=" + folder.resolve("out"), "Frames=5-5", "Format=exr",
                "Layers=true", "Edits=[\"picture.size=16 10\"]", "Adaptor=" + adaptor);
        assertSmallWithLayers("a-0005.exr");
    }

    @Test
    void adaptor_failsWithOneSentence() throws Exception {
        Path adaptor = adaptor(PythonPrograms.require("openjd.cli", "openjd.adaptor_runtime"));
        PythonPrograms.Result result = PythonPrograms.run(folder, List.of("-m", "openjd", "run",
                Path.of("docs/shot-session.openjd.json").toAbsolutePath().toString(), "--step", "Render", "-p", "Scene=" + scene, "-p",
                "Output=" + folder.resolve("out"), "-p", "Frames=5-6", "-p", "Lightning=" + program, "-p", "Adaptor=" + adaptor));
        assertThat(result.exit()).isNotZero();
        assertThat(result.text()).contains("openjd_fail: ", "frame: expected a whole number from 1 to 5, found 6",
                "Exiting Environment: Lightning");
    }

    @Test
    void nodes_startAndEndWithSession() throws Exception {
        PythonPrograms.require("openjd.cli");
        Path shared = Files.createDirectory(folder.resolve("shared"));
        CliResult.run("node", "--make-certificate", shared.resolve("cluster.p12")).assertSuccess();
        Thread user = Thread.ofPlatform().start(() -> {
            try {
                Path log = shared.resolve("127.0.0.1-17811.log");
                Await.until("the node runs", () -> Files.exists(log) && Files.readString(log).contains("node running"));
                Process relight = new ProcessBuilder(program.toString(), "shot", "relight", scene.toString(), "--cluster",
                        Files.readString(shared.resolve("127.0.0.1-17811.node")).strip(), "--certificate",
                        shared.resolve("cluster.p12").toString(), "--bind", "127.0.0.1", "--set", "lamp.color=1 0 0", "-o",
                        folder.resolve("red").toString()).redirectErrorStream(true)
                        .redirectOutput(folder.resolve("relight.log").toFile()).start();
                relight.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS);
                Files.writeString(shared.resolve("stop"), "");
            } catch (Exception e) {
                throw new IllegalStateException(e);
            }
        });
        String log = job("nodes.openjd.json", "Nodes", "Folder=" + shared, "Nodes=1", "Bind=127.0.0.1", "Port=17811", "Memory=0.2",
                "NodeScript=" + shell("node.sh"));
        user.join();
        assertThat(folder.resolve("red").toFile().list()).as(Files.readString(folder.resolve("relight.log"))).hasSize(5);
        assertThat(log).contains("Session ended successfully", "has a file stop");
        assertThat(shared.toFile().list()).containsExactlyInAnyOrder("cluster.p12", "stop", "127.0.0.1-17811.log");
    }

    /** OpenLook's own library makes the job; its server is replaced by this test. */
    @Test
    void openCueJob_rendersChunks() throws Exception {
        PythonPrograms.require("outline");
        String xml = PythonPrograms.output(folder, List.of(shell("opencue_shot.py").toString(), scene.toString(),
                folder.resolve("out").toString(), "--frames", "1-5", "--chunk", "3", "--program", program.toString(), "--print", "--view",
                "srgb"));
        assertThat(xml).contains("<range>1-5</range>", "<chunk>3</chunk>", "--view srgb");
        Matcher command = Pattern.compile("<cmd>[^<]*?(" + Pattern.quote(program.toString()) + " shot render [^<]*)</cmd>").matcher(xml);
        assertThat(command.find()).as(xml).isTrue();
        for (String[] chunk : new String[][] {{"1", "3"}, {"4", "5"}}) {
            List<String> words = List.of(command.group(1).replace("#FRAME_START#", chunk[0]).replace("#FRAME_END#", chunk[1]).split(" "));
            CliResult.run(words.subList(1, words.size()).toArray()).assertSuccess();
        }
        assertSameAsShotRender("out");
    }

    /** Runs a job script as Slurm's task {@code task}; its program srun runs the command here. */
    private String slurm(String script, int task, String... words) throws Exception {
        Path bin = Files.createDirectories(folder.resolve("bin"));
        Files.deleteIfExists(bin.resolve("srun"));
        Files.move(script("srun", "while case \"$1\" in --*) true;; *) false;; esac; do shift; done\nexec \"$@\""), bin.resolve("srun"));
        List<String> line = new ArrayList<>(List.of("bash", shell(script).toString()));
        line.addAll(List.of(words));
        Path output = folder.resolve("slurm.log");
        ProcessBuilder builder = new ProcessBuilder(line).redirectErrorStream(true).redirectOutput(output.toFile());
        builder.environment().putAll(Map.of("PATH", bin + ":" + System.getenv("PATH"), "LIGHTNING", program.toString(),
                "SLURM_ARRAY_TASK_ID", String.valueOf(task), "FRAMES", "1-5", "CHUNK", "3", "LIGHTNING_FARM", shell("").toString(),
                "LIGHTNING_BIND", "127.0.0.1", "LIGHTNING_PORT", "17821"));
        builder.environment().remove("SLURM_CPUS_PER_TASK");
        Process process = builder.start();
        if (script.startsWith("nodes")) {
            Path log = Path.of(words[0], "127.0.0.1-17821.log");
            Await.until("the node runs", () -> Files.exists(log) && Files.readString(log).contains("node running"));
            assertThat(Path.of(words[0], "127.0.0.1-17821.node")).hasContent("127.0.0.1:17821");
            process.destroy();
        }
        int exit = process.waitFor();
        String text = Files.readString(output);
        assertThat(exit).as(text).isZero();
        return text;
    }

    @Test
    void slurmTasks_renderTheirChunks() throws Exception {
        String out = folder.resolve("out").toString();
        slurm("shot.sbatch", 0, scene.toString(), out);
        slurm("shot.sbatch", 1, scene.toString(), out);
        assertThat(slurm("shot.sbatch", 2, scene.toString(), out)).contains("no frames for task 2");
        assertSameAsShotRender("out");
    }

    @Test
    void slurmNodes_endWithTheirJob() throws Exception {
        Path shared = Files.createDirectory(folder.resolve("shared"));
        slurm("nodes.sbatch", 0, shared.toString(), "--folder", folder.toString());
        assertThat(shared.toFile().list()).containsExactlyInAnyOrder("cluster.p12", "127.0.0.1-17821.log");
    }
}
