package lightning.editor.window.timeline;

import static java.util.Objects.requireNonNull;

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
import org.jspecify.annotations.Nullable;

/** Thread-safe status of a film strip's frames, from the events of a shot. */
final class FilmStripStatus implements ShotListener {
    /** For each frame, the number of films received. */
    private final Map<Integer, Long> versions = new HashMap<>();
    private final Map<Integer, String> problems = new HashMap<>();
    /** Frames without a film of the newest edit. */
    private final Set<Integer> pendingFrames = new HashSet<>();
    private @Nullable ShotRelighter shot;
    private Runnable listener = () -> {};
    private Consumer<String> messageReceiver = _ -> {};
    /** Message that arrived before {@link #connect}. */
    private Optional<String> firstMessage = Optional.empty();
    private boolean hasLostMachine;

    /**
     * Starts to forward events.
     *
     * @param newShot shot whose events these are
     * @param onUpdate called after each event
     * @param onMessage receives other messages
     */
    synchronized void connect(ShotRelighter newShot, Runnable onUpdate, Consumer<String> onMessage) {
        shot = newShot;
        listener = onUpdate;
        messageReceiver = onMessage;
        firstMessage.ifPresent(onMessage);
    }

    /** Requests all frames of a new revision. */
    synchronized void edit(ShotRevision take) {
        for (int frame = connectedShot().first(); frame <= connectedShot().last(); frame++) {
            pendingFrames.add(frame);
        }
        problems.clear();
        connectedShot().setRevision(take);
    }

    @Override
    public void frameUpdated(FrameUpdate update, FrameState state) {
        synchronized (this) {
            versions.merge(update.frame(), 1L, Long::sum);
            // A newer edit may have arrived after the host computed this state.
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
            // Other nodes may have rendered its frames before this event arrives.
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

    /** Reports a message to the user. */
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

    /** Returns the number of films that a frame has received. */
    synchronized long version(int frame) {
        return versions.getOrDefault(frame, 0L);
    }

    /** Returns whether the film of a frame shows the newest edit. */
    synchronized boolean isCurrent(int frame) {
        return !pendingFrames.contains(frame) && connectedShot().state(frame) == FrameState.CURRENT;
    }

    /** Returns the reason why a frame cannot show the newest edit; empty if there is none. */
    synchronized Optional<String> problem(int frame) {
        return Optional.ofNullable(problems.get(frame));
    }

    /** Returns whether a machine was lost and its frames have not all been rendered again. */
    synchronized boolean hasLostMachine() {
        return hasLostMachine;
    }

    /** Returns the shot, which is connected before its first edit. */
    private ShotRelighter connectedShot() {
        return requireNonNull(shot);
    }
}
