package lightning.shot.cluster;

import java.nio.file.Path;
import java.util.function.Consumer;
import lightning.base.text.ReleaseInfo;
import lightning.shot.ShotListener;
import lightning.shot.ShotRelighter;

/** The frames of a shot, held by the nodes of a cluster. */
public final class DistributedShot implements AutoCloseable {
    private final ShotRelighter relighter;
    private final NodePool nodes;

    private DistributedShot(ShotRelighter frames, NodePool machines) {
        this.relighter = frames;
        this.nodes = machines;
    }

    /**
     * Takes part in a cluster; nodes are found beside, and work begins with the first edit of the frames. May take seconds.
     *
     * @param folder   the folder that holds the scene file, for files that it names
     * @param listener hears of frames, on other threads
     * @param log      gets a sentence at times, on other threads
     * @throws JoinException if this process cannot take part, as without a certificate
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

    /** How many nodes hold frames, or would. */
    public int nodeCount() {
        return nodes.count();
    }

    /** Leaves: nodes drop the frames. Waits for what is under way here. */
    @Override
    public void close() {
        nodes.close();
        relighter.close();
    }
}
