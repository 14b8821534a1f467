package lightning.editor.document;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import lightning.base.file.AtomicFile;

/** Default content of a new scene: a ball on a floor and three lights, at screen size and with smooth edges. */
public final class NewScene {
    private static final String TEXT = """
            jen 1

            picture { size 1280 720  depth 2  antialias edges }
            camera  { from 0 2.2 8  to 0 1 0  fov 30 }
            world   { ambience 1  background 0.02 0.025 0.035 }

            material floor { ambient 0.01 0.01 0.01  diffuse 0.45 0.45 0.45 }
            material ball  { ambient 0.01 0.01 0.01  diffuse 0.6 0.6 0.6  specular 0.3 0.3 0.3  shininess 40 }

            plane floor  { material floor  scale 40 1 40 }
            sphere ball  { material ball  at 0 1 0 }

            light key spot   { intensity 1.2  color 1 0.94 0.86  at -3.5 5 4  direction 3.5 -4 -4  angle 28  dropoff 2 }
            light fill point { intensity 0.25  color 0.8 0.9 1  at 4 2.5 4 }
            light rim spot   { intensity 0.8  at 2 4 -4  direction -2 -3 4  angle 30 }
            """;

    private NewScene() {}

    /**
     * Writes the default scene, replacing an existing file.
     *
     * @throws IOException if the file cannot be written
     */
    public static void write(Path file) throws IOException {
        AtomicFile.of(file).write(TEXT.getBytes(StandardCharsets.UTF_8));
    }
}
