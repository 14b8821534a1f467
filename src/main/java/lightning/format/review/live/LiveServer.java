package lightning.format.review.live;

import com.sun.net.httpserver.Headers;
import com.sun.net.httpserver.HttpExchange;
import com.sun.net.httpserver.HttpServer;
import com.sun.net.httpserver.HttpsConfigurator;
import com.sun.net.httpserver.HttpsServer;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.net.BindException;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import javax.net.ssl.SSLContext;
import lightning.base.work.DedicatedThread;
import lightning.format.review.ReviewPage;
import org.jspecify.annotations.Nullable;

/** HTTP server of a live review. Every path begins with the token; all others are unknown. */
final class LiveServer implements AutoCloseable {
    private static final int MAX_CHANGE_BYTES = 1 << 20;
    /** Pages that can be open at once. */
    private static final int MAX_PAGES = 50;
    /** Time without news after which a comment shows that the connection lives. */
    private static final long HEARTBEAT_SECONDS = 10;

    static {
        // The only settings of the JDK's server that limit clients that send nothing.
        System.setProperty("sun.net.httpserver.maxReqTime", "30");
        System.setProperty("jdk.httpserver.maxConnections", "200");
    }

    private final HttpServer server;
    private final ExecutorService threads = DedicatedThread.virtualThreadExecutor("lightning-live-review");
    private final byte[] token;
    private final LiveBoard board;
    private final @Nullable Consumer<LiveChange> onChange;
    private final AtomicInteger pages = new AtomicInteger();

    private LiveServer(HttpServer server, String token, LiveBoard board, @Nullable Consumer<LiveChange> onChange) {
        this.server = server;
        this.token = token.getBytes(StandardCharsets.US_ASCII);
        this.board = board;
        this.onChange = onChange;
    }

    /**
     * Starts to listen.
     *
     * @param onChange receives changes; null if pages may not change anything
     */
    static LiveServer start(LiveAddress address, String token, LiveBoard board, @Nullable Consumer<LiveChange> onChange)
            throws IOException {
        InetSocketAddress at = address.resolve();
        HttpServer server;
        try {
            server = address.tls().isPresent() ? secure(at, address.tls().get()) : HttpServer.create(at, 0);
        } catch (BindException e) {
            throw new IOException(at.getHostString() + ":" + at.getPort() + ": cannot listen there: " + e.getMessage(), e);
        }
        var live = new LiveServer(server, token, board, onChange);
        server.createContext("/", live::answer);
        server.setExecutor(live.threads);
        server.start();
        return live;
    }

    private static HttpServer secure(InetSocketAddress at, SSLContext tls) throws IOException {
        HttpsServer server = HttpsServer.create(at, 0);
        server.setHttpsConfigurator(new HttpsConfigurator(tls));
        return server;
    }

    InetSocketAddress address() {
        return server.getAddress();
    }

    int pages() {
        return pages.get();
    }

    private void answer(HttpExchange exchange) throws IOException {
        try (exchange) {
            Headers headers = exchange.getResponseHeaders();
            headers.set("Cache-Control", "no-store");
            headers.set("Referrer-Policy", "no-referrer");
            headers.set("X-Content-Type-Options", "nosniff");
            headers.set("Cross-Origin-Resource-Policy", "same-origin");
            headers.set("X-Frame-Options", "DENY");
            String[] parts = exchange.getRequestURI().getRawPath().split("/", 3);
            if (parts.length < 3 || !MessageDigest.isEqual(parts[1].getBytes(StandardCharsets.UTF_8), token)) {
                send(exchange, 404, "text/plain", "There is no such page.");
                return;
            }
            String path = parts[2];
            boolean isPost = exchange.getRequestMethod().equals("POST");
            if (isPost != path.equals("change") || !isPost && !exchange.getRequestMethod().equals("GET")) {
                send(exchange, 405, "text/plain", "This method is not allowed.");
            } else if (path.isEmpty()) {
                send(exchange, 200, "text/html", ReviewPage.livePage());
            } else if (path.equals("change")) {
                change(exchange);
            } else if (path.equals("events")) {
                events(exchange);
            } else {
                LivePicture picture = board.picture();
                byte[] content = path.equals("data") ? picture == null ? null : picture.data()
                        : path.startsWith("layer/") ? board.layer(path.substring("layer/".length())) : null;
                if (content == null) {
                    send(exchange, 404, "text/plain", "There is no such picture.");
                } else {
                    send(exchange, 200, path.equals("data") ? "application/json" : "text/plain", content);
                }
            }
        }
    }

    private void change(HttpExchange exchange) throws IOException {
        if (onChange == null) {
            send(exchange, 403, "text/plain", "This review does not allow changes.");
            return;
        }
        byte[] bytes;
        try (InputStream in = exchange.getRequestBody()) {
            bytes = in.readNBytes(MAX_CHANGE_BYTES + 1);
        }
        if (bytes.length > MAX_CHANGE_BYTES) {
            send(exchange, 413, "text/plain", "A change has at most " + MAX_CHANGE_BYTES + " bytes.");
            return;
        }
        LiveChange change;
        try {
            change = LiveJson.read(bytes);
        } catch (IOException e) {
            send(exchange, 400, "text/plain", String.valueOf(e.getMessage()));
            return;
        }
        onChange.accept(change);
        exchange.sendResponseHeaders(204, -1);
    }

    /** Sends news until the page is closed or the review ends, as server-sent events (HTML standard, section 9.2). */
    private void events(HttpExchange exchange) throws IOException {
        if (pages.incrementAndGet() > MAX_PAGES) {
            pages.decrementAndGet();
            send(exchange, 503, "text/plain", "Too many pages are open.");
            return;
        }
        try {
            exchange.getResponseHeaders().set("Content-Type", "text/event-stream; charset=utf-8");
            exchange.sendResponseHeaders(200, 0);
            OutputStream out = exchange.getResponseBody();
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

    private static void send(HttpExchange exchange, int status, String type, String text) throws IOException {
        send(exchange, status, type, text.getBytes(StandardCharsets.UTF_8));
    }

    private static void send(HttpExchange exchange, int status, String type, byte[] content) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", type + "; charset=utf-8");
        exchange.sendResponseHeaders(status, content.length == 0 ? -1 : content.length);
        exchange.getResponseBody().write(content);
    }

    @Override
    public void close() {
        // Connections get a second for the news of the end.
        server.stop(1);
        threads.shutdownNow();
    }
}
