package lightning.serve;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import lightning.base.work.DedicatedThread;
import org.jspecify.annotations.Nullable;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Connection of one client. Its input ends its requests only once they are answered, so that a file of requests can be piped in. To
 * notice a client that is gone, it then gets a message each second: if one cannot be written, all its requests are canceled.
 */
public final class Client {
    /** Most requests that wait for their answers; further ones are not read until then. */
    static final int MAX_WAITING = 64;
    private static final long CLOSE_SECONDS = 3;
    private static final long EVENT_NANOSECONDS = 1_000_000_000;
    private static final Outgoing END = new Outgoing(null, false);

    private final Server server;
    private final JsonLines input;
    private final OutputStream output;
    private final Closeable connection;
    private final LinkedBlockingQueue<Outgoing> outgoing = new LinkedBlockingQueue<>();
    private final Semaphore free = new Semaphore(MAX_WAITING);
    private final Map<JsonNode, Request> waiting = new ConcurrentHashMap<>();
    private final CountDownLatch written = new CountDownLatch(1);
    private final CountDownLatch ended = new CountDownLatch(1);
    private volatile boolean isGone;

    /** @param isAnswer whether the client may send another request when it is written */
    private record Outgoing(byte @Nullable [] line, boolean isAnswer) {}

    Client(Server server, InputStream in, OutputStream out, Closeable connection) {
        this.server = server;
        input = new JsonLines(in);
        output = out;
        this.connection = connection;
    }

    void start() {
        DedicatedThread.create("lightning-client-writer", this::write).start();
        DedicatedThread.create("lightning-client", this::run).start();
    }

    /** Waits until the input has ended and all its requests are answered. */
    public void awaitEnd() throws InterruptedException {
        ended.await();
    }

    private void run() {
        try {
            read();
            finish();
        } catch (IOException e) {
            // The client is gone.
            isGone = true;
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            end();
        }
    }

    private void read() throws IOException, InterruptedException {
        while (!isGone) {
            free.acquire();
            try {
                byte[] line = input.next();
                if (line == null) {
                    return;
                }
                accept(line);
            } catch (RequestException e) {
                fail(JsonLines.JSON.nullNode(), e);
            } catch (OutOfMemoryError e) {
                fail(JsonLines.JSON.nullNode(), Failures.of(e));
            }
        }
    }

    private void accept(byte[] line) {
        var fields = new Fields(JsonLines.parse(line));
        JsonNode id;
        try {
            id = fields.id("id");
        } catch (RequestException e) {
            throw new RequestException(ErrorCode.BAD_MESSAGE, "id", e.getMessage());
        }
        try {
            Method method = Method.of(fields.string("method"));
            fields.requireKnown(method.fields());
            Request request = new Request(this, id, method, fields);
            if (waiting.putIfAbsent(id, request) != null) {
                throw Fields.bad("id", "another request with this id waits for its answer");
            }
            run(request);
        } catch (RequestException e) {
            fail(id, e);
        }
    }

    private void run(Request request) {
        try {
            server.run(request);
        } catch (RequestException e) {
            fail(request, e);
        }
    }

    /** Waits for the answers of all requests, and checks each second that the client still reads. */
    private void finish() throws InterruptedException {
        long nextEvent = System.nanoTime() + EVENT_NANOSECONDS;
        synchronized (waiting) {
            while (!waiting.isEmpty() && !isGone) {
                long left = nextEvent - System.nanoTime();
                if (left > 0) {
                    TimeUnit.NANOSECONDS.timedWait(waiting, left);
                } else {
                    ObjectNode event = JsonLines.JSON.createObjectNode().put("event", "finishing").put("waiting", waiting.size());
                    outgoing.add(new Outgoing(line(event), false));
                    nextEvent += EVENT_NANOSECONDS;
                }
            }
        }
    }

    private void end() {
        cancelAll();
        server.remove(this);
        outgoing.add(END);
        try {
            written.await(CLOSE_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        closeConnection();
        ended.countDown();
    }

    private void closeConnection() {
        try {
            connection.close();
        } catch (IOException e) {
            // Nothing is left to be lost.
        }
    }

    /** Ends the connection from the server's side: cancels all requests, and answers them if the client still reads. */
    void close() {
        cancelAll();
        try {
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(CLOSE_SECONDS);
            synchronized (waiting) {
                while (!waiting.isEmpty() && System.nanoTime() < end && !isGone) {
                    waiting.wait(100);
                }
            }
            outgoing.add(END);
            written.await(1, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        closeConnection();
    }

    private void cancelAll() {
        waiting.values().forEach(Request::cancel);
        server.wakeCanceled();
    }

    /** Cancels a request; returns whether one with this id waits for its answer. */
    boolean cancel(JsonNode id) {
        Request request = waiting.get(id);
        if (request == null) {
            return false;
        }
        request.cancel();
        server.wakeCanceled();
        return true;
    }

    /** Answers a request with a result. */
    void answer(Request request, ObjectNode result) {
        ObjectNode message = JsonLines.JSON.createObjectNode();
        message.set("id", request.id());
        message.set("result", result);
        finish(request, message);
    }

    /** Answers a request with an error. */
    void fail(Request request, RequestException e) {
        finish(request, error(request.id(), e));
    }

    /** The end of the input must not overtake the answer. */
    private void finish(Request request, ObjectNode message) {
        byte[] line = line(message);
        synchronized (waiting) {
            waiting.remove(request.id(), request);
            outgoing.add(new Outgoing(line, true));
            waiting.notifyAll();
        }
    }

    private void fail(JsonNode id, RequestException e) {
        outgoing.add(new Outgoing(line(error(id, e)), true));
    }

    private static ObjectNode error(JsonNode id, RequestException e) {
        ObjectNode message = JsonLines.JSON.createObjectNode();
        message.set("id", id);
        ObjectNode error = message.putObject("error").put("code", e.code().text()).put("place", e.place()).put("message", e.getMessage());
        if (e.problems().size() > 1) {
            var problems = error.putArray("problems");
            e.problems().forEach(problem -> problems.add(problem.toString()));
        }
        return message;
    }

    /** Reports the progress of a request, from 0 to 1; drops the report if earlier messages are not written yet. */
    void sendProgress(JsonNode id, double share) {
        if (outgoing.isEmpty()) {
            ObjectNode message = JsonLines.JSON.createObjectNode();
            message.set("id", id);
            message.put("progress", share);
            outgoing.add(new Outgoing(line(message), false));
        }
    }

    private static byte[] line(ObjectNode message) {
        byte[] text = JsonLines.JSON.writeValueAsBytes(message);
        byte[] line = new byte[text.length + 1];
        System.arraycopy(text, 0, line, 0, text.length);
        line[text.length] = '\n';
        return line;
    }

    private void write() {
        try {
            for (Outgoing next = outgoing.take(); next != END; next = outgoing.take()) {
                if (!isGone) {
                    try {
                        output.write(next.line);
                        output.flush();
                    } catch (IOException e) {
                        isGone = true;
                        cancelAll();
                        closeConnection();
                        synchronized (waiting) {
                            waiting.notifyAll();
                        }
                    }
                }
                if (next.isAnswer) {
                    free.release();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        } finally {
            written.countDown();
        }
    }
}
