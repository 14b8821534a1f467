package lightning.shot;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import lightning.base.work.OwnThread;
import lightning.render.image.Film;

/**
 * The frames of a shot, each brought to the newest edit: the one in focus first, then its neighbours outwards. An edit replaces the one
 * before; a frame that missed some is brought to the newest at once. All is done on threads of its own, and any thread may call.
 */
public final class RelitShot implements AutoCloseable {
    private final int first;
    private final int last;
    private final FrameQueue queue;
    private final ShotListener listener;
    /** By their numbers. */
    private final List<FrameKeeper> keepers = new ArrayList<>();
    private final List<Thread> threads = new ArrayList<>();
    private boolean closed;

    private RelitShot(int first, int last, ShotListener listener) {
        this.first = first;
        this.last = last;
        this.listener = listener;
        queue = new FrameQueue(first, last);
    }

    /**
     * Frames that nothing is known of; work begins with the first {@link #edit}, and the first frame is in focus.
     *
     * @param keeper   closed with this
     * @param listener hears of frames, on other threads
     * @throws IllegalArgumentException if the last frame is before the first
     */
    public static RelitShot of(int first, int last, FrameKeeper keeper, ShotListener listener) {
        RelitShot shot = of(first, last, listener);
        shot.join(keeper);
        return shot;
    }

    /**
     * The same without a keeper: nothing is done before one joins.
     *
     * @throws IllegalArgumentException if the last frame is before the first
     */
    public static RelitShot of(int first, int last, ShotListener listener) {
        if (last < first) {
            throw new IllegalArgumentException("the last frame must not be before the first, was " + last + " after " + first);
        }
        return new RelitShot(first, last, listener);
    }

    /** Lets another keeper hold some of the frames; it is closed with this. Frames stay with whoever holds them. */
    public void join(FrameKeeper keeper) {
        if (admit(keeper)) {
            listener.joined();
        }
    }

    private synchronized boolean admit(FrameKeeper keeper) {
        if (closed) {
            keeper.close();
            return false;
        }
        int number = queue.join();
        keepers.add(keeper);
        keeper.focus(queue.focus());
        for (FrameQueue.Lane lane : FrameQueue.Lane.values()) {
            Thread thread = OwnThread.of("lightning-shot", new KeeperTurns(queue, number, lane, keeper, listener));
            threads.add(thread);
            thread.start();
        }
        return true;
    }

    /** A keeper is known to be gone, though nobody asked it: the frames that it held are missing, and others trace them. */
    public void leave(FrameKeeper keeper, KeeperGoneException problem) {
        int number;
        synchronized (this) {
            number = keepers.indexOf(keeper);
        }
        if (number >= 0 && queue.leave(number)) {
            listener.gone(problem);
        }
    }

    public int first() {
        return first;
    }

    public int last() {
        return last;
    }

    /** Wants all frames to show a take; returns at once. */
    public void edit(Take take) {
        queue.edit(take);
    }

    /** Wants a frame before all others, and its neighbours next; outside the shot it is the nearest that there is. */
    public void focus(int frame) {
        queue.focus(frame);
        held().forEach(keeper -> keeper.focus(queue.focus()));
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
        return holder(frame).flatMap(keeper -> keeper.film(frame));
    }

    /** The same, made smaller so as to have room: see {@link FrameKeeper#film(int, int, int)}. */
    public Optional<Film> film(int frame, int mostWidth, int mostHeight) {
        return holder(frame).flatMap(keeper -> keeper.film(frame, mostWidth, mostHeight));
    }

    private Optional<FrameKeeper> holder(int frame) {
        int holder = queue.holder(frame);
        return holder < 0 ? Optional.empty() : Optional.of(held().get(holder));
    }

    /** What all keepers keep. */
    public KeptBytes bytes() {
        return held().stream().map(FrameKeeper::bytes).reduce(KeptBytes.NONE, KeptBytes::plus);
    }

    /** Whether all frames are current or failed. */
    public boolean isIdle() {
        return queue.isIdle();
    }

    /** Waits for that, or until nobody is there who could work. */
    public void awaitIdle() throws InterruptedException {
        queue.awaitIdle();
    }

    private synchronized List<FrameKeeper> held() {
        return List.copyOf(keepers);
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
        held().forEach(FrameKeeper::close);
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
