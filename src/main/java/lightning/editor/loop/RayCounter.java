package lightning.editor.loop;

/** Counts the rays of one stage of an image on all threads. Thread-safe. */
final class RayCounter {
    private RenderActivity.Stage stage = RenderActivity.Stage.CENTERS;
    private long startNs = System.nanoTime();
    /** Time of the first report; its rays were cast before. */
    private long firstNs;
    private long lastNs;
    private long rays;
    private boolean hasRays;

    synchronized void start(RenderActivity.Stage next) {
        stage = next;
        startNs = System.nanoTime();
        rays = 0;
        hasRays = false;
        firstNs = 0;
        lastNs = 0;
    }

    synchronized void add(long count) {
        lastNs = System.nanoTime();
        if (hasRays) {
            rays += count;
        } else {
            hasRays = true;
            firstNs = lastNs;
        }
    }

    synchronized RenderActivity activity() {
        return new RenderActivity(stage, rays, System.nanoTime() - startNs, lastNs - firstNs);
    }
}
