package lightning.shot;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import lightning.base.text.RefusalException;
import lightning.base.work.Progress;
import org.jspecify.annotations.Nullable;

/**
 * Scheduler of frames: the focused frame first, then its neighbors outwards, each updated directly to the newest revision. Cancels work
 * that has become useless. Independent of any renderer; thread-safe.
 *
 * <p>Each host has two lanes. The foreground lane only works on the focused frame. The background lane pauses between tiles while the
 * foreground lane works, so that its traced tiles are not lost.
 */
final class FrameQueue {
    /** Lanes of a host. */
    enum Lane { FOREGROUND, BACKGROUND }

    /** No host has the frame. */
    private static final int NO_HOST = -1;
    /** No revision; revisions are numbered from 1. */
    private static final long NO_REVISION = 0;

    /** Update of a frame to a revision. */
    final class Job implements Progress {
        final int host;
        final Lane lane;
        final int frame;
        final ShotRevision revision;
        private final long revisionNumber;
        /** True if nothing of the frame is cached. */
        private final boolean traced;
        /** Newest revision compared, and whether the work still serves it. */
        private long checkedRevision;
        private boolean reusable = true;

        private Job(int host, Lane lane, int frame) {
            this.host = host;
            this.lane = lane;
            this.frame = frame;
            revision = requireNonNull(newestRevision);
            revisionNumber = newestRevisionNumber;
            checkedRevision = revisionNumber;
            traced = hosts[frame - firstFrame] == NO_HOST;
        }

        @Override
        public void report(int done, int total) {}

        /** Blocks while the foreground lane works. */
        @Override
        public boolean isCanceled() {
            return shouldStop(this);
        }
    }

    private final int firstFrame;
    /** For each frame the number of the revision that its film shows, and of the last one that failed. */
    private final long[] shownRevision;
    private final long[] failedRevision;
    private final boolean[] busy;
    private final int[] hosts;
    /** For each frame the hosts that rejected it since the newest revision. */
    private final BitSet[] rejectedBy;
    /** For each host its presence, and the work of its foreground lane. */
    private final List<Boolean> present = new ArrayList<>();
    private final List<Job> foreground = new ArrayList<>();
    private @Nullable ShotRevision newestRevision;
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

    /** Adds a host; returns its number. */
    synchronized int addHost() {
        present.add(true);
        foreground.add(null);
        for (int i = 0; i < failedRevision.length; i++) {
            if (!rejectedBy[i].isEmpty()) {
                // It may have memory for frames that all others rejected.
                failedRevision[i] = NO_REVISION;
            }
        }
        notifyAll();
        return present.size() - 1;
    }

    /** Removes a host with all its frames. Returns false if it was removed before. */
    synchronized boolean removeHost(int host) {
        boolean wasPresent = present.set(host, false);
        for (int i = 0; i < hosts.length; i++) {
            if (hosts[i] == host) {
                hosts[i] = NO_HOST;
                shownRevision[i] = NO_REVISION;
            }
            retryRejected(i);
        }
        notifyAll();
        return wasPresent;
    }

    synchronized void setRevision(ShotRevision revision) {
        newestRevision = revision;
        newestRevisionNumber++;
        for (BitSet rejected : rejectedBy) {
            rejected.clear();
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

    /** Returns the host of a frame's film, or −1. */
    synchronized int hostOf(int frame) {
        return hosts[frame - firstFrame];
    }

    /** Waits for work for a host's lane; returns null when the queue is closed or the host removed. */
    synchronized @Nullable Job nextJob(int host, Lane lane) throws InterruptedException {
        while (!closed && present.get(host)) {
            int frame = nextFrame(host, lane);
            if (frame >= 0) {
                Job work = new Job(host, lane, frame);
                busy[frame - firstFrame] = true;
                activeJobs++;
                if (lane == Lane.FOREGROUND) {
                    foreground.set(host, work);
                }
                return work;
            }
            wait();
        }
        return null;
    }

    private int nextFrame(int host, Lane lane) {
        boolean focused = canStart(focus - firstFrame, host);
        if (lane == Lane.FOREGROUND) {
            return focused ? focus : -1;
        }
        if (focused || foreground.get(host) != null) {
            return -1;
        }
        for (int distance = 0; distance < shownRevision.length; distance++) {
            // Later frames first, in playback order.
            for (int frame : new int[] {focus + distance, focus - distance}) {
                if (canStart(frame - firstFrame, host)) {
                    return frame;
                }
            }
        }
        return -1;
    }

    /** Returns whether a host may start a frame: no host works on it, and no other host has its cache. */
    private boolean canStart(int i, int host) {
        return isPending(i) && !busy[i] && !rejectedBy[i].get(host) && (hosts[i] == host || hosts[i] == NO_HOST);
    }

    private boolean isPending(int i) {
        return i >= 0 && i < shownRevision.length && shownRevision[i] != newestRevisionNumber && failedRevision[i] != newestRevisionNumber;
    }

    /** If the last host that was not tried is gone, lets the others decide again. */
    private void retryRejected(int i) {
        if (isPending(i) && !busy[i] && isRejectedByAll(i)) {
            rejectedBy[i].clear();
        }
    }

    private boolean isRejectedByAll(int i) {
        for (int host = 0; host < present.size(); host++) {
            if (present.get(host) && !rejectedBy[i].get(host)) {
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
        // A relit frame finishes soon, and a dragged light must appear to move; the rays of a traced frame serve the newer revision.
        return work.traced ? !isReusable(work) : work.frame != focus;
    }

    private boolean isReusable(Job work) {
        if (work.checkedRevision != newestRevisionNumber) {
            work.checkedRevision = newestRevisionNumber;
            try {
                work.reusable = work.revision.sceneAt(work.frame).hasSameShapes(requireNonNull(newestRevision).sceneAt(work.frame));
            } catch (RefusalException e) {
                // The scene is invalid; the next update of the frame reports it.
                work.reusable = false;
            }
        }
        return work.reusable;
    }

    /** Records a frame's film on its host; no other work on the frame starts before {@link #finish}. Returns the frame's new state. */
    synchronized FrameState complete(Job work) {
        int i = work.frame - firstFrame;
        // If the host was removed meanwhile, its film is lost.
        shownRevision[i] = present.get(work.host) ? work.revisionNumber : NO_REVISION;
        hosts[i] = present.get(work.host) ? work.host : NO_HOST;
        return state(work.frame);
    }

    /** Records that a revision cannot be rendered at its frame. Returns whether the revision is still the newest. */
    synchronized boolean markFailed(Job work) {
        failedRevision[work.frame - firstFrame] = work.revisionNumber;
        return work.revisionNumber == newestRevisionNumber;
    }

    /**
     * Records that the host cannot keep the frame, so that others are tried. Returns whether no other host is left and the revision is
     * still the newest.
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

    /** Ends a job, whatever its result. Returns whether no work is left. */
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

    /** Returns whether no job runs and every frame is current or failed. */
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

    /** Waits until {@link #isIdle}, or until the queue is closed or has no hosts. */
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
