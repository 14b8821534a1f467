package lightning.shot;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.base.work.Progress;

/**
 * Which frame is worked on next, and what work is of no use any more: the frame that is looked at first, then its neighbors outwards,
 * each brought to the newest take at once. Knows no renderer; any thread may call.
 *
 * <p>A keeper has two lanes. Its front lane does nothing but the frame in focus; the other lane's work rests from tile to tile while the
 * front lane has some, so that what it has traced by then is not lost.
 */
final class FrameQueue {
    /** Who does work of a keeper. */
    enum Lane { FOREGROUND, BACKGROUND }

    /** Nobody holds the frame. */
    private static final int NO_HOST = -1;
    /** No take: they are numbered from 1. */
    private static final long NO_REVISION = 0;

    /** Shows a take in a frame. */
    final class Job implements Progress {
        final int host;
        final Lane lane;
        final int frame;
        final ShotRevision revision;
        private final long revisionNumber;
        /** Whether nothing is kept of the frame. */
        private final boolean traced;
        /** The newest take that was looked at, and whether the work serves it. */
        private long checkedRevision;
        private boolean reusable = true;

        private Job(int host, Lane lane, int frame) {
            this.host = host;
            this.lane = lane;
            this.frame = frame;
            revision = newestRevision;
            revisionNumber = newestRevisionNumber;
            checkedRevision = revisionNumber;
            traced = hosts[frame - firstFrame] == NO_HOST;
        }

        @Override
        public void report(int done, int total) {}

        /** Keeps its caller waiting while the front lane works. */
        @Override
        public boolean isCanceled() {
            return shouldStop(this);
        }
    }

    private final int firstFrame;
    /** Of each frame the number of the take that its film shows, likewise of the one that could not be made there. */
    private final long[] shownRevision;
    private final long[] failedRevision;
    private final boolean[] busy;
    private final int[] hosts;
    /** Of each frame the keepers that have no room for it, as far as they were asked since the newest take. */
    private final BitSet[] rejectedBy;
    /** Of each keeper whether it is there, and what its front lane does. */
    private final List<Boolean> present = new ArrayList<>();
    private final List<Job> foreground = new ArrayList<>();
    private ShotRevision newestRevision;
    private long newestRevisionNumber = NO_REVISION;
    private int focus;
    private int activeJobs;
    private boolean closed;

    FrameQueue(int firstFrame, int lastFrame) {
        this.firstFrame = firstFrame;
        int count = lastFrame - firstFrame + 1;
        shownRevision = new long[count];
        failedRevision = new long[count];
        busy = new boolean[count];
        hosts = new int[count];
        Arrays.fill(hosts, NO_HOST);
        rejectedBy = new BitSet[count];
        Arrays.setAll(rejectedBy, _ -> new BitSet());
        focus = firstFrame;
    }

    /** Another keeper works too; returns its number. */
    synchronized int addHost() {
        present.add(true);
        foreground.add(null);
        for (int i = 0; i < failedRevision.length; i++) {
            if (!rejectedBy[i].isEmpty()) {
                // It may have room for what nobody else had room for.
                failedRevision[i] = NO_REVISION;
            }
        }
        notifyAll();
        return present.size() - 1;
    }

    /** A keeper is gone, and with it all frames that it held. Returns whether that was news. */
    synchronized boolean removeHost(int keeper) {
        boolean news = present.set(keeper, false);
        for (int i = 0; i < hosts.length; i++) {
            if (hosts[i] == keeper) {
                hosts[i] = NO_HOST;
                shownRevision[i] = NO_REVISION;
            }
            retryRejected(i);
        }
        notifyAll();
        return news;
    }

    synchronized void setRevision(ShotRevision take) {
        newestRevision = take;
        newestRevisionNumber++;
        for (BitSet keepers : rejectedBy) {
            keepers.clear();
        }
        notifyAll();
    }

    synchronized void focus(int frame) {
        focus = Math.clamp(frame, firstFrame, firstFrame + shownRevision.length - 1);
        notifyAll();
    }

    synchronized int focus() {
        return focus;
    }

    synchronized FrameState state(int frame) {
        int i = frame - firstFrame;
        return newestRevisionNumber != NO_REVISION && failedRevision[i] == newestRevisionNumber ? FrameState.FAILED
                : shownRevision[i] == NO_REVISION ? FrameState.MISSING
                : shownRevision[i] == newestRevisionNumber ? FrameState.CURRENT
                : FrameState.STALE;
    }

    /** Which keeper has a frame's film, or −1. */
    synchronized int hostOf(int frame) {
        return hosts[frame - firstFrame];
    }

    /** Waits for work of a keeper's lane; null when there will be none. */
    synchronized Job nextJob(int keeper, Lane lane) throws InterruptedException {
        while (!closed && present.get(keeper)) {
            int frame = nextFrame(keeper, lane);
            if (frame >= 0) {
                Job work = new Job(keeper, lane, frame);
                busy[frame - firstFrame] = true;
                activeJobs++;
                if (lane == Lane.FOREGROUND) {
                    foreground.set(keeper, work);
                }
                return work;
            }
            wait();
        }
        return null;
    }

