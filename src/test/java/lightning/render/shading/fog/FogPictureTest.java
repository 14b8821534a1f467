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

    private static final String SUN = "light sun directional { direction 1 -1 0 casts_shadows no } ";
    private static final String MIRROR = "material mirror { diffuse 0 0 0 reflective 1 1 1 } ";
    /** Half of the light of a 128th of all places at a surface 3 units away: by this much, light before it may be off. */
    private static final float CUT = (float) (0.5 * 0.25 * 0.2 * Math.exp(-0.2 * 3) * 16 / 128);

    /** Light that is lost on the way to a mirror comes from the fog before it, and what is seen in it is fog without end. */
    @Test
    void evenFog_isAsBrightInMirror() throws JenException {
        Film film = render("fog 0.2", SUN + MIRROR + "plane wall { material mirror at 0 0 -3 rotate 90 0 0 scale 50 1 50 }");
        assertThat(film.red(16, 16)).isCloseTo(0.25f, within(CUT));
        assertThat(film.red(3, 28)).isCloseTo(0.25f, within(CUT));
    }

    /** Beams are seen along the first mirrored ray only. */
    @Test
    void secondMirror_showsNoLightInFog() throws JenException {
        Film film = render("fog 0.2", SUN + MIRROR + "plane wall { material mirror at 0 0 -3 rotate 90 0 0 scale 50 1 50 } "
                + "plane behind { material mirror at 0 0 2 rotate 90 0 0 scale 50 1 50 }");
        double lastPart = Math.exp(-0.2 * (3 + 5));
        // Places 5 units away are 36 / 16 times as far apart as 3 units away.
        assertThat(film.red(16, 16)).isCloseTo((float) (0.25 * (1 - lastPart)), within(3.25f * CUT));
    }

    /** The integral of {@link #lamp_lightsThinFogByAngle}, over the ray to a mirror at z = −4 and back from there to behind the eye. */
    @Test
    void lampInMirror_lightsThinFogByAngle() throws JenException {
        Film film = render("fog 1e-4", "light lamp point { at 2 0 -3 falloff inverse_square intensity 1000 casts_shadows no } " + MIRROR
                + "plane wall { material mirror at 0 0 -4 rotate 90 0 0 scale 50 1 50 }");
        double before = Math.atan(1.5) + Math.atan(0.5);
        double mirrored = Math.atan(0.5) + Math.PI / 2;
        double expected = 1000 * 1e-4 / (4 * 2) * (before + mirrored);
        assertThat(film.red(16, 16)).isCloseTo((float) expected, within((float) (0.01 * expected)));
    }

    @Test
    void evenFog_isAsBrightThroughGlass() throws JenException {
        String glass = "material glass { diffuse 0 0 0 clear 1 1 1 ior 1 %s } ";
        String pane = "plane pane { material glass at 0 0 -3 rotate 90 0 0 scale 50 1 50 }";
        assertThat(render("fog 0.2", SUN + glass.replace("%s", "thin yes") + pane).red(16, 16)).isCloseTo(0.25f, within(CUT));
        String ball = "sphere ball { material glass at 0 0 -4 scale 1 1 1 }";
        assertThat(render("fog 0.2", SUN + glass.replace("%s", "") + ball).red(16, 16)).as("no fog inside").isCloseTo(0.25f, within(CUT));
    }

    /** A beam across a floor is seen in it where the beam of a lamp as far below the floor would be. */
    @Test
    void beamInMirror_equalsMirroredBeam() throws JenException {
        String lamp = "light lamp spot { at -3 %s -8 direction 1 0 0 angle 10 casts_shadows no }";
        Film mirrored =
                render("fog 0.05", lamp.replace("%s", "0.2") + MIRROR + "plane floor { material mirror at 0 -0.4 0 scale 90 1 90 }");
        Film direct = render("fog 0.05", lamp.replace("%s", "-1"));
        float max = direct.red(16, 28);
        // About fourteen samples of the filter are in the beam: one more or less is that share of its light.
        float one = max / 14;
        // Camera rays of these lines meet the floor before the lamp's own beam. The grid has a ray at each pixel, and its filter blurs by about one.
        for (int y = 22; y < 32; y++) {
            float above = direct.red(16, y - 1);
            float at = direct.red(16, y);
            float below = direct.red(16, y + 1);
            assertThat(mirrored.red(16, y)).as("line %d", y).isBetween(Math.min(above, Math.min(at, below)) - one,
                    Math.max(above, Math.max(at, below)) + one);
        }
        assertThat(max).isGreaterThan(3 * direct.red(16, 22));
    }
}
