package lightning.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.work.DedicatedThread;
import lightning.render.image.Film;

/**
 * Relighter of all frames of a shot: updates the focused frame first, then its neighbors outwards. A new edit replaces the previous one; a
 * frame that missed some is updated directly to the newest. Works on its own threads; thread-safe.
 */
public final class ShotRelighter implements AutoCloseable {
    private final int first;
    private final int last;
    private final FrameQueue queue;
    private final ShotListener listener;
    /** Hosts by number. */
    private final List<FrameHost> hosts = new ArrayList<>();
    private final List<Thread> threads = new ArrayList<>();
    private boolean closed;

    private ShotRelighter(int first, int last, ShotListener listener) {
        this.first = first;
        this.last = last;
        this.listener = listener;
        queue = new FrameQueue(first, last);
    }

    /**
     * Creates a relighter without caches. Work begins with the first {@link #setRevision}; the first frame is focused.
     *
     * @param host     closed with this
     * @param listener called on other threads
     * @throws IllegalArgumentException if the last frame is before the first
     */
    public static ShotRelighter of(int first, int last, FrameHost host, ShotListener listener) {
        ShotRelighter relighter = of(first, last, listener);
        relighter.addHost(host);
        return relighter;
    }

    /**
     * Creates a relighter without a host; work begins when one is added.
     *
     * @throws IllegalArgumentException if the last frame is before the first
     */
    public static ShotRelighter of(int first, int last, ShotListener listener) {
        if (last < first) {
            throw new IllegalArgumentException("the last frame must not be before the first, was " + last + " after " + first);
        }
        return new ShotRelighter(first, last, listener);
    }

    /** Adds a host, which is closed with this. Frames stay on their hosts. */
    public void addHost(FrameHost host) {
        if (register(host)) {
            listener.hostAdded();
        }
    }

    private synchronized boolean register(FrameHost host) {
        if (closed) {
            host.close();
            return false;
        }
        int number = queue.addHost();
        hosts.add(host);
        host.focus(queue.focus());
        for (FrameQueue.Lane lane : FrameQueue.Lane.values()) {
            Thread thread = DedicatedThread.create("lightning-shot", new FrameWorker(queue, number, lane, host, listener));
            threads.add(thread);
            thread.start();
        }
        return true;
    }

    /** Removes a host found to be gone outside of an update; its frames are missing, and other hosts trace them. */
    public void removeHost(FrameHost host, HostLostException problem) {
        int number;
        synchronized (this) {
            number = hosts.indexOf(host);
        }
        if (number >= 0 && queue.removeHost(number)) {
            listener.hostLost(problem);
        }
    }

    public int first() {
        return first;
    }

    public int last() {
        return last;
    }

    /** Requests all frames in a revision; returns immediately. */
    public void setRevision(ShotRevision revision) {
        queue.setRevision(revision);
    }

    /** Focuses a frame: it is updated before all others, and its neighbors next. Clamped to the shot. */
    public void focus(int frame) {
        queue.focus(frame);
        hosts().forEach(host -> host.focus(queue.focus()));
    }

    /**
     * Returns the state of a frame.
     *
     * @throws IndexOutOfBoundsException if the shot has no such frame
     */
    public FrameState state(int frame) {
        return queue.state(frame);
    }

    /**
     * Returns the newest cached film of a frame; may read from disk, so do not call it on a window's thread.
     *
     * @throws IndexOutOfBoundsException if the shot has no such frame
     */
    public Optional<Film> film(int frame) {
        return hostOf(frame).flatMap(host -> host.film(frame));
    }

    /** Returns the newest film, downscaled to fit: see {@link FrameHost#film(int, int, int)}. */
    public Optional<Film> film(int frame, int maxWidth, int maxHeight) {
        return hostOf(frame).flatMap(host -> host.film(frame, maxWidth, maxHeight));
    }

    private Optional<FrameHost> hostOf(int frame) {
        int index = queue.hostOf(frame);
        return index < 0 ? Optional.empty() : Optional.of(hosts().get(index));
    }

    /** Returns the cache usage of all hosts. */
    public CacheUsage usage() {
        return hosts().stream().map(FrameHost::usage).reduce(CacheUsage.NONE, CacheUsage::plus);
    }

    /** Returns whether all frames are current or failed. */
    public boolean isIdle() {
        return queue.isIdle();
    }

    /** Waits until idle, or until no host is left. */
    public void awaitIdle() throws InterruptedException {
        queue.awaitIdle();
    }

    private synchronized List<FrameHost> hosts() {
        return List.copyOf(hosts);
    }

    /** Cancels running work, waits for its end and drops all caches. */
    @Override
    public void close() {
        List<Thread> running;
        synchronized (this) {
            closed = true;
            running = List.copyOf(threads);
        }
        queue.close();
        boolean interrupted = false;
        for (Thread thread : running) {
            while (thread.isAlive()) {
                try {
                    thread.join();
                } catch (InterruptedException e) {
                    interrupted = true;
                }
            }
        }
        hosts().forEach(FrameHost::close);
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
