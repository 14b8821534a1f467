package lightning.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import lightning.sample.PythonPrograms;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.json.JsonMapper;

/**
 * Blender with the add-on: one process for all tests of this Java process, which runs one script after another. The add-on's program runs
 * commands in this Java process, because a start of Java takes three seconds of processor time; only {@code serve} is a process of its own.
 * The process ends when it is idle for half a minute.
 */
final class Blender {
    private static final Path SCRIPTS = Path.of("src/test/python").toAbsolutePath();
    private static final long MAX_IDLE_NANOS = 20_000_000_000L;
    private static final long MAX_SECONDS = 300;
    private static @Nullable Path home;
    private static @Nullable Process process;
    private static long lastUse;

    private Blender() {}

    /**
     * Runs a script and asserts that it ends without an error.
     *
     * @param folder    first argument, a folder for its files
     * @param script    file in {@code src/test/python}
     * @param arguments further arguments
     * @return its output
     */
    static synchronized String run(Path folder, String script, String... arguments) throws Exception {
        if (process == null || !process.isAlive() || System.nanoTime() - lastUse > MAX_IDLE_NANOS) {
            process = start();
        }
        Path output = Files.createTempFile(folder, "output", ".txt");
        List<String> request = new ArrayList<>(List.of(output.toString(), SCRIPTS.resolve(script).toString(), folder.toString()));
        request.addAll(List.of(arguments));
        Writer requests = process.outputWriter(StandardCharsets.UTF_8);
        requests.write(new JsonMapper().writeValueAsString(request) + "\n");
        requests.flush();
        String answer = answer(process);
        lastUse = System.nanoTime();
        String text = Files.readString(output);
        assertThat(answer).as("%s", text).isEqualTo("0");
        return text;
    }

    /** Returns the answer; ends the process if there is none. */
    private static String answer(Process asked) throws InterruptedException, ExecutionException {
        var line = CompletableFuture.supplyAsync(() -> {
            try {
                return String.valueOf(asked.inputReader(StandardCharsets.UTF_8).readLine());
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        });
        try {
            return line.get(MAX_SECONDS, TimeUnit.SECONDS);
        } catch (TimeoutException e) {
            asked.destroyForcibly();
            return "no end within " + MAX_SECONDS + " s";
        }
    }

    private static Process start() throws IOException {
        if (home == null) {
            home = Files.createDirectories(Path.of("target/blender-home", Long.toString(ProcessHandle.current().pid()))).toAbsolutePath();
            Path launcher = BlenderAddOn.install(home);
            Path java = Files.move(launcher, home.resolve("lightning-java"));
            Files.writeString(launcher, "#!/usr/bin/env bash\n[[ $1 == serve ]] && exec '" + java + "' \"$@\"\nexec 3<>/dev/tcp/127.0.0.1/"
                    + serve() + "\nprintf '%s\\0' $# \"$@\" >&3\nread -r code <&3\ncat <&3\nexit \"$code\"\n");
            Files.setPosixFilePermissions(launcher, Files.getPosixFilePermissions(java));
        }
        var builder = new ProcessBuilder(PythonPrograms.require("bpy"), "-B", SCRIPTS.resolve("blender_process.py").toString());
        builder.environment().put("BLENDER_USER_RESOURCES", home.resolve("user").toString());
        return builder.redirectError(ProcessBuilder.Redirect.DISCARD).start();
    }

    /** Starts to run commands of the launcher; returns the port. */
    private static int serve() throws IOException {
        var server = new ServerSocket(0, 0, InetAddress.getLoopbackAddress());
        Thread.ofPlatform().daemon().name("blender-commands").start(() -> {
            while (true) {
                try {
                    Socket client = server.accept();
                    Thread.ofPlatform().daemon().name("blender-command").start(() -> runCommand(client));
                } catch (IOException e) {
                    throw new UncheckedIOException(e);
                }
            }
        });
        return server.getLocalPort();
    }

    private static void runCommand(Socket client) {
        try (client; var in = new DataInputStream(client.getInputStream())) {
            Object[] words = new Object[Integer.parseInt(word(in))];
            for (int i = 0; i < words.length; i++) {
                words[i] = word(in);
            }
            CliResult result = CliResult.run(words);
            client.getOutputStream().write((result.exit() + "\n" + result.out() + result.err()).getBytes(StandardCharsets.UTF_8));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Reads bytes up to a zero. */
    private static String word(DataInputStream in) throws IOException {
        byte[] bytes = new byte[64];
        int count = 0;
        for (byte b; (b = in.readByte()) != 0; count++) {
            bytes = count < bytes.length ? bytes : Arrays.copyOf(bytes, 2 * count);
            bytes[count] = b;
        }
        return new String(bytes, 0, count, StandardCharsets.UTF_8);
    }
}
