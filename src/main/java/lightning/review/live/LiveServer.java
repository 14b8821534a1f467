package lightning.review.live;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.SequencedSet;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import javax.net.ServerSocketFactory;
import javax.net.ssl.SSLContext;
import lightning.base.work.DedicatedThread;
import lightning.review.ReviewPage;
import org.jspecify.annotations.Nullable;

/**
 * HTTP server of a live review. Every path begins with the token; all others are unknown. A connection serves one request. Those that have
 * not sent the token yet are limited in number and time, and a new one ends the oldest of them, so that they keep nobody else out.
 */
final class LiveServer implements AutoCloseable {
    private static final int MAX_CHANGE_BYTES = 1 << 20;
    /** Pages that can be open at the same time. */
    private static final int MAX_PAGES = 50;
    /** Pages whose notes a review takes. */
    private static final int MAX_PAGES_WITH_NOTES = 100;
    /** Time without news after which a comment shows that the connection lives. */
    private static final long HEARTBEAT_SECONDS = 10;
    /** Connections that have not sent the token, and those that have. */
    private static final int MAX_STRANGERS = 128;
    private static final int MAX_ADMITTED = 200;
    private static final long HEAD_MILLISECONDS = 10_000;
    private static final long CONTENT_MILLISECONDS = 30_000;
    private static final long SKIP_MILLISECONDS = 2_000;
    private static final String HEADERS = """
            Connection: close\r
            Cache-Control: no-store\r
            Referrer-Policy: no-referrer\r
            X-Content-Type-Options: nosniff\r
            Cross-Origin-Resource-Policy: same-origin\r
            X-Frame-Options: DENY\r
            """;

    private final ServerSocket server;
    private final ExecutorService threads = DedicatedThread.virtualThreadExecutor("lightning-live-review");
    private final byte[] token;
    private final LiveBoard board;
    private final @Nullable Consumer<LiveChange> onChange;
    private final AtomicInteger pages = new AtomicInteger();
    /** Connections without the token, the oldest first, and those with it; guarded by this set. */
    private final SequencedSet<Socket> strangers = new LinkedHashSet<>();
    private final Set<Socket> admitted = new HashSet<>();
    private final Set<String> pagesWithNotes = new HashSet<>();

    private LiveServer(ServerSocket server, String token, LiveBoard board, @Nullable Consumer<LiveChange> onChange) {
        this.server = server;
        this.token = token.getBytes(StandardCharsets.US_ASCII);
        this.board = board;
        this.onChange = onChange;
    }

    /**
     * Starts to listen.
     *
     * @param onChange receives changes before they are answered; null if pages may not change anything
     */
    static LiveServer start(LiveAddress address, String token, LiveBoard board, @Nullable Consumer<LiveChange> onChange)
            throws IOException {
        InetSocketAddress at = address.resolve();
        ServerSocketFactory factory =
                address.tls().<ServerSocketFactory>map(SSLContext::getServerSocketFactory).orElse(ServerSocketFactory.getDefault());
        ServerSocket server;
        try {
            server = factory.createServerSocket(at.getPort(), MAX_STRANGERS, at.getAddress());
        } catch (BindException e) {
            throw new IOException(at.getHostString() + ":" + at.getPort() + ": cannot listen there: " + e.getMessage(), e);
        }
        var live = new LiveServer(server, token, board, onChange);
        DedicatedThread.create("lightning-live-review", live::accept).start();
        return live;
    }

    InetSocketAddress address() {
        return (InetSocketAddress) server.getLocalSocketAddress();
    }

    int pages() {
        return pages.get();
    }

    private void accept() {
        while (!server.isClosed()) {
            try {
                Socket socket = server.accept();
                Socket oldest;
                synchronized (strangers) {
                    strangers.add(socket);
                    oldest = strangers.size() > MAX_STRANGERS ? strangers.removeFirst() : null;
                }
                end(oldest);
                try {
                    threads.execute(() -> serve(socket));
                } catch (RejectedExecutionException e) {
                    end(socket);
                }
            } catch (IOException e) {
                // Closed, or the client left before it was accepted, or no file handle is free.
                pause();
            }
        }
    }

