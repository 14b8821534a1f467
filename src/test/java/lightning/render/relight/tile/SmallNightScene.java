package lightning.render.relight.tile;

import java.nio.file.Path;
import lightning.format.jen.JenReader;
import lightning.sample.IndirectScenes;
import lightning.scene.Scene;

/** Scene of thirty lights over few pixels, for repeated traces. */
public final class SmallNightScene {
    public static final Scene SCENE = read();

    private SmallNightScene() {}

    private static Scene read() {
        try {
            Scene scene = IndirectScenes.withoutEdges(IndirectScenes.without(JenReader.read(Path.of("scenes/night.jen")).scene()));
            return scene.withPicture(scene.picture().withSize(40, 34));
        } catch (Exception e) {
            throw new IllegalStateException(e);
        }
    }
}
