package lightning.serve;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import lightning.base.work.DedicatedThread;
import lightning.base.work.Progress;
import lightning.document.OpenDocument;
import lightning.document.loop.CoarsePicture;
import lightning.render.RenderOptions;
import lightning.render.relight.Renderer;
import lightning.render.relight.UpdateResult;
import lightning.render.trace.MeshMemory;
import lightning.scene.Scene;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.node.ObjectNode;

/** Open scene: its document, its renderer with the cache, and a thread that runs its requests in order. */
final class SceneSession {
    private static final long END_SECONDS = 3;
    private static final long UNKNOWN = -1;

    private final Server server;
    /** Client whose end closes the scene; null if it stays open. */
    private final @Nullable Client owner;
    private final ExecutorService thread = DedicatedThread.sequentialExecutor("lightning-scene");
    private final Renderer renderer;
    private final SharedPictures sharedPictures;
    private final SceneEditing editing = new SceneEditing();
    private final int number;
    private boolean isClosed;
    /** Live page; null if there is none. */
    private volatile @Nullable SceneReview review;
    /** Speed of the last coarse picture; 0 before the first. */
    private double coarsePixelsPerSecond;
    /** Bytes of cache and meshes; −1 if they are not known since the last update. */
    private volatile long usedBytes = UNKNOWN;
    /** Document's file and scene, for other threads; null until it is loaded. */
    private volatile @Nullable Description description;

    private record Description(Path file, Scene scene) {}

    SceneSession(Server server, int number, @Nullable Client owner) {
        this.server = server;
        this.number = number;
        this.owner = owner;
        renderer = new Renderer(RenderOptions.DEFAULT);
        sharedPictures = new SharedPictures(server);
    }

    /** Puts a request into the scene's line. */
    void execute(Request request) {
        SceneReview open = review;
        if (open != null) {
            open.yieldToRequest();
        }
        try {
            thread.execute(() -> run(request));
        } catch (RejectedExecutionException e) {
            request.client().fail(request, Server.unknownScene(number));
        }
    }

    private void run(Request request) {
        ObjectNode result;
        try {
            if (request.isCanceled()) {
                throw new CancellationException();
            }
            if (isClosed) {
                throw Server.unknownScene(number);
            }
            result = switch (request.method()) {
                case OPEN, REPLACE -> open(request);
                case RENDER -> request.fields().has("coarse") ? new CoarseRequest(this, request).run()
                        : new PictureRequest(this, request).run();
                case EXPLAIN -> new PixelRequest(this, request).run();
                case MATCH -> new MatchRequest(this, request).run();
                case REVIEW -> review(request);
                case CLOSE -> {
                    close();
                    yield JsonLines.JSON.createObjectNode();
                }
                default -> edit(request);
            };
        } catch (Throwable e) {
            if (request.method() == Method.OPEN) {
                close();
            }
            request.client().fail(request, Failures.of(e));
            followInReview();
            return;
        }
        request.client().answer(request, result);
        followInReview();
    }

    private void followInReview() {
        if (review != null && !isClosed) {
            review.follow("");
        }
    }

    /** Opens the scene's live page, or returns what is known of the open one, or ends it. Another page keeps notes and changes of the last one. */
    private ObjectNode review(Request request) throws IOException {
        Fields fields = request.fields();
        boolean isChosen = fields.has("allow_edits");
        boolean allowsEdits = fields.flag("allow_edits");
        SceneReview last = review;
        if (fields.flag("end")) {
            if (last != null) {
                last.close();
                review = null;
            }
            return JsonLines.JSON.createObjectNode();
        }
        update(request, 0);
        SceneReview open = last != null && (!isChosen || last.allowsEdits() == allowsEdits) ? last
                : new SceneReview(this, request.client(), allowsEdits, Optional.ofNullable(last));
        review = open;
        if (last != null && last != open) {
            last.close();
        }
        open.showPicture();
        return open.describe();
    }

    /** Runs a task on the scene's thread, after the requests that wait; drops it if the scene is closed. */
    void runLater(Runnable task) {
        try {
            thread.execute(() -> {
                if (!isClosed) {
                    task.run();
                }
            });
        } catch (RejectedExecutionException e) {
            // It is closed.
        }
    }

    /**
     * Makes an edit of a page. Those of one page that follow each other are one step of the history.
     *
     * @return whether the scene changed
     * @throws RequestException if the scene does not allow it
     */
    boolean editByPage(Scene edited, String page) {
        boolean changes = editing.changeByPage(edited, page);
        publish();
        return changes;
    }

