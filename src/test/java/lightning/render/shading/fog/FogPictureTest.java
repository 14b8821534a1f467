package lightning.render.shading.fog;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import lightning.base.work.Progress;
import lightning.base.work.WorkerPool;
import lightning.format.jen.JenException;
import lightning.format.jen.JenReader;
import lightning.render.fulltrace.TraditionalTracer;
import lightning.render.image.Film;
import org.junit.jupiter.api.Test;

/** Tests pictures of fog against closed forms. */
class FogPictureTest {
    private static Film render(String world, String rest) throws JenException {
        String scene =
                "jen 1 picture { size 33 33 antialias off } camera { from 0 0 0 to 0 0 -1 up 0 1 0 fov 20 } world { ambience 0 " + world
                        + " } " + rest;
        try (WorkerPool workers = new WorkerPool(1)) {
            return new TraditionalTracer(JenReader.read(scene, "fog.jen", Path.of("")).scene()).trace(workers, Progress.NONE).film();
        }
    }

    @Test
    void background_isDimmedByBox() throws JenException {
        Film film = render("background 1 2 3 fog 0.5 fog_center 0 0 -5 fog_size 100 100 2", "");
        assertThat(film.green(16, 16)).isCloseTo((float) (2 * Math.exp(-1)), within(2e-3f));
    }

    @Test
    void background_vanishesInFogWithoutEnd() throws JenException {
        assertThat(render("background 1 2 3 fog 0.5", "").blue(16, 16)).isZero();
    }

    @Test
    void ambientLight_fillsFog() throws JenException {
        Film film = render("fog 0.5 fog_color 1 0.5 0 fog_ambient 2 2 2", "");
        assertThat(film.red(16, 16)).isEqualTo(2);
        assertThat(film.green(16, 16)).isEqualTo(1);
        assertThat(film.blue(16, 16)).isZero();
    }

    /** A directional light in even fog: every point scatters π·w·p = w/4, and what is lost on the way to the eye adds up to 1. */
    @Test
    void directionalLight_makesEvenFogAQuarterAsBright() throws JenException {
        Film film = render("fog 0.5 fog_color 1 0.5 0.25", "light sun directional { direction 1 -1 0 intensity 2 }");
        assertThat(film.red(16, 16)).isCloseTo(0.5f, within(1e-6f));
        assertThat(film.green(3, 28)).isCloseTo(0.25f, within(1e-6f));
    }

    @Test
    void forwardScattering_isBrighterTowardLight() throws JenException {
        String sun = "light sun directional { direction 0 0 1 }";
        double g = 0.6;
        // π·p(0) and π·p(π).
        assertThat(render("fog 0.5 fog_anisotropy 0.6", sun).red(16, 16))
                .as("the peak is spread over the filter of the grid")
                .isCloseTo((float) (0.25 * (1 - g * g) / Math.pow(1 - g, 3)), within(0.05f));
        assertThat(render("fog 0.5 fog_anisotropy 0.6", sun.replace("0 0 1", "0 0 -1")).red(16, 16))
                .isCloseTo((float) (0.25 * (1 - g * g) / Math.pow(1 + g, 3)), within(0.001f));
    }

    /**
     * A lamp with inverse-square falloff beside the ray through thin fog: the integral of 1/4·σ/(D² + x²) over the whole ray is
     * σ/(4D)·(π/2 + atan(z/D)), apart from what the fog absorbs.
     */
    @Test
    void lamp_lightsThinFogByAngle() throws JenException {
        Film film = render("fog 1e-4", "light lamp point { at 2 0 -3 falloff inverse_square intensity 1000 }");
        double expected = 1000 * 1e-4 / (4 * 2) * (Math.PI / 2 + Math.atan(1.5));
        assertThat(film.red(16, 16)).isCloseTo((float) expected, within((float) (0.01 * expected)));
    }

    @Test
    void surface_isDimmedOnBothWays() throws JenException {
        String wall = "material m { diffuse 1 1 1 } plane wall { material m at 0 0 -2 rotate 90 0 0 scale 50 1 50 } "
                + "light lamp point { at 0 0 0 casts_shadows no fog 0 }";
        assertThat(render("fog 0.5", wall).red(16, 16)).isCloseTo((float) Math.exp(-2), within(2e-3f));
    }
}
