package lightning.render.shading.fog;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.render.fog.FogGrid;
import lightning.render.fog.FogPath;
import lightning.render.fog.FogRay;
import lightning.render.shading.LightSource;
import lightning.render.shading.LightingEquation;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.Light;
import lightning.scene.light.LightType;
import org.junit.jupiter.api.Test;

class ConeRangeTest {
    private static final int RAYS = Integer.getInteger("lightning.rays", 20_000);
    private final Random random = new Random(58);

    private Vec3 direction() {
        return new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).normalized();
    }

    private double logUniform(double low, double high) {
        return Math.pow(10, low + (high - low) * random.nextDouble());
    }

    /** Every sample that the equation finds inside the cone is in the range, and most others are not. */
    @Test
    void samplesInCone_areInRange() {
        int inside = 0;
        int ranged = 0;
        for (int n = 0; n < RAYS; n++) {
            Vec3 eye = direction().times(logUniform(-3, 3));
            Light light =
                    Light.of("l", LightType.SPOT).withPosition(eye.plus(direction().times(logUniform(-3, 3)))).withDirection(direction())
                            .withAngle(Math.min(logUniform(-3, 2), 180));
            Vec3 d = direction();
            var camera = new Camera(eye, eye.plus(direction()), Vec3.Y, 40);
            Scene scene = new Scene(PictureSettings.DEFAULT, camera, World.DEFAULT, List.of(), List.of(), List.of(light));
            LightSource source = LightSource.of(light, scene);
            var grid = new FogGrid(camera, scene.picture());
            var ray = new FogRay();
            ray.ox = grid.eye().x();
            ray.oy = grid.eye().y();
            ray.oz = grid.eye().z();
            ray.dx = d.x();
            ray.dy = d.y();
            ray.dz = d.z();
            var path = new FogPath();
            new FogSamples(grid.scale(), source).aim(path, ray);
            var range = new ConeRange(source);
            range.find(path, ray);
            ranged += Math.max(0, range.to - range.from);
            var equation = new LightingEquation(source);
            for (int k = 0; k < FogGrid.SAMPLES; k++) {
                double t = path.distance(FogGrid.place(k, n % FogGrid.PHASES));
                equation.moveTo((float) (grid.eye().x() + t * d.x()), (float) (grid.eye().y() + t * d.y()),
                        (float) (grid.eye().z() + t * d.z()),
                        0, 0, 1);
                if (equation.insideCone()) {
                    inside++;
                    assertThat(k).as("sample of ray " + n).isBetween(range.from, range.to - 1);
                }
            }
        }
        assertThat(inside).isGreaterThan(RAYS / 2);
        assertThat(ranged).isLessThan(4 * inside + 4 * RAYS);
    }
}
