package lightning.serve.resident;

import java.io.BufferedOutputStream;
import java.io.Closeable;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.atomic.AtomicInteger;
import lightning.base.work.DedicatedThread;
import lightning.serve.ConnectionHandler;
import lightning.serve.SocketListener;
import org.jspecify.annotations.Nullable;

/**
 * Server that runs commands of clients, one at a time. It ends when it was idle for some time, or when a client comes from other surroundings.
 * Thread-safe.
 */
public final class ResidentServer implements ConnectionHandler {
    /** Runs a command in the calling thread; interrupting it cancels the command. */
    @FunctionalInterface
    public interface CommandRunner {
        /** Returns the exit code. */
        int run(PrintStream out, PrintStream err, boolean terminal, String... arguments);
    }

    private final CommandRunner runner;
    private final String surroundings;
    private final AtomicInteger clients = new AtomicInteger();
    private @Nullable Thread running;
    private boolean ending;
    private long idleSince = System.nanoTime();

    ResidentServer(CommandRunner runner, String surroundings) {
        this.runner = runner;
        this.surroundings = surroundings;
    }

    /**
     * Serves commands until the end.
     *
     * @param socket path of the socket
     * @param idle   time without a command after which it ends
     * @throws IOException if another process uses the socket, or it cannot be created
     */
    public static void serve(Path socket, Duration idle, CommandRunner runner) throws IOException, InterruptedException {
        var server = new ResidentServer(runner, Surroundings.ofThisProcess());
        try (SocketListener _ = SocketListener.start(server, socket)) {
            server.awaitEnd(idle);
        }
    }

    /** Waits until no command runs and either the idle time is over or the end was requested. No command starts after that. */
    synchronized void awaitEnd(Duration idle) throws InterruptedException {
        while (running != null || !ending) {
            long left = idle.toNanos() - (System.nanoTime() - idleSince);
            if (running == null && left <= 0) {
                ending = true;
            } else if (running == null) {
                wait(left / 1_000_000 + 1);
            } else {
                wait();
            }
        }
    }

    @Override
    public int clientCount() {
        return clients.get();
    }

    @Override
    public void accept(InputStream in, OutputStream out, Closeable connection) {
        clients.incrementAndGet();
        DedicatedThread.create("lightning-resident", () -> answer(in, out, connection)).start();
    }

    private void answer(InputStream in, OutputStream out, Closeable connection) {
        try (connection; var parts = new DataOutputStream(new BufferedOutputStream(out))) {
            ResidentRequest request = ResidentRequest.read(new DataInputStream(in));
            if (request.stop()) {
                requestEnd();
                ResidentAnswer.write(parts, new ResidentAnswer.Exit(0));
            } else if (start(request)) {
                run(request, in, parts);
            } else if (isRunning()) {
                ResidentAnswer.write(parts, new ResidentAnswer.Busy());
            }
            // Otherwise it ends, and the client starts another one.
        } catch (IOException | IllegalArgumentException e) {
            // The client has ended or is none; a command that ran for it is canceled.
        } finally {
            clients.decrementAndGet();
        }
    }

    /** Makes this thread the one that runs a command, unless there is one or this process may not run it. */
    private synchronized boolean start(ResidentRequest request) {
        if (running != null || ending) {
            return false;
        }
        if (!request.surroundings().equals(surroundings)) {
            requestEnd();
            return false;
        }
        running = Thread.currentThread();
        return true;
    }

    private synchronized boolean isRunning() {
        return running != null;
    }

    private synchronized void requestEnd() {
        ending = true;
        notifyAll();
    }

    private void run(ResidentRequest request, InputStream in, DataOutputStream parts) throws IOException {
        try {
            Charset charset = Charset.forName(request.charset());
            var out = new PrintStream(ResidentAnswer.stream(parts, false), true, charset);
            var err = new PrintStream(ResidentAnswer.stream(parts, true), true, charset);
            Thread command = Thread.currentThread();
            DedicatedThread.create("lightning-client", () -> cancelAtEnd(in, command)).start();
            int exit = runner.run(out, err, request.terminal(), request.arguments().toArray(String[]::new));
            out.flush();
            err.flush();
            ResidentAnswer.write(parts, new ResidentAnswer.Exit(exit));
        } finally {
            finish();
        }
    }

    /** Cancels the command when its client ends, which sends nothing more. */
    private void cancelAtEnd(InputStream in, Thread command) {
        try {
            while (in.read() >= 0) {
                continue;
            }
        } catch (IOException e) {
            // The connection was closed, here or by the client.
        }
        synchronized (this) {
            if (command == running) {
                command.interrupt();
            }
        }
    }

    private synchronized void finish() {
        running = null;
        idleSince = System.nanoTime();
        notifyAll();
    }
}
