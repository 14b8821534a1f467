package lightning.review.live;

import java.io.IOException;
import java.net.InetAddress;
import java.security.SecureRandom;
import java.util.Base64;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import lightning.base.text.Messages;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.render.RenderOptions;
import lightning.render.cache.PixelCache;
import lightning.render.image.ViewTransform;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;

/**
 * A review page that follows a scene while it is edited. The owner of the scene reports its states and its exact pictures; pages get values at
 * once, and layers of lights when they are ready. A person who knows the address can read, and edit the lights if the owner allowed it. Thread-safe.
 */
public final class LiveReview implements AutoCloseable {
    private static final int TOKEN_BYTES = 24;
    /** Time without a newer picture before layers are computed. */
    private static final long QUIET_MILLISECONDS = 250;

    private final String title;
    private final boolean allowsEdits;
    private final LiveBoard board = new LiveBoard();
    private final LiveServer server;
    private final String url;
    private final ExecutorService thread = DedicatedThread.lowPriorityExecutor("lightning-live-review");
    private final AtomicReference<Object> newest = new AtomicReference<>();
    private volatile String problem = "";
    private @Nullable LiveLayers layers;
    private @Nullable LiveState start;

    private LiveReview(String title, boolean allowsEdits, LiveAddress address, Consumer<LiveChange> onChange) throws IOException {
        this.title = title;
        this.allowsEdits = allowsEdits;
        byte[] random = new byte[TOKEN_BYTES];
        new SecureRandom().nextBytes(random);
        String token = Base64.getUrlEncoder().withoutPadding().encodeToString(random);
        server = LiveServer.start(address, token, board, allowsEdits ? onChange : null);
        InetAddress bound = server.address().getAddress();
        String host = bound.isAnyLocalAddress() ? InetAddress.getLocalHost().getHostName() : bound.getHostAddress();
        url = (address.tls().isPresent() ? "https" : "http") + "://" + (host.contains(":") ? "[" + host + "]" : host) + ":"
                + server.address().getPort() + "/" + token + "/";
    }

    /**
     * Starts a review without a picture.
     *
     * @param title       name of the scene
     * @param allowsEdits whether pages may change lights
     * @param onChange    receives changes of pages, on threads of the server
     * @throws IOException if it cannot listen at the address; the message is a sentence for the user
     */
    public static LiveReview start(String title, LiveAddress address, boolean allowsEdits, Consumer<LiveChange> onChange)
            throws IOException {
        return new LiveReview(title, allowsEdits, address, onChange);
    }

    /** Returns the address of the page, with the token that admits. */
    public String url() {
        return url;
    }

    /** Returns why pages do not show the newest picture; empty if they do, or soon will. */
    public String problem() {
        return problem;
    }

    /** Returns the number of pages that are open. */
    public int pages() {
        return server.pages();
    }

    /**
     * Shows the values of a scene in all pages.
     *
     * @param page page whose change led to it, which does not need them; empty for none
     */
    public void show(Scene scene, String page) {
        board.show(LiveJson.write(LiveState.of(scene)).put("page", page).toString());
    }

    /**
     * Shows an exact picture in all pages as soon as its layers are computed, unless a newer one comes first.
     *
     * @param cache   cache of a finished picture
     * @param options options of its render
     */
    public void show(PixelCache cache, RenderOptions options, ViewTransform view) {
        var token = new Object();
        newest.set(token);
        thread.execute(() -> {
            try {
                TimeUnit.MILLISECONDS.sleep(QUIET_MILLISECONDS);
                if (newest.get() == token) {
                    publish(cache, options, view, Progress.cancellation(() -> newest.get() != token));
                }
                problem = "";
            } catch (CancellationException | InterruptedException e) {
                // A newer picture comes, or the review has ended.
            } catch (OutOfMemoryError e) {
                layers = null;
                problem = Messages.tr("Not enough memory for the lights of this picture; choose a smaller one");
            }
        });
    }

    private void publish(PixelCache cache, RenderOptions options, ViewTransform view, Progress progress) {
        LiveLayers computed = LiveLayers.of(cache, options, layers == null ? List.of() : List.of(layers), progress);
        layers = computed;
        LiveState now = LiveState.of(cache.scene());
        LiveState zero = start == null ? now : LivePicture.withNew(start, now);
        start = zero;
        board.show(LivePicture.of(title, computed, view, zero, allowsEdits));
    }

    /** Ends the review; pages say so. */
    @Override
    public void close() {
        newest.set(new Object());
        thread.shutdownNow();
        board.close();
        server.close();
    }
}
