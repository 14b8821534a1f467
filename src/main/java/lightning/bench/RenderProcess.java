package lightning.bench;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import lightning.base.process.OwnProgram;

/** Launcher of this program as a separate process, as a user starts it. */
final class RenderProcess {
    private RenderProcess() {}

    /**
     * Renders a scene to a file in a separate process.
     *
     * @param options further options of {@code lightning render}
     * @param folder  folder for its log
     * @throws IOException          if it fails; the message ends with the last line of its output
     * @throws InterruptedException if this thread was interrupted; the process is then killed
     */
    static void render(Path scene, PictureSize size, int threads, List<String> options, Path picture, Path folder)
            throws IOException, InterruptedException {
        List<String> commandLine = new ArrayList<>(OwnProgram.command());
        commandLine.addAll(List.of("render", scene.toString(), "--size", size.toString(), "--threads", Integer.toString(threads), "-o",
                picture.toString()));
        commandLine.addAll(options);
        Path log = folder.resolve("log");
        ProcessBuilder builder = new ProcessBuilder(commandLine).redirectErrorStream(true).redirectOutput(log.toFile());
        // These options of the measuring process would enlarge the heap of the measured one, which a user starts without them.
        builder.environment().remove("_JAVA_OPTIONS");
        Process process = builder.start();
        try {
            if (process.waitFor() != 0) {
                String last = Files.readString(log, StandardCharsets.UTF_8).lines().filter(line -> !line.isBlank())
                        .reduce("nothing", (_, line) -> line);
                throw new IOException("'lightning render' failed: " + last.strip());
            }
        } finally {
            process.destroy();
        }
    }
}
