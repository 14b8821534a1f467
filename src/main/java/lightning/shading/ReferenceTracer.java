package lightning.shading;

import lightning.image.Film;
import lightning.math.Rgb;
import lightning.math.Vec3;
import lightning.scene.Scene;
import lightning.trace.Eye;
import lightning.trace.Geometry;
import lightning.trace.MaterialTable;
import lightning.trace.Ray;
import lightning.trace.SurfacePoint;

/**
 * The oracle: traces every pixel from the scene alone, ray by ray, as §2.1 of the paper tells it.
 *
 * <p>It tests each ray against every shape, keeps nothing, and is slow. Every other way to the
 * picture must agree with it in every bit.
 */
public final class ReferenceTracer {
    private final Scene scene;
    private final Geometry geometry;
    private final MaterialTable materials;
    private final Lamp[] lamps;
    private final ReferenceTracer mirrors;

    public ReferenceTracer(Scene scene) {
        this(scene, scene);
    }

    /**
     * A trace of {@code scene} whose mirrors show {@code mirrored}: what a picture with stale reflections
     * must be (paper §4.8). The two may differ in lights, world and materials.
     */
    public ReferenceTracer(Scene scene, Scene mirrored) {
        this.scene = scene;
        mirrors = scene == mirrored ? this : new ReferenceTracer(mirrored);
        geometry = new Geometry(scene);
        materials = geometry.materials();
        lamps = scene.lights().stream().map(light -> Lamp.of(light, scene)).toArray(Lamp[]::new);
    }

    /** The whole picture. */
    public Film trace() {
        int width = scene.picture().width();
        int height = scene.picture().height();
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                float[] color = pixel(x, y);
                System.arraycopy(color, 0, rgb, 3 * (y * width + x), 3);
            }
        }
        return Film.ofScanlines(width, height, rgb);
    }

    /** The linear colour of one pixel, {@code float[3]}. */
    public float[] pixel(int x, int y) {
        return color(new Eye(scene).through(x, y), scene.picture().depth());
    }

    /** The colour that a ray brings; {@code depth} more mirrors may be followed. */
    private float[] color(Ray ray, int depth) {
        int shape = geometry.nearestOfAll(ray);
        if (shape < 0) {
            Rgb background = scene.world().background();
            return new float[] {(float) background.r(), (float) background.g(), (float) background.b()};
        }
        SurfacePoint at = geometry.surface(shape, ray);
        int material = at.material();
        float[] mirrored = {0, 0, 0};
        if (materials.isReflective(material) && depth > 0) {
            mirrored = mirrors.color(at.mirrored(), depth - 1);
        }
        float[] color = new float[3];
        float[] diffuse = new float[lamps.length];
        float[] specular = new float[lamps.length];
        float[][] terms = terms(at);
        for (int c = 0; c < 3; c++) {
            for (int l = 0; l < lamps.length; l++) {
                float weight = weight(lamps[l], c);
                diffuse[l] = LightingEquation.contribution(weight, terms[l][0], terms[l][2]);
                specular[l] = LightingEquation.contribution(weight, terms[l][1], terms[l][2]);
            }
            color[c] = LightingEquation.color(
                    materials.ambient(material, c), (float) scene.world().ambience(),
                    at.diffuse()[c], LightingEquation.sum(diffuse, 0, lamps.length),
                    materials.specular(material, c), LightingEquation.sum(specular, 0, lamps.length),
                    materials.reflective(material, c), mirrored[c]);
        }
        return color;
    }

    /** For each light its cosine, specular term and falloff at a point; all 0 where it does not reach. */
    private float[][] terms(SurfacePoint at) {
        float[][] terms = new float[lamps.length][3];
        for (int l = 0; l < lamps.length; l++) {
            LightingEquation equation = new LightingEquation(lamps[l]);
            equation.at(at.px(), at.py(), at.pz(), at.nx(), at.ny(), at.nz());
            float cosine = equation.cosine(at.nx(), at.ny(), at.nz());
            if (cosine > 0 && equation.insideCone() && isVisible(lamps[l], at)) {
                terms[l][0] = cosine;
                terms[l][1] = equation.specular(at.nx(), at.ny(), at.nz(), at.vx(), at.vy(), at.vz(),
                        materials.shininess(at.material()));
                terms[l][2] = equation.falloff();
            }
        }
        return terms;
    }

    /** Whether nothing stands between a point and a light. */
    private boolean isVisible(Lamp lamp, SurfacePoint at) {
        Vec3 point = new Vec3(at.px(), at.py(), at.pz());
        return lamp.type().hasPosition()
                ? !geometry.blockedByAny(new Ray(point, lamp.source().minus(point)), 1)
                : !geometry.blockedByAny(new Ray(point, lamp.source()), Double.POSITIVE_INFINITY);
    }

    private static float weight(Lamp lamp, int channel) {
        return switch (channel) {
            case 0 -> lamp.red();
            case 1 -> lamp.green();
            default -> lamp.blue();
        };
    }
}
