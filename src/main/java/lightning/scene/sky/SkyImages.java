package lightning.scene.sky;

import java.lang.ref.SoftReference;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Map.Entry;
import lightning.base.math.Rgb;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.scene.asset.Environment;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.asset.EnvironmentSun;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/** Environments of physical skies; keeps the last ones. */
final class SkyImages {
    private static final int WIDTH = 512;
    private static final int HEIGHT = 256;
    private static final int KEPT = 16;
    /** Name of a sky where that of an image is shown. */
    private static final String NAME = "physical sky";
    private static final Map<Sky, SoftReference<Environment>> IMAGES = new LinkedHashMap<>(KEPT, 0.75f, true) {
        @Override
        protected boolean removeEldestEntry(Entry<Sky, SoftReference<Environment>> eldest) {
            return size() > KEPT;
        }
    };
    private static @Nullable Air air;

    private record Air(double turbidity, Rgb ground, Atmosphere atmosphere, MultipleScattering multiple) {}

    private SkyImages() {}

    static synchronized Environment of(Sky sky) {
        SoftReference<Environment> kept = IMAGES.get(sky);
        Environment known = kept == null ? null : kept.get();
        if (known == null) {
            known = new Environment(NAME, create(sky));
            IMAGES.put(sky, new SoftReference<>(known));
        }
        return known;
    }

    private static EnvironmentMap create(Sky sky) {
        Air used = air(sky.turbidity(), sky.ground());
        var radiance = new SkyRadiance(used.atmosphere, used.multiple, Math.toRadians(sky.elevation()));
        double scale = 1 / sky.unit().nits();
        float[] rgb = new float[3 * WIDTH * HEIGHT];
        double[] color = new double[3];
        for (int row = 0; row < HEIGHT / 2; row++) {
            double sin = StrictMath.cos(Math.PI * (row + 0.5) / HEIGHT);
            for (int column = 0; column < WIDTH; column++) {
                double azimuth = 360.0 * (column + 0.5) / WIDTH - 180 - sky.azimuth();
                radiance.write(sin, Math.toRadians(Math.IEEEremainder(azimuth, 360)), color);
                for (int c = 0; c < 3; c++) {
                    rgb[3 * (row * WIDTH + column) + c] = limited(color[c] * scale);
                }
            }
        }
        Rgb sun = radiance.sun.times(sky.sun());
        Rgb lit = radiance.skylight.plus(sun.times(Math.max(0, Transform.sinDegrees(sky.elevation()))));
        Rgb ground = new Rgb(sky.ground().r() * lit.r(), sky.ground().g() * lit.g(), sky.ground().b() * lit.b()).times(scale / Math.PI);
        for (int i = 3 * WIDTH * HEIGHT / 2; i < rgb.length; i += 3) {
            rgb[i] = limited(ground.r());
            rgb[i + 1] = limited(ground.g());
            rgb[i + 2] = limited(ground.b());
        }
        Vec3 direction = sky.direction();
        return new EnvironmentMap(WIDTH, HEIGHT, rgb, new EnvironmentSun(direction, sun.times(scale), sky.sunRadius()));
    }

    private static float limited(double v) {
        return (float) Math.min(v, SceneLimits.MAX_EMISSION);
    }

    private static Air air(double turbidity, Rgb ground) {
        Air known = air;
        if (known == null || known.turbidity != turbidity || !known.ground.equals(ground)) {
            double[] reflected = new double[SolarSpectrum.BANDS];
            for (int b = 0; b < reflected.length; b++) {
                double wavelength = SolarSpectrum.wavelength(b);
                reflected[b] = wavelength < 500 ? ground.b() : wavelength < 590 ? ground.g() : ground.r();
            }
            var atmosphere = new Atmosphere(turbidity);
            known = new Air(turbidity, ground, atmosphere, new MultipleScattering(atmosphere, reflected));
            air = known;
        }
        return known;
    }
}
