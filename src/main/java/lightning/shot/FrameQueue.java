package lightning.shot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.base.work.Progress;

/**
 * Which frame is worked on next, and what work is of no use any more: the frame that is looked at first, then its neighbours outwards,
 * each brought to the newest take at once. Knows no renderer; any thread may call.
 *
 * <p>A keeper has two lanes. Its front lane does nothing but the frame in focus; the other lane's work rests from tile to tile while the
 * front lane has some, so that what it has traced by then is not lost.
 */
final class FrameQueue {
    /** Who does work of a keeper. */
    enum Lane { FRONT, OTHERS }

    /** Nobody holds the frame. */
    private static final int NOBODY = -1;
    /** No take: they are numbered from 1. */
    private static final long NONE = 0;

    /** Shows a take in a frame. */
    final class Work implements Progress {
        final int keeper;
        final Lane lane;
        final int frame;
        final Take take;
        private final long number;
        /** Whether nothing is kept of the frame. */
        private final boolean first;
        /** The newest take that was looked at, and whether the work serves it. */
        private long asked;
        private boolean serves = true;

        private Work(int keeper, Lane lane, int frame) {
            this.keeper = keeper;
            this.lane = lane;
            this.frame = frame;
            take = newest;
            number = newestNumber;
            asked = number;
            first = holder[frame - firstFrame] == NOBODY;
        }

        @Override
        public void tiles(int done, int total) {}

        /** Keeps its caller waiting while the front lane works. */
        @Override
        public boolean isCancelled() {
            return shallStop(this);
        }
    }

    private final int firstFrame;
    /** Of each frame the number of the take that its film shows, likewise of the one that could not be made there. */
    private final long[] shown;
    private final long[] failed;
    private final boolean[] busy;
    private final int[] holder;
    /** Of each frame the keepers that have no room for it, as far as they were asked since the newest take. */
    private final BitSet[] refused;
    /** Of each keeper whether it is there, and what its front lane does. */
    private final List<Boolean> there = new ArrayList<>();
    private final List<Work> front = new ArrayList<>();
    private Take newest;
    private long newestNumber = NONE;
    private int focus;
    private int working;
    private boolean closed;

    FrameQueue(int firstFrame, int lastFrame) {
        this.firstFrame = firstFrame;
        int count = lastFrame - firstFrame + 1;
        shown = new long[count];
        failed = new long[count];
        busy = new boolean[count];
        holder = new int[count];
        Arrays.fill(holder, NOBODY);
        refused = new BitSet[count];
        Arrays.setAll(refused, _ -> new BitSet());
        focus = firstFrame;
    }

    /** Another keeper works too; returns its number. */
    synchronized int join() {
        there.add(true);
        front.add(null);
        for (int i = 0; i < failed.length; i++) {
            if (!refused[i].isEmpty()) {
                // It may have room for what nobody else had room for.
                failed[i] = NONE;
            }
        }
        notifyAll();
        return there.size() - 1;
    }

    /** A keeper is gone, and with it all frames that it held. Returns whether that was news. */
    synchronized boolean leave(int keeper) {
        boolean news = there.set(keeper, false);
        for (int i = 0; i < holder.length; i++) {
            if (holder[i] == keeper) {
                holder[i] = NOBODY;
                shown[i] = NONE;
            }
            askAnew(i);
        }
        notifyAll();
        return news;
    }

    synchronized void edit(Take take) {
        newest = take;
        newestNumber++;
        for (BitSet keepers : refused) {
            keepers.clear();
        }
        notifyAll();
    }

    synchronized void focus(int frame) {
        focus = Math.clamp(frame, firstFrame, firstFrame + shown.length - 1);
        notifyAll();
    }

    synchronized int focus() {
        return focus;
    }

    synchronized FrameState state(int frame) {
        int i = frame - firstFrame;
        return newestNumber != NONE && failed[i] == newestNumber ? FrameState.FAILED
                : shown[i] == NONE ? FrameState.MISSING
                : shown[i] == newestNumber ? FrameState.CURRENT
                : FrameState.STALE;
    }

    /** Which keeper has a frame's film, or −1. */
    synchronized int holder(int frame) {
        return holder[frame - firstFrame];
    }

    /** Waits for work of a keeper's lane; null when there will be none. */
    synchronized Work take(int keeper, Lane lane) throws InterruptedException {
        while (!closed && there.get(keeper)) {
            int frame = next(keeper, lane);
            if (frame >= 0) {
                Work work = new Work(keeper, lane, frame);
                busy[frame - firstFrame] = true;
                working++;
                if (lane == Lane.FRONT) {
                    front.set(keeper, work);
                }
                return work;
            }
            wait();
        }
        return null;
    }

