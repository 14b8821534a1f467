package lightning.render.shading;

import static java.util.Objects.requireNonNull;

import java.util.Arrays;
import lightning.base.math.Rgb;
import lightning.base.math.Vec3;
import lightning.render.trace.BounceKind;
import lightning.render.trace.CameraRays;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.Dome;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.SceneLimits;
import org.jspecify.annotations.Nullable;

/**
 * Shades rays that hit nothing with the background or the sum of the environments. No row exists for them, so their directions are
 * recomputed with the bits of the original rays.
 */
public final class BackgroundShader {
    private final double pixelAngle;
    private final double[] direction = new double[3];
    private final double[] color = new double[3];

    /** @param scene scene whose camera and size tell how wide pixels are, so how fine the environment is seen */
    public BackgroundShader(Scene scene) {
        pixelAngle = new CameraRays(scene.camera(), scene.picture()).right.length();
    }

    /** Returns the color of a film in a unit direction, {@code float[3]}. */
    public static float[] color(FilmParts parts, int part, Vec3 direction) {
        float[][] to = new float[3][1];
        Background shown = background(parts, part);
        if (shown != null) {
            new BackgroundShader(parts.scene()).shade(shown, direction.x(), direction.y(), direction.z(), to, 0);
        }
        return new float[] {to[0][0], to[1][0], to[2][0]};
    }

    /**
     * Colors of rays that hit nothing in a film.
     *
     * @param color       linear color; unread with an environment
     * @param environment null for none
     * @param intensity   factor of the environment
     */
    private record Background(Rgb color, @Nullable Dome environment, double intensity) {}

    /** Returns whether rays that hit nothing show anything in a film. */
    public boolean showsBackground(FilmParts parts, int part) {
        return background(parts, part) != null;
    }

    /** Returns the background of a film; null if it is black. A sky is looked up, so callers do this once for many rays. */
    private static @Nullable Background background(FilmParts parts, int part) {
        FilmPart its = parts.get(part);
        World world = parts.scene().world();
        return switch (its.kind()) {
            case LIGHT, ENVIRONMENT_LIGHT, AMBIENCE -> null;
            case ENVIRONMENT_IMAGE ->
                    its.isDark() ? null : new Background(Rgb.BLACK, parts.environment(its.index()), its.inside().red());
            case REST -> world.background().isBlack() || parts.showsEnvironment() ? null
                    : new Background(world.background(), null, 0);
        };
    }

    private void shade(Background shown, double x, double y, double z, float[][] to, int i) {
        Dome environment = shown.environment;
        if (environment == null) {
            to[0][i] = (float) shown.color.r();
            to[1][i] = (float) shown.color.g();
            to[2][i] = (float) shown.color.b();
            return;
        }
        EnvironmentMap map = environment.map();
        map.radiance(x, y, z, environment.rotation(), map.detailLevel(pixelAngle), color);
        for (int c = 0; c < 3; c++) {
            to[c][i] = (float) Math.min(color[c] * shown.intensity, SceneLimits.MAX_EMISSION);
        }
    }

    /**
     * Fills the background of a tile's camera rays in a film that shows any: every sample position, or those without a row.
     */
    public void shadeEyeRays(HitRows rows, FilmParts parts, int part, SamplePositions places, float[][] to) {
        Background shown = requireNonNull(background(parts, part));
        if (shown.environment == null) {
            fill(shown.color, to, to[0].length);
            return;
        }
        Scene scene = parts.scene();
        var camera = new CameraRays(scene.camera(), scene.picture());
        boolean[] hit = new boolean[to[0].length];
        for (int i = 0; i < rows.count; i++) {
            hit[rows.parent[i]] = true;
        }
        double[] dx = new double[1];
        double[] dy = new double[1];
        double[] dz = new double[1];
        for (int i = 0; i < to[0].length; i++) {
            if (i < places.count() && !hit[i]) {
                places.writeDirection(camera, i, dx, dy, dz);
                shade(shown, dx[0], dy[0], dz[0], to, i);
            }
        }
    }

    /** Fills the background of the rays that bounce from a level's rows in a film that shows any. */
    public void shadeBounceRays(HitRows above, BounceKind bounce, MaterialTable materials, FilmParts parts, int part, float[][] to) {
        Background shown = requireNonNull(background(parts, part));
        if (shown.environment == null) {
            fill(shown.color, to, bounce.rowCount(above));
            return;
        }
        for (int i = 0; i < bounce.rowCount(above); i++) {
            if (bounce.writeDirection(above, i, materials, direction)) {
                shade(shown, direction[0], direction[1], direction[2], to, i);
            }
        }
    }

    private static void fill(Rgb color, float[][] to, int length) {
        Arrays.fill(to[0], 0, length, (float) color.r());
        Arrays.fill(to[1], 0, length, (float) color.g());
        Arrays.fill(to[2], 0, length, (float) color.b());
    }
}
