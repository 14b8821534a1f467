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
import lightning.base.work.OwnThread;

/**
 * Accepts TLS connections, runs each handshake on a thread of its own, and returns only established connections. JGroups accepts with one
 * thread: a handshake there makes all other members wait, and members that connect to each other at the same moment wait for each other.
 */
final class HandshakeServerSocket extends ServerSocket {
    /** Handshakes at the same time; further connections wait in the system's backlog. */
    private static final int MOST_HANDSHAKES = 32;
    /** Pause after an accept that failed, as without free file handles. */
    private static final long PAUSE_MILLISECONDS = 100;

    private final SSLContext context;
    private final SSLParameters parameters;
    private final int patience;
    private final Semaphore free = new Semaphore(MOST_HANDSHAKES);
    /** Established connections; empty once the socket is closed. */
    private final BlockingQueue<Optional<Socket>> established = new LinkedBlockingQueue<>();
    private final ExecutorService handshakes = OwnThread.forEach("lightning-handshake");

    /** @param patience milliseconds that a peer may be silent during its handshake */
    HandshakeServerSocket(SSLContext context, SSLParameters parameters, int patience) throws IOException {
        this.context = context;
        this.parameters = parameters;
        this.patience = patience;
    }

    @Override
    public void bind(SocketAddress address, int backlog) throws IOException {
        super.bind(address, backlog);
        OwnThread.of("lightning-accept", this::listen).start();
    }

    /** Returns the next connection whose handshake is done. */
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

    private void listen() {
        try {
            while (!isClosed()) {
                free.acquire();
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
            free.release();
            Thread.sleep(isClosed() ? 0 : PAUSE_MILLISECONDS);
        }
    }

    private void establish(Socket plain) {
        try {
            SSLSocket socket = (SSLSocket) context.getSocketFactory().createSocket(plain, null, true);
            socket.setUseClientMode(false);
            socket.setSSLParameters(parameters);
            socket.setSoTimeout(patience);
            socket.startHandshake();
            socket.setSoTimeout(0);
            offer(socket);
        } catch (IOException e) {
            // A stranger, or a peer that gave up.
            close(plain);
        } finally {
            free.release();
        }
    }

    private synchronized void offer(Socket socket) {
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
