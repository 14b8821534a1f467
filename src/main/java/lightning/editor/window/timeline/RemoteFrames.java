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
 * Frames of the picture's full size on other machines.
 *
 * @param hosts  what the artist typed for them
 * @param folder the folder of the scene file
 * @param status   hears of the frames
 */
record RemoteFrames(String hosts, Path folder, DistributedShot distributedShot, FilmStripStatus status) implements FilmStripFrames {
    /**
     * Takes part in a cluster; may take seconds.
     *
     * @param certificate the file that all its machines have
     * @throws JoinException if this machine cannot; a sentence
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
        // Others work there.
    }

    @Override
    public void close() {
        distributedShot.close();
    }
}
