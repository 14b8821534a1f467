package lightning.editor.window.timeline;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.shot.ShotRelighter;
import lightning.shot.cluster.DistributedShot;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.JoinException;
import lightning.shot.cluster.NodeConfig;

/**
 * Full-size frames rendered on other machines.
 *
 * @param hosts addresses as the user typed them
 * @param folder folder of the scene file
 * @param status receives the events of the frames
 */
record RemoteFrames(String hosts, Path folder, DistributedShot distributedShot, FilmStripStatus status) implements FilmStripFrames {
    /**
     * Joins a cluster; may take seconds.
     *
     * @param certificate certificate file shared by all machines of the cluster
     * @throws JoinException if this machine cannot join; its message is a sentence
     */
    static RemoteFrames join(String hostsText, List<HostPort> hosts, Path certificate, Path folder, Shot shot) throws JoinException {
        var status = new FilmStripStatus();
        return new RemoteFrames(hostsText, folder,
                DistributedShot.join(NodeConfig.forClient(hosts, certificate), folder, shot.first(), shot.last(), status,
                        status::reportMessage),
                status);
    }

    @Override
    public ShotRelighter shot() {
        return distributedShot.relighter();
    }

    @Override
    public Scene frameScene(Scene scene) {
        return scene;
    }

    @Override
    public OptionalInt machineCount() {
        return OptionalInt.of(distributedShot.nodeCount());
    }

    @Override
    public void setPictureBusy(boolean v) {
        // Remote frames use no processor of this machine, so they never pause.
    }

    @Override
    public void close() {
        distributedShot.close();
    }
}
