package lightning.serve.resident;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.net.UnixDomainSocketAddress;
import java.nio.channels.Channels;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.SocketChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.OptionalInt;
import java.util.concurrent.CancellationException;

/**
 * Client of the resident process; starts the process if there is none.
 *
 * @param socket path of the socket: {@link ResidentPlace}
 */
public record ResidentClient(Path socket, Starter starter) {
    /** Starts a resident process, which ends by itself. */
    @FunctionalInterface
    public interface Starter {
        Process start() throws IOException;
    }

    /** A Java that starts without an archive of classes on a busy machine takes a few seconds. */
    private static final Duration START_TIMEOUT = Duration.ofSeconds(30);
    private static final int POLL_MILLISECONDS = 20;
    private static final int MAX_STARTS = 2;

    /**
     * Runs a command in the resident process.
     *
     * @param terminal whether {@code out} is a terminal
     * @return the exit code; empty if the process runs another command
     * @throws IOException           if the process cannot be started or ended; the message is a clause
     * @throws CancellationException if this thread was interrupted, which also cancels the command
     */
    public OptionalInt run(PrintStream out, PrintStream err, boolean terminal, List<String> arguments) throws IOException {
        var request = new ResidentRequest(Surroundings.ofThisProcess(), false, terminal, out.charset().name(), arguments);
        long deadline = System.nanoTime() + START_TIMEOUT.toNanos();
        Process started = null;
        int starts = 0;
        while (System.nanoTime() < deadline) {
            Conversation conversation = converse(socket, request, out, err);
            switch (conversation) {
                case Conversation.Ended(int exit) -> {
                    return OptionalInt.of(exit);
                }
                case Conversation.Busy() -> {
                    return OptionalInt.empty();
                }
                case Conversation.None() -> {
                    if (started == null || !started.isAlive()) {
                        if (starts == MAX_STARTS) {
                            throw new IOException("it ends as soon as it was started");
                        }
                        started = starter.start();
                        starts++;
                    }
                }
                case Conversation.Leaving() -> started = null;
            }
            pause();
        }
        throw new IOException("it does not answer within " + START_TIMEOUT.toSeconds() + " s");
    }

    /**
     * Lets the resident process end after its command.
     *
     * @param socket path of the socket
     * @return false if there is no process
     */
    public static boolean stop(Path socket) throws IOException {
        var request = new ResidentRequest("", true, false, "UTF-8", List.of());
        var nothing = new PrintStream(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
        return converse(socket, request, nothing, nothing) instanceof Conversation.Ended;
    }

    /** How a conversation ended. */
    private sealed interface Conversation {
        record Ended(int exit) implements Conversation {}

        record Busy() implements Conversation {}

        /** Nobody listens at the socket. */
        record None() implements Conversation {}

        /** The process is about to end. */
        record Leaving() implements Conversation {}
    }

    private static Conversation converse(Path socket, ResidentRequest request, PrintStream out, PrintStream err) throws IOException {
        SocketChannel connected;
        try {
            connected = SocketChannel.open(UnixDomainSocketAddress.of(socket));
        } catch (ClosedByInterruptException e) {
            throw new CancellationException();
        } catch (IOException e) {
            return new Conversation.None();
        }
        boolean hasOutput = false;
        try (SocketChannel channel = connected) {
            var in = new DataInputStream(new BufferedInputStream(Channels.newInputStream(channel)));
            request.write(new DataOutputStream(new BufferedOutputStream(Channels.newOutputStream(channel))));
            while (true) {
                switch (ResidentAnswer.read(in)) {
                    case ResidentAnswer.Exit(int code) -> {
                        return new Conversation.Ended(code);
                    }
                    case ResidentAnswer.Busy() -> {
                        return new Conversation.Busy();
                    }
                    case ResidentAnswer.Text(boolean error, byte[] bytes) -> {
                        hasOutput = true;
                        PrintStream to = error ? err : out;
                        to.write(bytes, 0, bytes.length);
                        to.flush();
                    }
                }
            }
        } catch (ClosedByInterruptException e) {
            throw new CancellationException();
        } catch (IOException e) {
            if (hasOutput) {
                throw new IOException("it ended before the command was done", e);
            }
            return new Conversation.Leaving();
        }
    }

    private static void pause() {
        try {
            Thread.sleep(POLL_MILLISECONDS);
        } catch (InterruptedException e) {
            throw new CancellationException();
        }
    }
}
