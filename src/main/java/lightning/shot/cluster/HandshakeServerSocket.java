package lightning.shot.cluster;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.SocketAddress;
import java.net.SocketException;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import javax.net.ssl.SSLContext;
import javax.net.ssl.SSLParameters;
import javax.net.ssl.SSLSocket;
import lightning.base.work.DedicatedThread;

/**
 * Server socket that runs each TLS handshake on its own thread and returns only established connections. JGroups accepts with one thread: a
 * slow handshake would block all other members, and members that connect to each other at the same moment would deadlock.
 */
final class HandshakeServerSocket extends ServerSocket {
    /** Maximum concurrent handshakes; further connections wait in the system's backlog. */
    private static final int MAX_HANDSHAKES = 32;
    /** Pause after a failed accept, for example without free file handles. */
    private static final long PAUSE_MILLISECONDS = 100;

    private final SSLContext context;
    private final SSLParameters parameters;
    private final int timeoutMillis;
    private final Semaphore permits = new Semaphore(MAX_HANDSHAKES);
    /** Established connections; empty once the socket is closed. */
    private final BlockingQueue<Optional<Socket>> established = new LinkedBlockingQueue<>();
    private final ExecutorService handshakes = DedicatedThread.virtualThreadExecutor("lightning-handshake");

    /** @param timeoutMillis maximum silence of a peer during its handshake, milliseconds */
    HandshakeServerSocket(SSLContext context, SSLParameters parameters, int timeoutMillis) throws IOException {
        this.context = context;
        this.parameters = parameters;
        this.timeoutMillis = timeoutMillis;
    }

    @Override
    public void bind(SocketAddress address, int backlog) throws IOException {
        super.bind(address, backlog);
        DedicatedThread.create("lightning-accept", this::acceptLoop).start();
    }

    /** Returns the next established connection. */
    @Override
    public Socket accept() throws IOException {
        try {
            Optional<Socket> next = established.take();
            if (next.isEmpty()) {
                established.add(next);
                throw new SocketException("the server socket is closed");
            }
            return next.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new InterruptedIOException();
        }
    }

    private void acceptLoop() {
        try {
            while (!isClosed()) {
                permits.acquire();
                acceptNext();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void acceptNext() throws InterruptedException {
        try {
            Socket plain = super.accept();
            handshakes.execute(() -> establish(plain));
        } catch (IOException e) {
            permits.release();
            Thread.sleep(isClosed() ? 0 : PAUSE_MILLISECONDS);
        }
    }

    private void establish(Socket plain) {
        try {
            SSLSocket socket = (SSLSocket) context.getSocketFactory().createSocket(plain, null, true);
            socket.setUseClientMode(false);
            socket.setSSLParameters(parameters);
            socket.setSoTimeout(timeoutMillis);
            socket.startHandshake();
            socket.setSoTimeout(0);
            enqueue(socket);
        } catch (IOException e) {
            // An unauthorized peer, or one that gave up.
            close(plain);
        } finally {
            permits.release();
        }
    }

    private synchronized void enqueue(Socket socket) {
        if (isClosed()) {
            close(socket);
        } else {
            established.add(Optional.of(socket));
        }
    }

    private static void close(Socket socket) {
        try {
            socket.close();
        } catch (IOException e) {
            // Closed either way.
        }
    }

    @Override
    public synchronized void close() throws IOException {
        super.close();
        established.forEach(waiting -> waiting.ifPresent(HandshakeServerSocket::close));
        established.clear();
        established.add(Optional.empty());
    }
}
