package lightning.editor.window.timeline;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.HostLostException;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;
import lightning.shot.ShotRevision;

/** What is heard of the frames of a strip, on whatever threads it comes. */
final class FilmStripStatus implements ShotListener {
    /** By frame, how many films it has had. */
    private final Map<Integer, Long> versions = new HashMap<>();
    private final Map<Integer, String> problems = new HashMap<>();
    /** Frames whose film of the newest edit was not heard of. */
    private final Set<Integer> pendingFrames = new HashSet<>();
    private ShotRelighter shot;
    private Runnable listener = () -> {};
    private Consumer<String> messageReceiver = _ -> {};
    /** What was to be told before anybody followed. */
    private Optional<String> firstMessage = Optional.empty();
    private boolean hasLostMachine;

    /**
     * @param newShot        the shot whose news these are
     * @param onUpdate      called after news
     * @param onMessage  gets what else is to be told
     */
    synchronized void connect(ShotRelighter newShot, Runnable onUpdate, Consumer<String> onMessage) {
        shot = newShot;
        listener = onUpdate;
        messageReceiver = onMessage;
        firstMessage.ifPresent(onMessage);
    }

    /** Wants all frames to show a take. */
    synchronized void edit(ShotRevision take) {
        for (int frame = shot.first(); frame <= shot.last(); frame++) {
            pendingFrames.add(frame);
        }
        problems.clear();
        shot.setRevision(take);
    }

    @Override
    public void frameUpdated(FrameUpdate update, FrameState state) {
        synchronized (this) {
            versions.merge(update.frame(), 1L, Long::sum);
            // A newer edit may have come since the state was seen.
            if (shot != null && shot.state(update.frame()) == FrameState.CURRENT) {
                pendingFrames.remove(update.frame());
            }
        }
        notifyListener();
    }

    @Override
    public void frameFailed(int frame, Throwable problem) {
        synchronized (this) {
            problems.put(frame, String.valueOf(problem.getMessage()));
        }
        notifyListener();
    }

    @Override
    public void hostAdded() {
        notifyListener();
    }

    @Override
    public void hostLost(HostLostException problem) {
        synchronized (this) {
            // Others may have traced its frames before this is heard.
            hasLostMachine = shot == null || !shot.isIdle();
        }
        notifyListener();
    }

    @Override
    public void shotIdle() {
        synchronized (this) {
            hasLostMachine = false;
        }
        notifyListener();
    }

    /** A sentence for the artist. */
    void reportMessage(String message) {
        Consumer<String> receiver;
        synchronized (this) {
            firstMessage = Optional.of(message);
            receiver = messageReceiver;
        }
        receiver.accept(message);
    }

    private void notifyListener() {
        Runnable callback;
        synchronized (this) {
            callback = listener;
        }
        callback.run();
    }

    /** How many films a frame has had. */
    synchronized long version(int frame) {
        return versions.getOrDefault(frame, 0L);
    }

    /** Whether the film of a frame is that of the newest edit. */
    synchronized boolean isCurrent(int frame) {
        return !pendingFrames.contains(frame) && shot.state(frame) == FrameState.CURRENT;
    }

    /** Why a frame cannot show the newest edit. */
    synchronized Optional<String> problem(int frame) {
        return Optional.ofNullable(problems.get(frame));
    }

    /** Whether a machine was lost whose frames are not all there again. */
    synchronized boolean hasLostMachine() {
        return hasLostMachine;
    }
}
