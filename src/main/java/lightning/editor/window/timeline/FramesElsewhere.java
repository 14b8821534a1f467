package lightning.editor.window.timeline;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import lightning.scene.Scene;
import lightning.scene.shot.Shot;
import lightning.shot.RelitShot;
import lightning.shot.cluster.DistributedShot;
import lightning.shot.cluster.HostPort;
import lightning.shot.cluster.JoinException;
import lightning.shot.cluster.Place;

/**
 * Frames of the picture's full size on other machines.
 *
 * @param asked  what the artist typed for them
 * @param folder the folder of the scene file
 * @param news   hears of the frames
 */
record FramesElsewhere(String asked, Path folder, DistributedShot held, StripNews news) implements StripFrames {
    /**
     * Takes part in a cluster; may take seconds.
     *
     * @param certificate the file that all its machines have
     * @throws JoinException if this machine cannot; a sentence
     */
    static FramesElsewhere join(String asked, List<HostPort> hosts, Path certificate, Path folder, Shot shot) throws JoinException {
        var news = new StripNews();
        return new FramesElsewhere(asked, folder,
                DistributedShot.join(Place.asking(hosts, certificate), folder, shot.first(), shot.last(), news, news::said), news);
    }

    @Override
    public RelitShot shot() {
        return held.frames();
    }

    @Override
    public Scene kept(Scene scene) {
        return scene;
    }

    @Override
    public OptionalInt machines() {
        return OptionalInt.of(held.machines());
    }

    @Override
    public void setUrgent(boolean v) {
        // Others work there.
    }

    @Override
    public void close() {
        held.close();
    }
}
