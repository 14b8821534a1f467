package lightning.serve;

import lightning.base.work.Progress;
import tools.jackson.databind.JsonNode;

/** Request that was accepted: its fields, its client, and whether it was canceled. */
final class Request {
    private static final long PROGRESS_NANOSECONDS = 100_000_000;

    private final Client client;
    private final JsonNode id;
    private final Method method;
    private final Fields fields;
    private volatile boolean isCanceled;

    Request(Client client, JsonNode id, Method method, Fields fields) {
        this.client = client;
        this.id = id;
        this.method = method;
        this.fields = fields;
    }

    Client client() {
        return client;
    }

    JsonNode id() {
        return id;
    }

    Method method() {
        return method;
    }

    Fields fields() {
        return fields;
    }

    boolean isCanceled() {
        return isCanceled;
    }

    /** Ends it as soon as possible; a finished request stays finished. */
    void cancel() {
        isCanceled = true;
    }

    /** Returns a progress that ends with the request, and reports to its client if the request has {@code "progress": true}. */
    Progress progress() {
        if (!fields.flag("progress")) {
            return Progress.cancellation(this::isCanceled);
        }
        return new Progress() {
            private long lastReport;

            @Override
            public void report(int done, int total) {
                long now = System.nanoTime();
                synchronized (this) {
                    if (now - lastReport < PROGRESS_NANOSECONDS && lastReport != 0) {
                        return;
                    }
                    lastReport = now;
                }
                client.sendProgress(id, total == 0 ? 0 : (double) done / total);
            }

            @Override
            public boolean isCanceled() {
                return isCanceled;
            }
        };
    }
}