    private int next(int keeper, Lane lane) {
        boolean focused = isOpen(focus - firstFrame, keeper);
        if (lane == Lane.FRONT) {
            return focused ? focus : -1;
        }
        if (focused || front.get(keeper) != null) {
            return -1;
        }
        for (int distance = 0; distance < shown.length; distance++) {
            // What comes later first, as it is played.
            for (int frame : new int[] {focus + distance, focus - distance}) {
                if (isOpen(frame - firstFrame, keeper)) {
                    return frame;
                }
            }
        }
        return -1;
    }

    /** Whether a keeper may begin with a frame: nobody is at it, and nobody else holds what it can be made from. */
    private boolean isOpen(int i, int keeper) {
        return isWanted(i) && !busy[i] && !refused[i].get(keeper) && (holder[i] == keeper || holder[i] == NOBODY);
    }

    private boolean isWanted(int i) {
        return i >= 0 && i < shown.length && shown[i] != newestNumber && failed[i] != newestNumber;
    }

    /** Where whoever was left to be asked is gone, it is for the others to say again that they have no room. */
    private void askAnew(int i) {
        if (isWanted(i) && !busy[i] && isRefusedByAll(i)) {
            refused[i].clear();
        }
    }

    private boolean isRefusedByAll(int i) {
        for (int keeper = 0; keeper < there.size(); keeper++) {
            if (there.get(keeper) && !refused[i].get(keeper)) {
                return false;
            }
        }
        return true;
    }

    private synchronized boolean shallStop(Work work) {
        while (!isUseless(work) && work.lane == Lane.OTHERS && work.frame != focus
                && (front.get(work.keeper) != null || isOpen(focus - firstFrame, work.keeper))) {
            try {
                wait();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return true;
            }
        }
        return isUseless(work);
    }

    private boolean isUseless(Work work) {
        if (closed || !there.get(work.keeper)) {
            return true;
        }
        if (work.lane == Lane.FRONT && work.frame != focus && work.first) {
            return true;
        }
        if (work.number == newestNumber) {
            return false;
        }
        // What is relit is soon there, and who drags a light sees it move; of what is traced the rays serve the newer take.
        return work.first ? !serves(work) : work.frame != focus;
    }

    private boolean serves(Work work) {
        if (work.asked != newestNumber) {
            work.asked = newestNumber;
            try {
                work.serves = work.take.at(work.frame).showsSameShapes(newest.at(work.frame));
            } catch (IllegalArgumentException e) {
                // There is no such scene: whoever begins with it says so.
                work.serves = false;
            }
        }
        return work.serves;
    }

    /** A frame has its film, which its keeper holds; nobody else begins with it before {@link #end}. Returns what it is now. */
    synchronized FrameState made(Work work) {
        int i = work.frame - firstFrame;
        // Of a keeper that left meanwhile the film may be anywhere.
        shown[i] = there.get(work.keeper) ? work.number : NONE;
        holder[i] = there.get(work.keeper) ? work.keeper : NOBODY;
        return state(work.frame);
    }

    /** The take of a work cannot be made in its frame. Returns whether that is still of interest. */
    synchronized boolean fail(Work work) {
        failed[work.frame - firstFrame] = work.number;
        return work.number == newestNumber;
    }

    /**
     * A work's keeper cannot hold the frame, and keeps nothing of it: others are asked. Returns whether there is nobody else, and that is of
     * interest.
     */
    synchronized boolean refuse(Work work) {
        int i = work.frame - firstFrame;
        holder[i] = NOBODY;
        shown[i] = NONE;
        if (work.number != newestNumber || !there.get(work.keeper)) {
            return false;
        }
        refused[i].set(work.keeper);
        return isRefusedByAll(i) && fail(work);
    }

    /** A work is over, whatever came of it. Returns whether there is nothing left to do. */
    synchronized boolean end(Work work) {
        busy[work.frame - firstFrame] = false;
        askAnew(work.frame - firstFrame);
        working--;
        if (front.get(work.keeper) == work) {
            front.set(work.keeper, null);
        }
        notifyAll();
        return isIdle();
    }

    /** Whether nothing is worked on and every frame is current or failed. */
    synchronized boolean isIdle() {
        if (working > 0) {
            return false;
        }
        for (int i = 0; i < shown.length; i++) {
            if (isWanted(i)) {
                return false;
            }
        }
        return true;
    }

    /** Waits until {@link #isIdle}, or until it is closed or nobody is there to work. */
    synchronized void awaitIdle() throws InterruptedException {
        while (!closed && !isIdle() && there.contains(true)) {
            wait();
        }
    }

    /** Ends all work. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }
}
