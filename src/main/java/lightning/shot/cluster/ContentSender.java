package lightning.shot.cluster;

import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.RejectedExecutionException;
import java.util.function.Consumer;
import lightning.base.work.DedicatedThread;
import lightning.shot.cluster.wire.Message;
import org.jspecify.annotations.Nullable;

/**
 * Sends the content that one node requests, on a thread of its own: disks and slow links delay neither other nodes nor messages that this
 * node sends.
 */
final class ContentSender implements AutoCloseable {
    /** More than a node requests; further requests are dropped, because a node repeats them. */
    private static final int MAX_WAITING = 16;

    private final AssetTransfer assets;
    private final Consumer<Message> send;
    private final ExecutorService thread = DedicatedThread.sequentialExecutor("lightning-content");
    /** Requests that wait or are being answered. */
    private final Set<Message.RequestContent> waiting = ConcurrentHashMap.newKeySet();
    private final PartSize size = new PartSize();
    private Message.@Nullable RequestContent last;
    private int lastBytes;
    private long lastSent;

    /** @param send sends a message to the node; may block */
    ContentSender(AssetTransfer assets, Consumer<Message> send) {
        this.assets = assets;
        this.send = send;
    }

    /** Answers a request in the background; ignores one that is being answered. */
    void request(Message.RequestContent request) {
        long receivedAt = System.nanoTime();
        if (waiting.size() < MAX_WAITING && waiting.add(request)) {
            try {
                thread.execute(() -> answer(request, receivedAt));
            } catch (RejectedExecutionException e) {
                // Closed meanwhile.
            }
        }
    }

    private void answer(Message.RequestContent request, long receivedAt) {
        try {
            adaptSize(request, receivedAt);
            byte[] bytes = assets.readPart(request.hash(), request.offset(), size.bytes());
            last = request;
            lastBytes = bytes.length;
            lastSent = System.nanoTime();
            send.accept(new Message.ContentPart(request.session(), request.hash(), request.offset(), bytes));
        } finally {
            waiting.remove(request);
        }
    }

    /** A request for the next part shows how long the last one took. */
    private void adaptSize(Message.RequestContent request, long receivedAt) {
        if (request.equals(last)) {
            size.shrink();
        } else if (last != null && request.hash().equals(last.hash()) && request.offset() == last.offset() + lastBytes) {
            size.adapt(lastBytes, receivedAt - lastSent);
        }
    }

    /** Stops sending. */
    @Override
    public void close() {
        thread.shutdownNow();
    }
}
