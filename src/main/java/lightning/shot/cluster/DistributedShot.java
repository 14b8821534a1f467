package lightning.shot.cluster;

import java.nio.file.Path;
import java.util.function.Consumer;
import lightning.base.text.Release;
import lightning.shot.RelitShot;
import lightning.shot.ShotListener;

/** The frames of a shot, held by the nodes of a cluster. */
public final class DistributedShot implements AutoCloseable {
    private final RelitShot frames;
    private final Machines machines;

    private DistributedShot(RelitShot frames, Machines machines) {
        this.frames = frames;
        this.machines = machines;
    }

    /**
     * Takes part in a cluster; nodes are found beside, and work begins with the first edit of the frames. May take seconds.
     *
     * @param folder   the folder that holds the scene file, for files that it names
     * @param listener hears of frames, on other threads
     * @param log      gets a sentence at times, on other threads
     * @throws JoinException if this process cannot take part, as without a certificate
     */
    public static DistributedShot join(Place place, Path folder, int first, int last, ShotListener listener, Consumer<String> log)
            throws JoinException {
        RelitShot frames = RelitShot.of(first, last, listener);
        var shot = new DistributedShot(frames, new Machines(new TlsNetwork(place), Release.ofMachine(), folder, frames, log));
        try {
            shot.machines.start();
        } catch (JoinException e) {
            shot.close();
            throw e;
        }
        return shot;
    }

    public RelitShot frames() {
        return frames;
    }

    /** How many nodes hold frames, or would. */
    public int machines() {
        return machines.count();
    }

    /** Leaves: nodes drop the frames. Waits for what is under way here. */
    @Override
    public void close() {
        machines.close();
        frames.close();
    }
}
