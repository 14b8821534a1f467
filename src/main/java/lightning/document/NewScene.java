package lightning.document;

import java.nio.file.Path;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import lightning.base.text.Messages;
import lightning.format.jen.JenDocument;
import lightning.format.jen.JenException;
import lightning.format.jen.JenFile;
import lightning.format.jen.JenReader;

/**
 * New scene without a file: a studio of a cyclorama, three subjects of different surfaces, and soft lights: key, fill, rim
 * and sky.
 */
public final class NewScene {
    private static final String TEXT = """
            jen 1

            picture { size 1280 720  depth 3  antialias edges }
            camera  { from 0 2.3 8.2  to 0 1.15 0  fov 29 }
            world   { ambience 0  background 0.1 0.11 0.13 }

            material paper   { diffuse 0.52 0.51 0.5 }
            material plinth  { diffuse 0.5 0.49 0.48  specular 0.06 0.06 0.06  shininess 30 }
            material clay    { diffuse 0.6 0.2 0.09  specular 0.08 0.07 0.06  shininess 24 }
            material gray    { diffuse 0.36 0.36 0.36 }
            material chrome  { diffuse 0.03 0.03 0.03  specular 0.8 0.8 0.8  shininess 300  reflective 0.85 0.85 0.86 }

            group cyclorama {
              plane floor { material paper  at 0 0 6  scale 40 1 20 }
              plane wall  { material paper  at 0 9.5 -6.5  rotate 90 0 0  scale 40 1 14 }
            COVE
            }

            cylinder plinth  { material plinth  scale 2.3 0.4 1.5 }
            sphere ball      { material clay    at -0.25 1.4 -0.1 }
            sphere mirror    { material chrome  at 1.3 0.9 0.5  scale 0.5 0.5 0.5 }
            sphere gray_ball { material gray    at -1.45 0.75 0.6  scale 0.35 0.35 0.35 }

            light key rect {
              color 1 0.93 0.84  intensity 4.6
              at -4 4.6 3.6  direction 4 -3.4 -3.6
              attenuation 0.2 0 0.1  width 2.2  height 2.2  samples 16
            }
            light fill rect {
              color 0.82 0.9 1  intensity 0.6
              at 5 2.6 3.4  direction -5 -1.4 -3.4
              attenuation 0.2 0 0.1  width 3  height 3  samples 12
            }
            light rim rect {
              intensity 6
              at 2.6 4.2 -3.6  direction -2.6 -3 3.6
              attenuation 0.2 0 0.1  width 2.6  height 0.7  samples 12
            }
            light sky directional { color 0.75 0.86 1  intensity 0.16  direction 0 -1 -0.25  spread 70  samples 16 }
            """;

    /** Radius of the cyclorama's cove between floor and wall, scene units. */
    private static final double COVE_RADIUS = 2.5;
    /** Floor's edge at the cove, scene units. */
    private static final double COVE_Z = -4;
    private static final int COVE_STRIPS = 24;

    private NewScene() {}

    /** Creates a new document at the size of an area. */
    public static OpenDocument create(PictureArea area) {
        return OpenDocument.untitled(placeholder(), read(TEXT.replace("COVE", cove()))).fittedTo(area);
    }

    /** Creates a new document without objects and lights. */
    public static OpenDocument createEmpty() {
        return OpenDocument.untitled(placeholder(), read("jen 1\n"));
    }

    /** Returns the quarter round between floor and wall, as flat strips. */
    private static String cove() {
        double step = 90.0 / COVE_STRIPS;
        double length = 2 * COVE_RADIUS * Math.tan(Math.toRadians(step / 2));
        return IntStream.range(0, COVE_STRIPS).mapToObj(i -> {
            double angle = (i + 0.5) * step;
            double y = COVE_RADIUS * (1 - Math.cos(Math.toRadians(angle)));
            double z = COVE_Z - COVE_RADIUS * Math.sin(Math.toRadians(angle));
            return String.format(Locale.ROOT, "  plane cove_%d { material paper  at 0 %.4f %.4f  rotate %.4f 0 0  scale 40 1 %.4f }", i + 1,
                    y, z,
                    angle, length);
        }).collect(Collectors.joining("\n"));
    }

    private static JenDocument read(String text) {
        try {
            return JenReader.read(text, placeholder().toString(), folder());
        } catch (JenException e) {
            throw new IllegalStateException(e);
        }
    }

    /** Returns the file that names a new scene before it is saved. */
    public static Path placeholder() {
        return folder().resolve(Messages.tr("untitled") + JenFile.EXTENSION);
    }

    /** Returns whether a new scene has this file before it is saved. */
    static boolean isPlaceholder(Path file) {
        return file.equals(placeholder()) && !file.toFile().exists();
    }

    /** Returns the folder to propose for scenes without a file: the user's home. */
    static Path folder() {
        return Path.of(System.getProperty("user.home")).toAbsolutePath();
    }
}
