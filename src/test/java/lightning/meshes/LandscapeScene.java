package lightning.meshes;

import java.util.Locale;
import java.util.Random;

/** Generator of the landscape scene: places firs on dry ground that is not too steep. */
final class LandscapeScene {
    private static final int FIRS = 230;
    private static final String START = """
            jen 1

            # A mountain lake at dawn: land of %,d triangles and %d firs of one file, %,d triangles in all.
            # Mesh and scene are made by the program lightning.meshes.MeshGenerator.

            picture { size 480 300  depth 2  antialias edges  samples 3 }
            camera  { from 1.5 2.6 17.5  to -0.7 0.85 0  fov 40 }
            world   { ambience 1  background 0.46 0.45 0.55 }

            material rock {
              ambient 0.02 0.024 0.036  diffuse 0.46 0.44 0.32
            }
            material needles {
              ambient 0.006 0.012 0.014  diffuse 0.12 0.24 0.1
              specular 0.04 0.04 0.04  shininess 8
            }
            material water {
              ambient 0.004 0.008 0.014  diffuse 0.03 0.07 0.09
              specular 0.6 0.6 0.6  shininess 200  reflective 0.55 0.57 0.6
            }

            mesh land   { material rock  file "land.ply" }
            plane lake  { material water  scale 40 1 40 }

            # The sun has just risen, at the left, over the hills.
            light sun directional {
              color 1 0.72 0.42  intensity 1.35
              direction 1.1 -0.46 0.12
            }
            # The sky gives blue to the shadows.
            light sky directional {
              color 0.5 0.66 1  intensity 0.32
              direction -0.35 -0.8 -0.5
            }
            # Haze behind the painter.
            light haze directional {
              color 0.8 0.76 0.9  intensity 0.12
              direction 0.1 -0.25 -1
            }
            # Where the clouds have a gap, a beam of it reaches the other shore.
            light gap spot {
              color 1 0.84 0.6  intensity 1.5
              at -14 16 -2  direction 13 -15.5 -2.5
              angle 11  dropoff 12
            }
            # A camp by the water.
            light fire point {
              color 1 0.5 0.16  intensity 2.2
              at %s  attenuation 0.2 0.6 1.2
            }

            # The firs.
            """;

    private LandscapeScene() {}

    static String text() {
        ParametricSurface land = SampleSolids.all().get("land");
        ParametricSurface fir = SampleSolids.all().get("fir");
        var text = new StringBuilder(String.format(Locale.ROOT, START, land.triangles(), FIRS, land.triangles() + FIRS * fir.triangles(),
                place(2.6, Terrain.height(2.6, 8.2) + 0.35, 8.2)));
        var random = new Random(1998);
        for (int planted = 0; planted < FIRS;) {
            double x = 26 * (random.nextDouble() - 0.5);
            double z = 15 - 27 * random.nextDouble();
            double y = Terrain.height(x, z);
            double slope = StrictMath.hypot(Terrain.height(x + 0.2, z) - y, Terrain.height(x, z + 0.2) - y) / 0.2;
            double size = 0.9 + 0.9 * random.nextDouble();
            int turn = random.nextInt(360);
            boolean beforeTheEye = z > 9 && Math.abs(x - 1.5) < 0.42 * (17.5 - z) + 0.3 && Math.abs(x - 1) < 2.6;
            if (y > 0.12 && y < 2.6 && slope < 0.85 && !beforeTheEye) {
                text.append(String.format(Locale.ROOT,
                        "mesh fir_%-3d { material needles  file \"fir.ply\"  at %s  rotate 0 %d 0  scale %.2f %.2f %.2f }%n",
                        ++planted, place(x, y - 0.06, z), turn, size, 1.25 * size, size));
            }
        }
        return text.toString();
    }

    private static String place(double x, double y, double z) {
        return String.format(Locale.ROOT, "%.2f %.2f %.2f", x, y, z);
    }
}