    private int nextFrame(int keeper, Lane lane) {
        boolean focused = canStart(focus - firstFrame, keeper);
        if (lane == Lane.FOREGROUND) {
            return focused ? focus : -1;
        }
        if (focused || foreground.get(keeper) != null) {
            return -1;
        }
        for (int distance = 0; distance < shownRevision.length; distance++) {
            // What comes later first, as it is played.
            for (int frame : new int[] {focus + distance, focus - distance}) {
                if (canStart(frame - firstFrame, keeper)) {
                    return frame;
                }
            }
        }
        return -1;
    }

    /** Whether a keeper may begin with a frame: nobody is at it, and nobody else holds what it can be made from. */
    private boolean canStart(int i, int keeper) {
        return isPending(i) && !busy[i] && !rejectedBy[i].get(keeper) && (hosts[i] == keeper || hosts[i] == NO_HOST);
    }

    private boolean isPending(int i) {
        return i >= 0 && i < shownRevision.length && shownRevision[i] != newestRevisionNumber && failedRevision[i] != newestRevisionNumber;
    }

    /** Where whoever was left to be asked is gone, it is for the others to say again that they have no room. */
    private void retryRejected(int i) {
        if (isPending(i) && !busy[i] && isRejectedByAll(i)) {
            rejectedBy[i].clear();
        }
    }

    private boolean isRejectedByAll(int i) {
        for (int keeper = 0; keeper < present.size(); keeper++) {
            if (present.get(keeper) && !rejectedBy[i].get(keeper)) {
                return false;
            }
        }
        return true;
    }

    private synchronized boolean shouldStop(Job work) {
        while (!isObsolete(work) && work.lane == Lane.BACKGROUND && work.frame != focus
                && (foreground.get(work.host) != null || canStart(focus - firstFrame, work.host))) {
            try {
                wait();
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
                return true;
            }
        }
        return isObsolete(work);
    }

    private boolean isObsolete(Job work) {
        if (closed || !present.get(work.host)) {
            return true;
        }
        if (work.lane == Lane.FOREGROUND && work.frame != focus && work.traced) {
            return true;
        }
        if (work.revisionNumber == newestRevisionNumber) {
            return false;
        }
        // What is relit is soon there, and who drags a light sees it move; of what is traced the rays serve the newer take.
        return work.traced ? !isReusable(work) : work.frame != focus;
    }

    private boolean isReusable(Job work) {
        if (work.checkedRevision != newestRevisionNumber) {
            work.checkedRevision = newestRevisionNumber;
            try {
                work.reusable = work.revision.sceneAt(work.frame).hasSameShapes(newestRevision.sceneAt(work.frame));
            } catch (IllegalArgumentException e) {
                // There is no such scene: whoever begins with it says so.
                work.reusable = false;
            }
        }
        return work.reusable;
    }

    /** A frame has its film, which its keeper holds; nobody else begins with it before {@link #finish}. Returns what it is now. */
    synchronized FrameState complete(Job work) {
        int i = work.frame - firstFrame;
        // Of a keeper that left meanwhile the film may be anywhere.
        shownRevision[i] = present.get(work.host) ? work.revisionNumber : NO_REVISION;
        hosts[i] = present.get(work.host) ? work.host : NO_HOST;
        return state(work.frame);
    }

    /** The take of a work cannot be made in its frame. Returns whether that is still of interest. */
    synchronized boolean markFailed(Job work) {
        failedRevision[work.frame - firstFrame] = work.revisionNumber;
        return work.revisionNumber == newestRevisionNumber;
    }

    /**
     * A work's keeper cannot hold the frame, and keeps nothing of it: others are asked. Returns whether there is nobody else, and that is of
     * interest.
     */
    synchronized boolean reject(Job work) {
        int i = work.frame - firstFrame;
        hosts[i] = NO_HOST;
        shownRevision[i] = NO_REVISION;
        if (work.revisionNumber != newestRevisionNumber || !present.get(work.host)) {
            return false;
        }
        rejectedBy[i].set(work.host);
        return isRejectedByAll(i) && markFailed(work);
    }

    /** A work is over, whatever came of it. Returns whether there is nothing left to do. */
    synchronized boolean finish(Job work) {
        busy[work.frame - firstFrame] = false;
        retryRejected(work.frame - firstFrame);
        activeJobs--;
        if (foreground.get(work.host) == work) {
            foreground.set(work.host, null);
        }
        notifyAll();
        return isIdle();
    }

    /** Whether nothing is worked on and every frame is current or failed. */
    synchronized boolean isIdle() {
        if (activeJobs > 0) {
            return false;
        }
        for (int i = 0; i < shownRevision.length; i++) {
            if (isPending(i)) {
                return false;
            }
        }
        return true;
    }

    /** Waits until {@link #isIdle}, or until it is closed or nobody is there to work. */
    synchronized void awaitIdle() throws InterruptedException {
        while (!closed && !isIdle() && present.contains(true)) {
            wait();
        }
    }

    /** Ends all work. */
    synchronized void close() {
        closed = true;
        notifyAll();
    }
}
