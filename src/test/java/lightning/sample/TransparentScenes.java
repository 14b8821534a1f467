package lightning.sample;

import java.nio.file.Path;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Scene;

/** Scenes with a floor seen through a transparent shape, without {@code reflective} materials. */
public final class TransparentScenes {
    /** Glass ball in front of a lit floor. */
    public static final String BALL = """
            jen 1
            picture { size 60 40  depth 3 }
            camera { from 0 1 6  to 0 0 0 }
            material glass { diffuse 0 0 0  clear 1 1 1 }
            sphere drop { material glass  at 0 0 3 }
            plane floor { at 0 -1 0  scale 20 1 20 }
            light lamp point { at 2 3 2 }
            """;
    /** Window pane in front of a lit floor. */
    public static final String PANE = """
            jen 1
            picture { size 60 40  depth 3 }
            camera { from 0 1 6  to 0 0 0 }
            material pane { diffuse 0 0 0  clear 1 1 1  thin yes }
            plane window { material pane  at 0 0 3  rotate 90 0 0  scale 2 1 2 }
            plane floor { at 0 -1 0  scale 20 1 20 }
            light lamp point { at 2 3 2 }
            """;

    private TransparentScenes() {}

    /** Parses the scene of such a text. */
    public static Scene scene(String text) {
        try {
            return JenReader.read(text, "clear.jen", Path.of("")).scene();
        } catch (JenException e) {
            throw new AssertionError(e);
        }
    }
}
