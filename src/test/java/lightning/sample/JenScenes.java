package lightning.sample;

import java.nio.file.Path;
import java.util.Optional;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;

/** Scenes written as text, and a sky for them. */
public final class JenScenes {
    private JenScenes() {}

    /** Returns the scene of a file's text, without its first line. */
    public static Scene of(String text) {
        try {
            return JenReader.read("jen 1\n" + text, "test.jen", Path.of("")).scene();
        } catch (JenException e) {
            throw new IllegalArgumentException(e);
        }
    }

    /** Returns a scene below a sky that is brighter above. */
    public static Scene withSky(Scene scene) {
        return scene.withWorld(scene.world().withEnvironment(Optional.of(sky())));
    }

    /** Returns a dome with this sky. */
    public static Dome dome(String name, double intensity) {
        return Dome.of(name).withImage(Optional.of(sky())).withIntensity(intensity);
    }

    /** Returns a sky that is brighter above. */
    public static Environment sky() {
        float[] rgb = new float[3 * 16 * 8];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i / 3 / 16 < 4 ? 0.5f + 0.1f * (i % 3) : 0.2f;
        }
        return new Environment("sky.hdr", new EnvironmentMap(16, 8, rgb));
    }
}
