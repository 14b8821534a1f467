package lightning.shot.cluster;

import java.nio.file.Path;
import java.util.function.Consumer;
import lightning.base.text.ReleaseInfo;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;

/** Shot whose frames are rendered by the nodes of a cluster. */
public final class DistributedShot implements AutoCloseable {
    private final ShotRelighter relighter;
    private final NodePool nodes;

    private DistributedShot(ShotRelighter frames, NodePool machines) {
        this.relighter = frames;
        this.nodes = machines;
    }

    /**
     * Joins a cluster. Finds nodes in the background; work begins with the first revision. May take seconds.
     *
     * @param folder   folder of the scene file, for files that it names
     * @param listener called on other threads
     * @param log      receives messages for the user, on other threads
     * @throws JoinException if this process cannot join, for example without a certificate
     */
    public static DistributedShot join(NodeConfig config, Path folder, int first, int last, ShotListener listener, Consumer<String> log)
            throws JoinException {
        ShotRelighter relighter = ShotRelighter.of(first, last, listener);
        var shot = new DistributedShot(relighter, new NodePool(new TlsNetwork(config), ReleaseInfo.machineText(), folder, relighter, log));
        try {
            shot.nodes.start();
        } catch (JoinException e) {
            shot.close();
            throw e;
        }
        return shot;
    }

    public ShotRelighter relighter() {
        return relighter;
    }

    /** Returns the number of connected nodes. */
    public int nodeCount() {
        return nodes.count();
    }

    /** Leaves the cluster; nodes drop the frames. Waits for running local work. */
    @Override
    public void close() {
        nodes.close();
        relighter.close();
    }
}
