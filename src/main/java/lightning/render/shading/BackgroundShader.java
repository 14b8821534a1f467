package lightning.render.shading;

import java.util.Arrays;
import lightning.base.math.Vec3;
import lightning.render.trace.BounceKind;
import lightning.render.trace.CameraRays;
import lightning.render.trace.HitRows;
import lightning.render.trace.MaterialTable;
import lightning.render.trace.SamplePositions;
import lightning.scene.EnvironmentLayer;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.asset.EnvironmentMap;
import lightning.scene.value.SceneLimits;

/**
 * Shades rays that hit nothing with the background or the sum of the environments. No row exists for them, so their directions are
 * recomputed with the bits of the original rays.
 */
public final class BackgroundShader {
    private final double pixelAngle;
    private final double[] direction = new double[3];
    private final double[] color = new double[3];
    private final double[] sum = new double[3];

    /** @param scene scene whose camera and size tell how wide pixels are, so how fine the environment is seen */
    public BackgroundShader(Scene scene) {
        pixelAngle = new CameraRays(scene.camera(), scene.picture()).right.length();
    }

    /** Returns the color in a unit direction, {@code float[3]}. */
    public static float[] color(Scene scene, Vec3 direction) {
        float[][] to = new float[3][1];
        new BackgroundShader(scene).shade(scene.world(), environments(scene.world()), direction.x(), direction.y(), direction.z(), to, 0);
        return new float[] {to[0][0], to[1][0], to[2][0]};
    }

    /** Returns the environments that are visible. A sky is looked up, so callers do this once for many rays. */
    private static EnvironmentLayer[] environments(World world) {
        return world.environments().stream().filter(EnvironmentLayer::on).toArray(EnvironmentLayer[]::new);
    }

    private void shade(World world, EnvironmentLayer[] environments, double x, double y, double z, float[][] to, int i) {
        if (environments.length == 0) {
            to[0][i] = (float) world.background().r();
            to[1][i] = (float) world.background().g();
            to[2][i] = (float) world.background().b();
            return;
        }
        for (int e = 0; e < environments.length; e++) {
            EnvironmentLayer environment = environments[e];
            EnvironmentMap map = environment.map();
            map.radiance(x, y, z, environment.rotation(), map.detailLevel(pixelAngle), color);
            for (int c = 0; c < 3; c++) {
                double radiance = color[c] * environment.intensity();
                sum[c] = e == 0 ? radiance : sum[c] + radiance;
            }
        }
        for (int c = 0; c < 3; c++) {
            to[c][i] = (float) Math.min(sum[c], SceneLimits.MAX_EMISSION);
        }
    }

    /** Fills the background of a tile's camera rays: every sample position, or those without a row. */
    public void shadeEyeRays(HitRows rows, Scene scene, SamplePositions places, float[][] to) {
        if (rows.count == to[0].length) {
            return;
        }
        World world = scene.world();
        EnvironmentLayer[] environments = environments(world);
        if (environments.length == 0) {
            fill(world, to, to[0].length);
            return;
        }
        var camera = new CameraRays(scene.camera(), scene.picture());
        boolean[] hit = new boolean[to[0].length];
        for (int i = 0; i < rows.count; i++) {
            hit[rows.parent[i]] = true;
        }
        double[] dx = new double[1];
        double[] dy = new double[1];
        double[] dz = new double[1];
        for (int i = 0; i < places.count(); i++) {
            if (!hit[i]) {
                camera.writeDirection(places.x(i), places.y(i), dx, dy, dz, 0);
                shade(world, environments, dx[0], dy[0], dz[0], to, i);
            }
        }
    }

    /** Fills the background of the rays that bounce from a level's rows; rows without such a ray stay undefined. */
    public void shadeBounceRays(HitRows above, BounceKind bounce, MaterialTable materials, World world, float[][] to) {
        EnvironmentLayer[] environments = environments(world);
        if (environments.length == 0) {
            fill(world, to, bounce.rowCount(above));
            return;
        }
        for (int i = 0; i < bounce.rowCount(above); i++) {
            if (bounce.writeDirection(above, i, materials, direction)) {
                shade(world, environments, direction[0], direction[1], direction[2], to, i);
            }
        }
    }

    private static void fill(World world, float[][] to, int length) {
        Arrays.fill(to[0], 0, length, (float) world.background().r());
        Arrays.fill(to[1], 0, length, (float) world.background().g());
        Arrays.fill(to[2], 0, length, (float) world.background().b());
    }
}
