package lightning.serve;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CountDownLatch;
import lightning.base.file.ScratchFolder;
import lightning.base.file.SharedMemoryFile;
import lightning.base.text.ReleaseInfo;
import lightning.base.work.WorkerPool;
import lightning.render.RenderOptions;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Server of scenes: accepts clients and gives their requests to scenes. Thread-safe. */
public final class Server implements ConnectionHandler, AutoCloseable {
    /** Version of the protocol; grows with every change that an older client would not understand. */
    static final int PROTOCOL = 1;
    static final int MAX_SCENES = 100;

    private final ServerOptions options;
    private final WorkerPool writers;
    private final RenderTurn turn = new RenderTurn();
    private final Map<Integer, SceneSession> scenes = new ConcurrentSkipListMap<>();
    private final Set<Client> clients = ConcurrentHashMap.newKeySet();
    private final CountDownLatch stopped = new CountDownLatch(1);
    private int lastScene;
    private @Nullable ScratchFolder sharedFiles;
    private int lastPicture;

    public Server(ServerOptions options) {
        this.options = options;
        writers = new WorkerPool(options.threads());
    }

    /**
     * Starts to answer a client until its input ends.
     *
     * @param connection is closed after the last answer; the streams are not
     */
    public Client connect(InputStream in, OutputStream out, Closeable connection) {
        var client = new Client(this, in, out, connection);
        clients.add(client);
        client.start();
        return client;
    }

    @Override
    public void accept(InputStream in, OutputStream out, Closeable connection) {
        connect(in, out, connection);
    }

    @Override
    public int clientCount() {
        return clients.size();
    }

    /** Forgets a client, and closes the scenes that only it has opened. */
    void remove(Client client) {
        clients.remove(client);
        scenes.values().forEach(scene -> scene.clientGone(client));
    }

    /** Lets {@link #awaitStop} return. */
    public void stop() {
        stopped.countDown();
    }

    /** Waits for {@link #stop}, or until a client requests the end. */
    public void awaitStop() throws InterruptedException {
        stopped.await();
    }

    /**
     * Runs a request, or puts it into the line of its scene.
     *
     * @throws RequestException if it is refused at once
     */
    void run(Request request) {
        if (request.method().hasScene()) {
            int number = request.fields().integer(Method.SCENE, 1, Integer.MAX_VALUE);
            SceneSession scene = scenes.get(number);
            if (scene == null) {
                throw unknownScene(number);
            }
            scene.execute(request);
            return;
        }
        switch (request.method()) {
            case OPEN -> open(request);
            case LIST -> request.client().answer(request, list());
            case CANCEL -> request.client().answer(request, JsonLines.JSON.createObjectNode().put("canceled",
                    request.client().cancel(request.fields().id("request"))));
            default -> {
                request.client().answer(request, JsonLines.JSON.createObjectNode());
                stop();
            }
        }
    }

    static RequestException unknownScene(int number) {
        return new RequestException(ErrorCode.UNKNOWN_SCENE, Method.SCENE, "there is no open scene " + number);
    }

    /** The scene has its number at once, so that a client can send requests for it before it is loaded. */
    private void open(Request request) {
        SceneSession scene;
        synchronized (scenes) {
            if (scenes.size() >= MAX_SCENES) {
                throw new RequestException(ErrorCode.LIMIT, "", "at most " + MAX_SCENES + " scenes can be open; close one first");
            }
            lastScene++;
            scene = new SceneSession(this, lastScene, request.fields().flag("keep") ? null : request.client());
            scenes.put(lastScene, scene);
        }
        scene.execute(request);
    }

    /** Removes a scene that is closed, or could not be opened. */
    void remove(int number) {
        scenes.remove(number);
    }

    private ObjectNode list() {
        ObjectNode list = JsonLines.JSON.createObjectNode().put("version", ReleaseInfo.text()).put("protocol", PROTOCOL)
                .put("memory", options.memory());
        ArrayNode all = list.putArray("scenes");
        scenes.values().forEach(scene -> scene.describe().ifPresent(all::add));
        return list;
    }

    RenderTurn turn() {
        return turn;
    }

    /** Returns the threads that write pictures. */
    WorkerPool writers() {
        return writers;
    }

    /** Returns options with the memory that other scenes leave to one. Call only in the scene's turn. */
    RenderOptions renderOptions(SceneSession scene) {
        long others = scenes.values().stream().filter(other -> other != scene).mapToLong(SceneSession::usedBytes).sum();
        return RenderOptions.DEFAULT.withThreads(options.threads()).withMemory(options.memory() - others);
    }

    /** Lets canceled requests that wait for their turn end. */
    void wakeCanceled() {
        turn.wake();
    }

    /** Returns an unused path for a picture that a client maps into its memory; the folder is removed at the end. */
    synchronized Path newSharedPath() throws IOException {
        return sharedFiles().file("picture-" + ++lastPicture + ".rgb");
    }

    /** Creates a file at a path that a client names. If this server is killed, the next one removes it. */
    synchronized SharedMemoryFile createShared(Path path, long bytes) throws IOException {
        ScratchFolder folder = sharedFiles();
        ScratchFolder.removeStaleIn(SharedMemoryFile.folder());
        SharedMemoryFile file = SharedMemoryFile.create(path, bytes);
        folder.addOutside(path);
        return file;
    }

    private ScratchFolder sharedFiles() throws IOException {
        if (sharedFiles == null) {
            sharedFiles = ScratchFolder.createIn(SharedMemoryFile.folder());
        }
        return sharedFiles;
    }

    /** Cancels all requests, closes all scenes and removes all files that clients map. */
    @Override
    public void close() {
        clients.parallelStream().forEach(Client::close);
        List<SceneSession> open = List.copyOf(scenes.values());
        open.forEach(SceneSession::end);
        open.forEach(SceneSession::awaitEnd);
        writers.close();
        synchronized (this) {
            if (sharedFiles != null) {
                sharedFiles.close();
            }
        }
    }
}