    private ObjectNode open(Request request) throws Exception {
        ObjectNode content = editing.open(request.fields(), Progress.cancellation(request::isCanceled));
        publish();
        usedBytes = UNKNOWN;
        ObjectNode result = JsonLines.JSON.createObjectNode().put(Method.SCENE, number);
        result.setAll(content);
        return result;
    }

    private ObjectNode edit(Request request) throws Exception {
        ObjectNode result = editing.run(request.method(), request.fields());
        publish();
        return result;
    }

    /** Makes an edit of a request; returns the history after it. */
    ObjectNode edit(Scene edited) {
        ObjectNode result = editing.change(edited, null);
        publish();
        followInReview();
        return result;
    }

    private void publish() {
        description = new Description(document().file(), scene());
    }

    OpenDocument document() {
        return editing.document();
    }

    Scene scene() {
        return editing.document().scene();
    }

    Renderer renderer() {
        return renderer;
    }

    Server server() {
        return server;
    }

    SharedPictures sharedPictures() {
        return sharedPictures;
    }

    /** Returns the bytes of its cache and meshes. Call only in the turn of a scene. */
    long usedBytes() {
        if (usedBytes == UNKNOWN) {
            usedBytes = countBytes();
        }
        return usedBytes;
    }

    /** Takes milliseconds for large pictures, so an edit must not wait for it. */
    private long countBytes() {
        return description == null ? 0 : MeshMemory.bytes(description.scene) + renderer.state().bytes();
    }

    /**
     * Updates the picture to the scene when it is the scene's turn.
     *
     * @param reserved bytes that the request needs besides
     */
    UpdateResult update(Request request, long reserved) {
        requireFrame();
        return compute(request, options -> {
            try {
                renderer.setOptions(options.withMemory(options.memory() - reserved));
                return renderer.renderOrClear(scene(), request.progress());
            } finally {
                usedBytes = UNKNOWN;
            }
        });
    }

    /** Runs a computation with all threads when it is the scene's turn. */
    <T> T compute(Request request, Function<RenderOptions, T> computation) {
        server.turn().await(request);
        try {
            return computation.apply(server.renderOptions(this));
        } finally {
            server.turn().release(request);
        }
    }

    /** Traces a coarse picture in about so many seconds when it is the scene's turn; the first one has few pixels. */
    CoarsePicture traceCoarse(Request request, double seconds) {
        requireFrame();
        return compute(request, options -> {
            renderer.setOptions(options);
            CoarsePicture picture = CoarsePicture.during(seconds, coarsePixelsPerSecond, scene(), renderer, request.progress());
            coarsePixelsPerSecond = picture.pixelsPerSecond();
            return picture;
        });
    }

    private void requireFrame() {
        document().frameProblem().ifPresent(problem -> {
            throw new RequestException(ErrorCode.BAD_SCENE, "frame", problem);
        });
    }

    /** Describes the scene for a list; empty until it is loaded. */
    Optional<ObjectNode> describe() {
        Description known = description;
        if (known == null) {
            return Optional.empty();
        }
        ObjectNode node = JsonLines.JSON.createObjectNode().put(Method.SCENE, number).put("file", known.file.toString());
        node.putArray("size").add(known.scene.picture().width()).add(known.scene.picture().height());
        return Optional.of(node.put("bytes", usedBytes == UNKNOWN ? countBytes() : usedBytes).put("keep", owner == null));
    }

    /** Closes the scene if this client has opened it, after its requests. */
    void clientGone(Client client) {
        try {
            thread.execute(() -> {
                if (client == owner) {
                    close();
                } else {
                    sharedPictures.close(client);
                }
            });
        } catch (RejectedExecutionException e) {
            // It is closed.
        }
    }

    private void close() {
        if (!isClosed) {
            isClosed = true;
            server.remove(number);
            if (review != null) {
                review.close();
            }
            sharedPictures.close();
            renderer.close();
            thread.shutdown();
        }
    }

    /** Closes the scene after its requests. */
    void end() {
        try {
            thread.execute(this::close);
        } catch (RejectedExecutionException e) {
            // It is closed.
        }
    }

    /** Waits a few seconds until it is closed. */
    void awaitEnd() {
        try {
            thread.awaitTermination(END_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
