package lightning.shot.cluster;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import lightning.base.work.Await;
import lightning.sample.TestedProgram;

/** Node in its own process, started by the command line. */
final class NodeProcess implements AutoCloseable {
    private final Process process;

    /**
     * @param port   its port
     * @param others ports that it joins, including its own
     * @param folder folder for its certificate {@code shared.p12}, its content and its log
     */
    NodeProcess(int port, List<Integer> others, Path folder, String... more) throws IOException {
        List<String> line = TestedProgram.command("-Xmx600m");
        line.addAll(List.of("node", "--certificate", folder.resolve("shared.p12").toString(), "--port", String.valueOf(port), "--folder",
                folder.toString()));
        for (int other : others) {
            line.addAll(List.of("--join", "127.0.0.1:" + other));
        }
        line.addAll(List.of(more));
        process = new ProcessBuilder(line).redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.appendTo(new File(folder.toFile(), "node-" + port + ".log"))).start();
    }

    long pid() {
        return process.pid();
    }

    /** Waits until it ends by itself; returns its exit code. */
    int exit() throws InterruptedException {
        if (!process.waitFor(Await.TIMEOUT_SECONDS, TimeUnit.SECONDS)) {
            throw new IllegalStateException("the process does not end");
        }
        return process.exitValue();
    }

    /** Kills it. */
    void kill() throws InterruptedException {
        process.destroyForcibly();
        if (!process.waitFor(60, TimeUnit.SECONDS)) {
            throw new IllegalStateException("the process does not end");
        }
    }

    /** Suspends or resumes it, which looks like a network split to others. */
    void setSuspended(boolean is) throws IOException, InterruptedException {
        new ProcessBuilder("kill", is ? "-STOP" : "-CONT", String.valueOf(pid())).start().waitFor();
    }

    @Override
    public void close() throws InterruptedException {
        kill();
    }
}
