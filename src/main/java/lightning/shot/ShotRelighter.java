package lightning.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.work.DedicatedThread;
import lightning.render.image.Film;

/**
 * The frames of a shot, each brought to the newest edit: the one in focus first, then its neighbors outwards. An edit replaces the one
 * before; a frame that missed some is brought to the newest at once. All is done on threads of its own, and any thread may call.
 */
public final class ShotRelighter implements AutoCloseable {
    private final int first;
    private final int last;
    private final FrameQueue queue;
    private final ShotListener listener;
    /** By their numbers. */
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
     * Frames that nothing is known of; work begins with the first {@link #setRevision}, and the first frame is in focus.
     *
     * @param host   closed with this
     * @param listener hears of frames, on other threads
     * @throws IllegalArgumentException if the last frame is before the first
     */
    public static ShotRelighter of(int first, int last, FrameHost host, ShotListener listener) {
        ShotRelighter relighter = of(first, last, listener);
        relighter.addHost(host);
        return relighter;
    }

    /**
     * The same without a keeper: nothing is done before one joins.
     *
     * @throws IllegalArgumentException if the last frame is before the first
     */
    public static ShotRelighter of(int first, int last, ShotListener listener) {
        if (last < first) {
            throw new IllegalArgumentException("the last frame must not be before the first, was " + last + " after " + first);
        }
        return new ShotRelighter(first, last, listener);
    }

    /** Lets another keeper hold some of the frames; it is closed with this. Frames stay with whoever holds them. */
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

    /** A keeper is known to be gone, though nobody asked it: the frames that it held are missing, and others trace them. */
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

    /** Wants all frames to show a take; returns at once. */
    public void setRevision(ShotRevision revision) {
        queue.setRevision(revision);
    }

    /** Wants a frame before all others, and its neighbors next; outside the shot it is the nearest that there is. */
    public void focus(int frame) {
        queue.focus(frame);
        hosts().forEach(keeper -> keeper.focus(queue.focus()));
    }

    /**
     * What there is of a frame.
     *
     * @throws IndexOutOfBoundsException if the shot has no such frame
     */
    public FrameState state(int frame) {
        return queue.state(frame);
    }

    /**
     * The newest film of a frame, as far as it is kept; may read it from disk, so not for the thread of a window.
     *
     * @throws IndexOutOfBoundsException if the shot has no such frame
     */
    public Optional<Film> film(int frame) {
        return hostOf(frame).flatMap(keeper -> keeper.film(frame));
    }

    /** The same, made smaller so as to have room: see {@link FrameHost#film(int, int, int)}. */
    public Optional<Film> film(int frame, int maxWidth, int maxHeight) {
        return hostOf(frame).flatMap(keeper -> keeper.film(frame, maxWidth, maxHeight));
    }

    private Optional<FrameHost> hostOf(int frame) {
        int index = queue.hostOf(frame);
        return index < 0 ? Optional.empty() : Optional.of(hosts().get(index));
    }

    /** What all keepers keep. */
    public CacheUsage usage() {
        return hosts().stream().map(FrameHost::usage).reduce(CacheUsage.NONE, CacheUsage::plus);
    }

    /** Whether all frames are current or failed. */
    public boolean isIdle() {
        return queue.isIdle();
    }

    /** Waits for that, or until nobody is there who could work. */
    public void awaitIdle() throws InterruptedException {
        queue.awaitIdle();
    }

    private synchronized List<FrameHost> hosts() {
        return List.copyOf(hosts);
    }

    /** Stops what is under way, waits for its end and drops all that is kept. */
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