    /** Leaves the processor to others if each try fails. */
    private void pause() {
        try {
            TimeUnit.MILLISECONDS.sleep(server.isClosed() ? 0 : 50);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void end(@Nullable Closeable socket) {
        if (socket != null) {
            try {
                socket.close();
            } catch (IOException e) {
                // It has ended.
            }
        }
    }

    private void serve(Socket socket) {
        try (socket) {
            answer(socket);
        } catch (IOException e) {
            // The client left, or was too slow.
        } finally {
            synchronized (strangers) {
                strangers.remove(socket);
                admitted.remove(socket);
            }
        }
    }

    private void answer(Socket socket) throws IOException {
        LiveRequest request;
        try {
            request = LiveRequest.read(socket, HEAD_MILLISECONDS);
        } catch (LiveRequest.BadRequestException e) {
            send(socket, "400 Bad Request", "text/plain", String.valueOf(e.getMessage()));
            return;
        }
        String[] parts = request.path().split("/", 3);
        if (parts.length < 3 || !MessageDigest.isEqual(parts[1].getBytes(StandardCharsets.US_ASCII), token)) {
            send(socket, "404 Not Found", "text/plain", "There is no such page.");
        } else if (!admit(socket)) {
            send(socket, "503 Service Unavailable", "text/plain", "Too many connections are open.");
        } else {
            answer(socket, request, parts[2]);
        }
    }

    private boolean admit(Socket socket) {
        synchronized (strangers) {
            return admitted.size() < MAX_ADMITTED && strangers.remove(socket) && admitted.add(socket);
        }
    }

    /** @param path path after the token */
    private void answer(Socket socket, LiveRequest request, String path) throws IOException {
        boolean isPost = request.method().equals("POST");
        if (isPost != path.equals("change") || !isPost && !request.method().equals("GET")) {
            refuse(socket, request, "405 Method Not Allowed", "This method is not allowed.");
        } else if (path.isEmpty()) {
            send(socket, "200 OK", "text/html", ReviewPage.livePage());
        } else if (isPost) {
            change(socket, request);
        } else if (path.equals("events")) {
            events(socket);
        } else {
            LivePicture picture = board.picture();
            byte[] content = path.equals("data") ? picture == null ? null : picture.data()
                    : path.startsWith("layer/") ? board.layer(path.substring("layer/".length())) : null;
            if (content == null) {
                send(socket, "404 Not Found", "text/plain", "There is no such picture.");
            } else {
                send(socket, "200 OK", path.equals("data") ? "application/json" : "text/plain", content);
            }
        }
    }

    private void change(Socket socket, LiveRequest request) throws IOException {
        Consumer<LiveChange> receiver = onChange;
        if (receiver == null) {
            refuse(socket, request, "403 Forbidden", "This review does not allow changes.");
            return;
        }
        if (request.length() > MAX_CHANGE_BYTES) {
            refuse(socket, request, "413 Content Too Large", "A change has at most " + MAX_CHANGE_BYTES + " bytes.");
            return;
        }
        byte[] content = request.content(socket, CONTENT_MILLISECONDS);
        LiveChange change;
        try {
            change = LiveJson.read(content);
        } catch (IOException e) {
            send(socket, "400 Bad Request", "text/plain", String.valueOf(e.getMessage()));
            return;
        }
        if (!takesNotes(change)) {
            send(socket, "429 Too Many Requests", "text/plain",
                    "This review has notes of " + MAX_PAGES_WITH_NOTES + " pages, and takes no notes of another one.");
            return;
        }
        receiver.accept(change);
        socket.getOutputStream().write(head("204 No Content", ""));
    }

    private boolean takesNotes(LiveChange change) {
        synchronized (pagesWithNotes) {
            return change.notes().isEmpty() || pagesWithNotes.contains(change.page())
                    || pagesWithNotes.size() < MAX_PAGES_WITH_NOTES && pagesWithNotes.add(change.page());
        }
    }

    /** Sends news until the page is closed or the review ends, as server-sent events (HTML standard, section 9.2). */
    private void events(Socket socket) throws IOException {
        if (pages.incrementAndGet() > MAX_PAGES) {
            pages.decrementAndGet();
            send(socket, "503 Service Unavailable", "text/plain", "Too many pages are open.");
            return;
        }
        try {
            OutputStream out = socket.getOutputStream();
            out.write(head("200 OK", "Content-Type: text/event-stream; charset=utf-8\r\n"));
            LiveBoard.News news = LiveBoard.News.NONE;
            while (!news.isClosed()) {
                news = board.await(news, HEARTBEAT_SECONDS);
                String text = news.isClosed() ? "event: end\ndata: \n\n"
                        : (news.state() == null ? ":\n\n" : "event: state\ndata: " + news.state() + "\n\n")
                                + (news.isNewPicture() ? "event: picture\ndata: \n\n" : "");
                out.write(text.getBytes(StandardCharsets.UTF_8));
                out.flush();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            pages.decrementAndGet();
        }
    }

    /** Refuses a request whose content is not read. */
    private static void refuse(Socket socket, LiveRequest request, String status, String text) throws IOException {
        send(socket, status, "text/plain", text);
        request.skipContent(socket, SKIP_MILLISECONDS);
    }

    private static void send(Socket socket, String status, String type, String text) throws IOException {
        send(socket, status, type, text.getBytes(StandardCharsets.UTF_8));
    }

    private static void send(Socket socket, String status, String type, byte[] content) throws IOException {
        OutputStream out = socket.getOutputStream();
        out.write(head(status, "Content-Type: " + type + "; charset=utf-8\r\nContent-Length: " + content.length + "\r\n"));
        out.write(content);
        out.flush();
    }

    private static byte[] head(String status, String headers) {
        return ("HTTP/1.1 " + status + "\r\n" + HEADERS + headers + "\r\n").getBytes(StandardCharsets.US_ASCII);
    }

    @Override
    public void close() {
        end(server);
        // Connections get a second for the news of the end.
        threads.shutdown();
        Set<Socket> open;
        synchronized (strangers) {
            strangers.forEach(LiveServer::end);
            open = Set.copyOf(admitted);
        }
        try {
            threads.awaitTermination(1, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        threads.shutdownNow();
        open.forEach(LiveServer::end);
    }
}
