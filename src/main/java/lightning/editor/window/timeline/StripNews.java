package lightning.editor.window.timeline;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import lightning.shot.FrameState;
import lightning.shot.FrameUpdate;
import lightning.shot.KeeperGoneException;
import lightning.shot.RelitShot;
import lightning.shot.ShotListener;
import lightning.shot.Take;

/** What is heard of the frames of a strip, on whatever threads it comes. */
final class StripNews implements ShotListener {
    /** By frame, how many films it has had. */
    private final Map<Integer, Long> films = new HashMap<>();
    private final Map<Integer, String> problems = new HashMap<>();
    /** Frames whose film of the newest edit was not heard of. */
    private final Set<Integer> awaited = new HashSet<>();
    private RelitShot shot;
    private Runnable heard = () -> {};
    private Consumer<String> sentences = _ -> {};
    /** What was to be told before anybody followed. */
    private Optional<String> early = Optional.empty();
    private boolean lost;

    /**
     * @param of        the shot whose news these are
     * @param then      called after news
     * @param sentence  gets what else is to be told
     */
    synchronized void follow(RelitShot of, Runnable then, Consumer<String> sentence) {
        shot = of;
        heard = then;
        sentences = sentence;
        early.ifPresent(sentence);
    }

    /** Wants all frames to show a take. */
    synchronized void edit(Take take) {
        for (int frame = shot.first(); frame <= shot.last(); frame++) {
            awaited.add(frame);
        }
        problems.clear();
        shot.edit(take);
    }

    @Override
    public void updated(FrameUpdate update, FrameState state) {
        synchronized (this) {
            films.merge(update.frame(), 1L, Long::sum);
            // A newer edit may have come since the state was seen.
            if (shot != null && shot.state(update.frame()) == FrameState.CURRENT) {
                awaited.remove(update.frame());
            }
        }
        tell();
    }

    @Override
    public void failed(int frame, Throwable problem) {
        synchronized (this) {
            problems.put(frame, String.valueOf(problem.getMessage()));
        }
        tell();
    }

    @Override
    public void joined() {
        tell();
    }

    @Override
    public void gone(KeeperGoneException problem) {
        synchronized (this) {
            // Others may have traced its frames before this is heard.
            lost = shot == null || !shot.isIdle();
        }
        tell();
    }

    @Override
    public void idle() {
        synchronized (this) {
            lost = false;
        }
        tell();
    }

    /** A sentence for the artist. */
    void said(String sentence) {
        Consumer<String> to;
        synchronized (this) {
            early = Optional.of(sentence);
            to = sentences;
        }
        to.accept(sentence);
    }

    private void tell() {
        Runnable then;
        synchronized (this) {
            then = heard;
        }
        then.run();
    }

    /** How many films a frame has had. */
    synchronized long films(int frame) {
        return films.getOrDefault(frame, 0L);
    }

    /** Whether the film of a frame is that of the newest edit. */
    synchronized boolean isCurrent(int frame) {
        return !awaited.contains(frame) && shot.state(frame) == FrameState.CURRENT;
    }

    /** Why a frame cannot show the newest edit. */
    synchronized Optional<String> problem(int frame) {
        return Optional.ofNullable(problems.get(frame));
    }

    /** Whether a machine was lost whose frames are not all there again. */
    synchronized boolean hasLost() {
        return lost;
    }
}
